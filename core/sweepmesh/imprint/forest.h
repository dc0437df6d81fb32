// Sets of numbers that are joined step by step (union-find).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace sweepmesh {

/// The lowest number of each set is its root.
class Forest {
 public:
  explicit Forest(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace sweepmesh
