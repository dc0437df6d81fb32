// Carries curves inside a slab's section to R, where the section's outline has another shape.
#pragma once

#include <optional>
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

/// The same where the harmonic map has no folds as it is; empty where it has some. Far cheaper than
/// a search for another map that fails. Throws InvalidMeshError where there are no loops.
std::optional<std::vector<Point2>> carried_harmonically(const std::vector<OutlinePart>& loops,
                                                        const std::vector<Point2>& points,
                                                        double spacing);

/// Images of curves that are to be drawn: the points are no vertices of the triangulation, which
/// is harmonic wherever that has no folds, so smooth curves stay smooth. Points may be anywhere
/// inside. Where no map without folds is found, smaller spacings are tried. Quadratic in points and
/// triangles together.
std::vector<Point2> carried_smoothly(const std::vector<OutlinePart>& loops,
                                     const std::vector<Point2>& points, double spacing,
                                     const Context& context);

/// Whether sides of the loops' images cross each other by more than `tolerance`: then there is no
/// map without folds from them to anywhere, nor from anywhere to them. Cost: n log n for loops
/// whose sides are short.
bool is_crossed(const std::vector<OutlinePart>& loops, double tolerance);

/// Whether a point lies inside the loops.
bool is_inside(const std::vector<OutlinePart>& loops, const Point2& p);

}  // namespace sweepmesh
