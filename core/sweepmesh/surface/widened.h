// Widens cells that have been squeezed: measures of angles alone do not see thin bands.
//
// A cell of good angles may be as thin as it likes, and whatever raises the worst angles (the
// energy, worst_first.h) makes cells thin beside a hole that moves. Here edges count as well, by
// their length over the one that they should have.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// The wished length of each side of each cell, in the order of PlanarMesh::cell_nodes (side i of a
/// cell begins at its node i), > 0.
using SideLengths = std::vector<double>;

/// Those that the sides have in `mesh` itself, scaled so that areas are as large as at `points`
/// (the same nodes elsewhere): what a map should do to them.
SideLengths lengths_like(const PlanarMesh& mesh, const Metric& metric,
                         const std::vector<Point2>& points, const Metric& there);

/// Those of regular cells as large as the boundary's edges near by.
SideLengths lengths_of_regular(const PlanarMesh& mesh, const Metric& metric);

/// Cells with a side that is shorter than `share` of its wished length, sides on the boundary
/// aside.
std::vector<int> cells_narrower_than(double share, const PlanarMesh& mesh,
                                     const std::vector<Point2>& points, const SideLengths& wished,
                                     const Metric& metric);

/// How nearly sides are as long as wished: the mean over the inner sides of length over wished
/// length, at most 1 each; 1 where there are none.
double evenness(const PlanarMesh& mesh, const std::vector<Point2>& points,
                const SideLengths& wished, const Metric& metric);

struct WidenOptions {
  /// Sides shorter than this part of the wished length are squeezed, 0..1.
  double squeezed = 0.25;
  /// Cells may lose angles down to this scaled Jacobian where all are better, 0..1.
  double good_enough = 0.7;
  int rings = 4;  ///< cells around a squeezed one that move with it, >= 0
};

/// Moves inside nodes near squeezed sides so that the shortest of them grow, by the soft least
/// (soft_least.h) of scaled Jacobians and lengths together. The least scaled Jacobian does not fall
/// below what it was or what is good enough, whichever is less. Points are returned as they are
/// where no side is squeezed, or where the mesh is not valid. Cost: some hundred evaluations of the
/// squeezed neighbourhoods.
std::vector<Point2> widened(const PlanarMesh& mesh, const std::vector<Point2>& points,
                            const SideLengths& wished, const WidenOptions& options,
                            const Metric& metric, const Context& context);

}  // namespace sweepmesh
