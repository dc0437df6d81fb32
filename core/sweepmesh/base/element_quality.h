// Measures of one element, from its corners alone.
//
// Scaled Jacobian as in Verdict (Knupp et al., "The Verdict geometric quality library",
// SAND2007-1751): at a corner, the determinant of the three edge vectors that leave it, each
// normalised; 1 for the ideal element, <= 0 where the corner is flat or inverted. The value of an
// element is the least of its corners', for a hexahedron also of its centre's, whose vectors are
// the principal axes. An edge of no length makes the value 0. A prism's corners are divided by the
// sine of the ideal polygon's angle.
//
//      h3----h2     A prism here is a polygon `low` and its image `high`, corner over corner, both
//     /|    /|      counterclockwise when seen from above; with four corners it is a hexahedron in
//    h0----h1|      VTK's order (low 0..3, high 0..3), with three a prism (wedge).
//    |l3---|l2      Points may be any type with [] and the vector operations of Eigen's fixed
//    vectors. l0----l1
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Determinant of the three vectors after normalisation, in -1..1; 0 where one has no length.
inline double normalised_determinant(const Point3& a, const Point3& b, const Point3& c) {
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm());
  return lengths > 0.0 ? a.cross(b).dot(c) / lengths : 0.0;
}

/// The three principal axes of a hexahedron (sums of its four edges in each direction).
inline std::array<Point3, 3> principal_axes(const Point3* low, const Point3* high) {
  const Point3 d0 = low[1] - low[0], d1 = low[2] - low[3], d2 = high[1] - high[0],
               d3 = high[2] - high[3];
  const Point3 e0 = low[3] - low[0], e1 = low[2] - low[1], e2 = high[3] - high[0],
               e3 = high[2] - high[1];
  return {d0 + d1 + d2 + d3, e0 + e1 + e2 + e3,
          (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]) + (high[3] - low[3])};
}

/// Scaled Jacobian of the prism over an n-gon, n >= 3; linear in n.
inline double scaled_jacobian(const Point3* low, const Point3* high, int n) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    const int next = i + 1 < n ? i + 1 : 0, last = i > 0 ? i - 1 : n - 1;
    const Point3 up = high[i] - low[i];
    const double below = normalised_determinant(low[next] - low[i], low[last] - low[i], up);
    const double above = normalised_determinant(high[next] - high[i], high[last] - high[i], up);
    least = std::min({least, below, above});
  }
  if (n == 4) {
    const auto axes = principal_axes(low, high);
    return std::min(least, normalised_determinant(axes[0], axes[1], axes[2]));
  }
  const double ideal = std::sin(2.0 * std::numbers::pi / n);
  return std::clamp(least / ideal, -1.0, 1.0);
}

/// Scaled Jacobian of a polygon in space: the least over corners of the sine of the corner's angle,
/// signed by `normal` (need not have unit length), 1 for the regular polygon. Verdict's for n = 3
/// and 4.
inline double polygon_scaled_jacobian(const Point3* p, int n, const Point3& normal) {
  const double length = normal.norm();
  if (!(length > 0.0)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    const Point3 a = p[(i + 1) % n] - p[i], b = p[(i + n - 1) % n] - p[i];
    const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
    least = std::min(least, lengths > 0.0 ? a.cross(b).dot(normal) / (length * lengths) : 0.0);
  }
  return std::clamp(n == 4 ? least : least / std::sin(2.0 * std::numbers::pi / n), -1.0, 1.0);
}

/// The area vector of a polygon: normal to its mean plane, its length the area projected there.
inline Point3 area_vector(const Point3* p, int n) {
  Point3 sum = Point3::Zero();
  for (int i = 1; i + 1 < n; ++i) sum += (p[i] - p[0]).cross(p[i + 1] - p[0]);
  return 0.5 * sum;
}

/// Verdict's value of a quad (normal of the principal axes) and of a triangle (never negative).
inline double scaled_jacobian_of_quad(const Point3* p) {
  return polygon_scaled_jacobian(p, 4, (p[2] - p[0]).cross(p[3] - p[1]));
}
inline double scaled_jacobian_of_triangle(const Point3* p) {
  return polygon_scaled_jacobian(p, 3, area_vector(p, 3));
}

/// Volume of the prism over an n-gon. Exact for the trilinear hexahedron and for bilinear side
/// faces; ends with more than four corners are triangulated from their first corner.
inline double prism_volume(const Point3* low, const Point3* high, int n) {
  const Point3 o = low[0];
  const auto det = [&](const Point3& a, const Point3& b, const Point3& c) {
    return (a - o).cross(b - o).dot(c - o);
  };
  const auto quad = [&](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return 0.5 * (det(a, b, c) + det(a, c, d) + det(a, b, d) + det(b, c, d));
  };
  double six = 0.0;
  for (int i = 0; i < n; ++i) six += quad(low[i], low[(i + 1) % n], high[(i + 1) % n], high[i]);
  if (n == 4) {
    six += quad(low[0], low[3], low[2], low[1]) + quad(high[0], high[1], high[2], high[3]);
  } else {
    for (int i = 1; i + 1 < n; ++i)
      six += det(low[0], low[i + 1], low[i]) + det(high[0], high[i], high[i + 1]);
  }
  return six / 6.0;
}

/// Longest edge over shortest (Verdict's edge ratio), >= 1; infinite where an edge has no length.
inline double edge_ratio(const Point3* low, const Point3* high, int n) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
  const auto add = [&](const Point3& a, const Point3& b) {
    const double l = (a - b).squaredNorm();
    shortest = std::min(shortest, l);
    longest = std::max(longest, l);
  };
  for (int i = 0; i < n; ++i) {
    add(low[i], low[(i + 1) % n]);
    add(high[i], high[(i + 1) % n]);
    add(low[i], high[i]);
  }
  return shortest > 0.0 ? std::sqrt(longest / shortest) : std::numeric_limits<double>::infinity();
}

/// How oblique an element is, 0 (right) to 1 (flat). Hexahedron: Verdict's skew, the greatest
/// |cosine| between two principal axes. Other prisms: sine of the angle between the mean axis and
/// the mean normal of the two ends.
inline double skew(const Point3* low, const Point3* high, int n) {
  if (n == 4) {
    auto axes = principal_axes(low, high);
    for (Point3& a : axes) a.normalize();
    return std::max({std::abs(axes[0].dot(axes[1])), std::abs(axes[1].dot(axes[2])),
                     std::abs(axes[2].dot(axes[0]))});
  }
  Point3 axis = Point3::Zero();
  for (int i = 0; i < n; ++i) axis += high[i] - low[i];
  const Point3 normal = area_vector(low, n) + area_vector(high, n);
  const double lengths = axis.norm() * normal.norm();
  return lengths > 0.0 ? std::min(1.0, axis.cross(normal).norm() / lengths) : 1.0;
}

}  // namespace sweepmesh
