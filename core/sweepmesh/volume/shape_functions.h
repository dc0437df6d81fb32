// Sides and Jacobians of quadratic serendipity elements (20-node hexahedron, 15-node prism), nodes
// in VTK's order. Source of the shape functions: Zienkiewicz and Taylor, The Finite Element Method,
// vol. 1, ch. 8.
#pragma once

#include <array>
#include <utility>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

inline constexpr std::array<std::pair<int, int>, 12> hexahedron_sides = {{{0, 1},
                                                                          {1, 2},
                                                                          {2, 3},
                                                                          {3, 0},
                                                                          {4, 5},
                                                                          {5, 6},
                                                                          {6, 7},
                                                                          {7, 4},
                                                                          {0, 4},
                                                                          {1, 5},
                                                                          {2, 6},
                                                                          {3, 7}}};
inline constexpr std::array<std::pair<int, int>, 9> prism_sides = {
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

/// Smallest determinant of dx/dxi over the element's nodes and its 2-point Gauss points.
double min_jacobian(const Points& points, const std::array<int, 8>& corners,
                    const std::array<int, 12>& mids);
double min_jacobian(const Points& points, const std::array<int, 6>& corners,
                    const std::array<int, 9>& mids);

}  // namespace sweepmesh
