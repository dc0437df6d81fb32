// Constrained Delaunay triangulation of a plane domain that is bounded by closed polylines.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Triangles (counterclockwise, indices into `points`) of the domain between the closed polylines
/// `loops` (indices into `points`, any direction; a point is inside if it lies in an odd number of
/// them). The polylines are edges of the result; no point is added. Points on the inside that no
/// loop uses are vertices too, those outside are left out. Throws InputError when two polylines
/// cross or touch, or two points are equal. Exact predicates; cost O(n log n); the same input gives
/// the same triangles.
std::vector<std::array<int, 3>> constrained_delaunay(const std::vector<Point2>& points,
                                                     const std::vector<std::vector<int>>& loops);

}  // namespace sweepmesh
