// An extrusion between its neighbouring levels: cross-sections and their connected parts.
#pragma once

#include <numeric>
#include <vector>

#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

/// Disjoint sets of 0 .. n - 1.
class Sets {
 public:
  explicit Sets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// What is between two neighbouring levels (layers at which a run begins or ends).
struct Slab {
  int k_low = 0, k_high = 0;
  std::vector<int> part;  ///< per column: connected part of the section, or -1
  /// Per part: its columns that are fixed all the way, on its bounding loops; ascending.
  std::vector<std::vector<int>> loops;

  bool holds(const Extrusion& x, int cell) const {
    return x.cell_k_low[cell] <= k_low && k_high <= x.cell_k_high[cell];
  }
};

/// From the lowest to the highest.
std::vector<Slab> find_slabs(const Extrusion& extrusion, const std::vector<char>& fixed);

}  // namespace sweepmesh
