#include "sweepmesh/surface/delaunay_quads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/surface/quad_cleanup.h"

namespace sweepmesh {
namespace {

using Triangle = std::array<int, 3>;

double mean_edge(const PlanarLoops& loops) {
  double sum = 0.0;
  int n = 0;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i, ++n)
      sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return sum / n;
}

bool is_inside(const PlanarLoops& loops, const Point2& p) {
  bool inside = false;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
  return inside;
}

/// Points of a grid of equilateral triangles inside the loops, well apart from their nodes.
void add_grid(const PlanarLoops& loops, double size, std::vector<Point2>& points) {
  constexpr double least_share = 0.6;  // of the size, to the nearest node
  const std::vector<Point2> boundary = points;
  Eigen::AlignedBox2d box;
  for (const Point2& p : boundary) box.extend(p);
  const double row = std::sqrt(0.75) * size;
  for (int j = 0; box.min().y() + (j + 0.5) * row < box.max().y(); ++j)
    for (int i = 0; box.min().x() + i * size < box.max().x(); ++i) {
      const Point2 p = box.min() + Point2((i + (j % 2 ? 0.75 : 0.25)) * size, (j + 0.5) * row);
      const bool is_free = std::none_of(boundary.begin(), boundary.end(), [&](const Point2& q) {
        return (p - q).norm() < least_share * size;
      });
      if (is_free && is_inside(loops, p)) points.push_back(p);
    }
}

/// The quad of two triangles and how good it is.
struct Pair {
  double quality;
  int first, second;
  std::array<int, 4> quad;
};

std::vector<Pair> pairs_of(const std::vector<Triangle>& triangles,
                           const std::vector<Point2>& points) {
  std::map<std::pair<int, int>, std::pair<int, int>> side;  // its triangle and place there
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      side[{triangles[t][i], triangles[t][(i + 1) % 3]}] = {static_cast<int>(t), i};
  std::vector<Pair> out;
  for (const auto& [ends, here] : side) {
    const auto there = side.find({ends.second, ends.first});
    if (ends.first > ends.second || there == side.end()) continue;
    const int above = triangles[here.first][(here.second + 2) % 3];
    const int below = triangles[there->second.first][(there->second.second + 2) % 3];
    const std::array<int, 4> quad = {ends.first, below, ends.second, above};
    out.push_back({scaled_jacobian(points, quad), here.first, there->second.first, quad});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Pair& a, const Pair& b) { return a.quality > b.quality; });
  return out;
}

}  // namespace

std::optional<PlanarMesh> delaunay_quads(const PlanarLoops& loops, double size) {
  PlanarMesh mesh;
  mesh.points = flattened(loops);
  mesh.n_boundary = mesh.n_nodes();
  std::vector<std::vector<int>> numbers;
  int next = 0;
  for (const auto& loop : loops) {
    numbers.emplace_back(loop.size());
    std::iota(numbers.back().begin(), numbers.back().end(), next);
    next += static_cast<int>(loop.size());
  }
  add_grid(loops, std::min(size, mean_edge(loops)), mesh.points);
  const std::vector<Triangle> triangles = constrained_delaunay(mesh.points, numbers);
  std::vector<char> is_used(triangles.size(), false);
  for (const Pair& p : pairs_of(triangles, mesh.points)) {
    if (p.quality <= 0.0 || is_used[p.first] || is_used[p.second]) continue;
    is_used[p.first] = is_used[p.second] = true;
    mesh.add_cell(p.quad);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_used[t]) mesh.add_cell(triangles[t]);
  return with_triangles_paired(mesh);
}

}  // namespace sweepmesh
