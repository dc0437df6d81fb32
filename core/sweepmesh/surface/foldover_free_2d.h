// Regularised elliptic energy in the plane: untangles inverted elements and improves valid ones.
//
// A map is given by triangles (the corners of quads, or real triangles), each with the shape that
// it should have. With J the Jacobian from that shape to where the triangle is now (seen through
// the surface's metric),
//
//   E = sum of w [ (1 - a) |J|^2 / 2 + a (1 + det(J)^2) / 2 ] / chi(det J),
//   chi(D) = (D + sqrt(eps^2 + D^2)) / 2,
//
// is 1 per triangle where J is a rotation and grows without bound where det J -> 0 once eps -> 0.
// While anything is inverted, eps is in proportion to the worst determinant, which makes E finite
// and pushes that triangle over; eps is then let go. Minimised by Newton's method with each
// triangle's Hessian projected to positive semidefinite, and a line search that never leaves the
// valid set once inside.
//
// Source: V. Garanzha et al., Foldover-free maps in 50 lines of code, ACM Trans. Graph. 40 (2021);
// the elliptic energy is Ivanenko's (1988).
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// A triangle of the map: `node[0]` is the corner, the wished shape has the edges to node[1] and
/// node[2] as columns; `ideal_inverse` is the inverse of that matrix (its determinant must be
/// positive).
struct MapTriangle {
  std::array<int, 3> node;
  Eigen::Matrix2d ideal_inverse = Eigen::Matrix2d::Identity();
  double weight = 1.0;
};

struct FoldoverOptions {
  /// Share of the area term, 0..1: 0 keeps angles only, 1 keeps areas only.
  double area_share = 0.15;
  int max_iterations = 60;  ///< Newton steps, >= 0
  /// Ends when a step lowers the energy by less than this part of it, > 0.
  double tolerance = 1e-4;
};

struct FoldoverResult {
  std::vector<Point2> points;
  bool is_valid = false;  ///< every triangle has a positive determinant
  int iterations = 0;
};

/// Moves the nodes that are not `fixed` (one flag a node). If nothing is inverted at the start,
/// nothing is at the end. Nodes of no triangle stay. Cost: a sparse factorisation of 2 x free nodes
/// a step, some 10 steps from a valid start. Throws Cancelled only; a map that stays inverted is
/// told by `is_valid`.
FoldoverResult minimise_foldover(const std::vector<Point2>& points, const std::vector<char>& fixed,
                                 const std::vector<MapTriangle>& triangles, const Metric& metric,
                                 const FoldoverOptions& options, const Context& context);

/// The corner triangles of a mesh's cells with the shapes of `ideal` (the same cells at other
/// points, seen through `ideal_metric`): what a map that keeps shapes wants. Corners that are flat
/// or inverted in `ideal` get the shape of a regular polygon's corner of the cell's size.
std::vector<MapTriangle> corners_like(const PlanarMesh& mesh, const std::vector<Point2>& ideal,
                                      const Metric& ideal_metric = {});

/// The corner triangles with the shape of regular polygons of the given edge length each.
std::vector<MapTriangle> corners_regular(const PlanarMesh& mesh,
                                         const std::vector<double>& edge_length);

}  // namespace sweepmesh
