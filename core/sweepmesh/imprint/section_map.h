// Carries curves inside a slab's section to R, where the section's outline has another shape.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/polyline.h"

namespace sweepmesh {

/// A part of a section's outline and where it lies in R, the section on the left; point by point.
struct OutlinePart {
  Polyline from, to;
};

/// The outline's parts joined to closed loops, ends nearer than `tolerance` being one point. Empty
/// where an end finds no partner.
std::vector<OutlinePart> joined_loops(const std::vector<OutlinePart>& parts, double tolerance);

/// Images in R of points inside the section. The section is triangulated with the points as
/// vertices and others about `spacing` apart, and mapped as a cap is (cap_map.h): harmonic, with
/// positive weights, and free of folds. Throws InvalidMeshError where no map without folds is
/// found, or where there are no loops. The points must differ from each other and from the
/// outline's.
std::vector<Point2> carried_inside(const std::vector<OutlinePart>& loops,
                                   const std::vector<Point2>& points, double spacing,
                                   const Context& context);

/// The same for curves that are to be drawn: the points are no vertices of the triangulation, which
/// is harmonic wherever that has no folds, so smooth curves stay smooth. Points may be anywhere
/// inside. Where no map without folds is found, smaller spacings are tried. Quadratic in points and
/// triangles together.
std::vector<Point2> carried_smoothly(const std::vector<OutlinePart>& loops,
                                     const std::vector<Point2>& points, double spacing,
                                     const Context& context);

/// Whether a point lies inside the loops.
bool is_inside(const std::vector<OutlinePart>& loops, const Point2& p);

}  // namespace sweepmesh
