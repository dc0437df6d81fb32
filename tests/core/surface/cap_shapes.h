// Plane outlines by family, as boundary loops of mesh edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh::test {

inline constexpr double pi = std::numbers::pi;

inline std::vector<Point2> circle(int n, double radius, const Point2& centre, double phase = 0.0) {
  std::vector<Point2> out;
  for (int i = 0; i < n; ++i) {
    const double a = phase + 2.0 * pi * i / n;
    out.push_back(centre + radius * Point2(std::cos(a), std::sin(a)));
  }
  return out;
}

/// Straight sides, each cut into edges of about `size`.
inline std::vector<Point2> polygon(const std::vector<Point2>& corners, double size) {
  std::vector<Point2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::lround((b - a).norm() / size)));
    for (int k = 0; k < n; ++k) out.push_back(a + (b - a) * k / n);
  }
  return out;
}

inline std::vector<Point2> rectangle(const Point2& low, const Point2& high, double size) {
  return polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, size);
}

inline std::vector<Point2> as_hole(std::vector<Point2> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// Turned and scaled about `centre`, then moved.
inline std::vector<Point2> moved(std::vector<Point2> loop, const Point2& centre, double angle,
                                 double factor, const Point2& shift) {
  for (Point2& p : loop) p = centre + shift + factor * (Eigen::Rotation2Dd(angle) * (p - centre));
  return loop;
}

/// Cuts the first edge in two where the number of edges is odd.
inline PlanarLoops with_even_count(PlanarLoops loops) {
  if (flattened(loops).size() % 2 == 1)
    loops[0].insert(loops[0].begin() + 1, 0.5 * (loops[0][0] + loops[0][1]));
  return loops;
}

struct Outline {
  std::string name;
  PlanarLoops loops;
  double size;
};

inline std::vector<Point2> gear_outline(int n_teeth) {
  std::vector<Point2> out;
  const double step = 2.0 * pi / n_teeth;
  for (int t = 0; t < n_teeth; ++t)
    for (const auto& [radius, share] : std::vector<std::pair<double, double>>{
             {17, 0.0}, {17, 0.25}, {19, 0.32}, {21, 0.42}, {21, 0.58}, {19, 0.68}})
      out.push_back(radius * Point2(std::cos((t + share) * step), std::sin((t + share) * step)));
  return out;
}

inline std::vector<Outline> outlines() {
  PlanarLoops plate = {rectangle({0, 0}, {75, 45}, 3.2)};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j)
      plate.push_back(as_hole(
          circle(10 + 2 * ((i + j) % 3), 4 + 0.7 * ((i + j) % 3), {7.5 + 15 * i, 7.5 + 15 * j})));
  const auto square = rectangle({0, 0}, {60, 60}, 3.8);
  return {{"rectangle", {rectangle({0, 0}, {60, 40}, 3)}, 3},
          {"trapeze", with_even_count({polygon({{0, 0}, {60, 0}, {45, 40}, {10, 40}}, 3)}), 3},
          {"triangle", with_even_count({polygon({{0, 0}, {40, 0}, {18, 33}}, 3)}), 3},
          {"disc", {circle(44, 20, {0, 0})}, 2.9},
          {"coarse disc", {circle(10, 20, {0, 0})}, 12},
          {"ring", {circle(40, 20, {0, 0}), as_hole(circle(40, 12, {0, 0}))}, 2.5},
          {"eccentric ring", {circle(40, 20, {0, 0}), as_hole(circle(24, 9, {4, 2}))}, 3},
          {"ring of odd loops", {circle(41, 20, {0, 0}), as_hole(circle(25, 9, {4, 2}))}, 3},
          {"L", {polygon({{0, 0}, {50, 0}, {50, 15}, {15, 15}, {15, 40}, {0, 40}}, 2.5)}, 2.5},
          {"square with a hole", {square, as_hole(circle(24, 14, {25, 25}))}, 3.8},
          {"slot", with_even_count({square, as_hole(rectangle({20, 28}, {40, 31}, 2))}), 3.8},
          {"gear", with_even_count({gear_outline(20), as_hole(circle(28, 7, {0, 0}))}), 2},
          {"plate with fifteen holes", with_even_count(plate), 3.2}};
}

}  // namespace sweepmesh::test
