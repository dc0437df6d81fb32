// Numbers of an extrusion's elements (cell by cell, from the lowest layer up), and elements around
// nodes.
#pragma once

#include <algorithm>
#include <vector>

#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

/// Cells around every column, in compressed rows, with the column's corner in each.
struct CellsOfColumns {
  std::vector<int> offset, cell, corner;

  explicit CellsOfColumns(const Extrusion& x)
      : offset(x.n_columns() + 1, 0), cell(x.cell_columns.size()), corner(x.cell_columns.size()) {
    for (const int c : x.cell_columns) ++offset[c + 1];
    for (int c = 0; c < x.n_columns(); ++c) offset[c + 1] += offset[c];
    std::vector<int> next(offset.begin(), offset.end() - 1);
    for (int c = 0; c < x.n_cells(); ++c)
      for (int i = 0; i < x.cell_size(c); ++i) {
        const int slot = next[x.cell_columns[x.cell_offset[c] + i]]++;
        cell[slot] = c;
        corner[slot] = i;
      }
  }
};

/// An element: a cell and the lower level of its layer.
struct SweptElement {
  int cell = -1, k = 0;
};

class ElementIndex {
 public:
  explicit ElementIndex(const Extrusion& extrusion)
      : x_(extrusion), cells_(extrusion), first_(extrusion.n_cells() + 1, 0) {
    for (int c = 0; c < x_.n_cells(); ++c)
      first_[c + 1] = first_[c] + x_.cell_k_high[c] - x_.cell_k_low[c];
  }

  long number_of(SweptElement e) const { return first_[e.cell] + e.k - x_.cell_k_low[e.cell]; }
  SweptElement element(long number) const {
    const auto it = std::upper_bound(first_.begin(), first_.end(), number) - 1;
    const int cell = static_cast<int>(it - first_.begin());
    return {cell, x_.cell_k_low[cell] + static_cast<int>(number - *it)};
  }
  int column_of(long node) const {
    const auto it = std::upper_bound(x_.column_offset.begin(), x_.column_offset.end(), node) - 1;
    return static_cast<int>(it - x_.column_offset.begin());
  }

  /// Calls f(node) for the nodes of an element: the low ring, then the high one.
  template <class F>
  void for_nodes(SweptElement e, F&& f) const {
    for (const int k : {e.k, e.k + 1})
      for (int i = x_.cell_offset[e.cell]; i < x_.cell_offset[e.cell + 1]; ++i)
        f(x_.node(x_.cell_columns[i], k));
  }
  /// Calls f(number) for the elements around a node.
  template <class F>
  void for_elements(long node, F&& f) const {
    const int column = column_of(node);
    const int k = x_.k_low[column] + static_cast<int>(node - x_.column_offset[column]);
    for (int i = cells_.offset[column]; i < cells_.offset[column + 1]; ++i) {
      const int c = cells_.cell[i];
      if (x_.cell_k_low[c] < k && k <= x_.cell_k_high[c]) f(number_of({c, k - 1}));
      if (x_.cell_k_low[c] <= k && k < x_.cell_k_high[c]) f(number_of({c, k}));
    }
  }

 private:
  const Extrusion& x_;
  CellsOfColumns cells_;
  std::vector<long> first_;
};

}  // namespace sweepmesh
