// Sets of numbers that are joined step by step (union-find).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace sweepmesh {

/// Of 0 .. n - 1, each in a set of its own at first. The lowest number of a set is its root, so
/// that the result does not depend on the order of joining.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Shortens the way to it, so that many calls cost hardly more than one each.
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// True if they were not in one set yet.
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace sweepmesh
