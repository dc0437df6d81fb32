// The topology of a swept mesh: columns of nodes over a base mesh.
//
// A *column* is a base node with a contiguous range of layers k_low..k_high; it owns one node for
// every k of its range. A *run* sweeps one base cell (a polygon of columns) from layer k_low to
// k_high and makes k_high - k_low elements. A one-to-one sweep has one range for all columns and
// runs; a many-to-many sweep has others, and a slot over one spot of the base is two columns there.
//
//      k_high  o-------o          node(c, k) = column_offset[c] + k - k_low[c]
//              |\      |\         cell corners counterclockwise when seen from above (larger k),
//              | o-----|-o        so that (low corners..., high corners...) is the VTK order of a
//      k_low   o-|-----o |        hexahedron, and its Jacobian is positive where k grows along
//               \|      \|        the normal of the counterclockwise cell.
//                o-------o
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"

namespace sweepmesh {

struct Extrusion {
  /// Per column.
  std::vector<int> k_low, k_high;
  /// Per column, and one more: index of the column's first node; the last is the number of nodes.
  std::vector<long> column_offset = {0};

  /// Base cells as polygons in compressed rows: cell c has the columns
  /// cell_columns[cell_offset[c] .. cell_offset[c + 1]).
  std::vector<int> cell_offset = {0};
  std::vector<int> cell_columns;
  /// Per cell: the layers of its run.
  std::vector<int> cell_k_low, cell_k_high;

  int n_columns() const { return static_cast<int>(k_low.size()); }
  int n_cells() const { return static_cast<int>(cell_k_low.size()); }
  long n_nodes() const { return column_offset.back(); }
  long n_elements() const {
    long n = 0;
    for (int c = 0; c < n_cells(); ++c) n += cell_k_high[c] - cell_k_low[c];
    return n;
  }
  long node(int column, int k) const { return column_offset[column] + k - k_low[column]; }
  int cell_size(int cell) const { return cell_offset[cell + 1] - cell_offset[cell]; }

  int add_column(int low, int high) {
    k_low.push_back(low);
    k_high.push_back(high);
    column_offset.push_back(column_offset.back() + high - low + 1);
    return n_columns() - 1;
  }
  void add_cell(const std::vector<int>& columns, int low, int high) {
    cell_columns.insert(cell_columns.end(), columns.begin(), columns.end());
    cell_offset.push_back(static_cast<int>(cell_columns.size()));
    cell_k_low.push_back(low);
    cell_k_high.push_back(high);
  }
};

}  // namespace sweepmesh
