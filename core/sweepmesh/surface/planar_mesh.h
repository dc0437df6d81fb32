// A mesh of polygons in the plane: the form in which caps are meshed and mapped.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Closed polylines without the closing point. Loop 0 is the outer one, counterclockwise; the
/// others are holes, clockwise: the domain lies on the left of each.
using PlanarLoops = std::vector<std::vector<Point2>>;

/// Cells are counterclockwise polygons in compressed rows. The first `n_boundary` nodes are those
/// of the loops that the mesh was made for, loop after loop, in their order; the others are inside.
struct PlanarMesh {
  std::vector<Point2> points;
  int n_boundary = 0;
  std::vector<int> cell_offset = {0};
  std::vector<int> cell_nodes;

  int n_nodes() const { return static_cast<int>(points.size()); }
  int n_cells() const { return static_cast<int>(cell_offset.size()) - 1; }
  std::span<const int> cell(int c) const {
    return {cell_nodes.data() + cell_offset[c], cell_nodes.data() + cell_offset[c + 1]};
  }
  void add_cell(std::span<const int> nodes) {
    cell_nodes.insert(cell_nodes.end(), nodes.begin(), nodes.end());
    cell_offset.push_back(static_cast<int>(cell_nodes.size()));
  }
};

/// What a plane point's neighbourhood looks like on the surface it stands for: a matrix S such that
/// a small chart vector d has the length |S d| there. Empty function: the plane itself.
using Metric = std::function<Eigen::Matrix2d(const Point2&)>;

/// At a cell's middle; the identity where there is no metric.
Eigen::Matrix2d metric_at(const Metric& metric, std::span<const Point2> points,
                          std::span<const int> cell);

/// The loops' points in one row, as PlanarMesh keeps them.
std::vector<Point2> flattened(const PlanarLoops& loops);

/// Signed area of a closed polyline, positive when counterclockwise.
double signed_area(std::span<const Point2> loop);

/// Area of the regular polygon with n sides of length 1.
double regular_area(int n);

/// Scaled Jacobian of a cell: the least, over its corners, of the cross product of the two
/// normalised edges that leave the corner, divided by its value in the regular polygon (so a square
/// and an equilateral triangle have 1). Negative where the cell is inverted at a corner. With a
/// metric, lengths and angles are those on the surface, at the cell's centre.
double scaled_jacobian(std::span<const Point2> points, std::span<const int> cell,
                       const Metric& metric = {});

/// The least and the mean scaled Jacobian of all cells (1 and 1 for an empty mesh).
struct PlanarQuality {
  double min = 1.0, mean = 1.0;
  int n_inverted = 0;  ///< cells with a scaled Jacobian <= 0
};
PlanarQuality quality(std::span<const Point2> points, const PlanarMesh& mesh,
                      const Metric& metric = {});

/// Cells that use each node, in compressed rows.
struct NodeCells {
  std::vector<int> offset, cells;
  std::span<const int> of(int node) const {
    return {cells.data() + offset[node], cells.data() + offset[node + 1]};
  }
};
NodeCells cells_at_nodes(const PlanarMesh& mesh);

}  // namespace sweepmesh
