#include "sweepmesh/imprint/section_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/surface/cap_map.h"

namespace sweepmesh {
namespace {

/// Points along a loop at most `spacing` apart, the first not repeated, and no two so near to each
/// other, here or in R, that a triangle between them is nothing but rounding.
OutlinePart refined(const OutlinePart& loop, double spacing) {
  constexpr double least_share = 1e-4;  // of the spacing
  const double least = least_share * spacing;
  OutlinePart out;
  const auto is_free = [&](const Point2& from, const Point2& to, std::size_t i) {
    return (from - out.from[i]).norm() > least && (to - out.to[i]).norm() > least;
  };
  for (const PolylinePoint& p : resampled(loop.from, spacing)) {
    const Point2 to = at_position(loop.to, p.position).point;
    if (!out.from.empty() && !is_free(p.point, to, out.from.size() - 1)) continue;
    out.from.push_back(p.point);
    out.to.push_back(to);
  }
  while (out.from.size() > 1 && !is_free(out.from.back(), out.to.back(), 0)) {
    out.from.pop_back();
    out.to.pop_back();
  }
  return out;
}

/// Grid points inside the loops that keep their distance from all other points.
void add_grid(const std::vector<OutlinePart>& loops, double spacing, std::vector<Point2>& points) {
  constexpr double least_share = 0.6;  // of the spacing, to the nearest other point
  Box2 box = box_of(loops.front().from);
  for (const OutlinePart& l : loops) {
    const Box2 b = box_of(l.from);
    box = {box.low.cwiseMin(b.low), box.high.cwiseMax(b.high)};
  }
  const std::vector<Point2> given = points;
  const int nx = static_cast<int>((box.high.x() - box.low.x()) / spacing);
  const int ny = static_cast<int>((box.high.y() - box.low.y()) / spacing);
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j <= ny; ++j) {
      const Point2 p = box.low + spacing * Point2(i + (j % 2 == 0 ? 0.25 : 0.75), j + 0.5);
      const bool is_free = std::none_of(given.begin(), given.end(), [&](const Point2& q) {
        return (p - q).squaredNorm() < least_share * least_share * spacing * spacing;
      });
      if (is_free && is_inside(loops, p)) points.push_back(p);
    }
}

using Triangle = std::array<int, 3>;

/// A triangle with middles of some of its sides as nodes (-1: none; middle i is that of side i,
/// from corner i to the next), as triangles.
std::vector<Triangle> split_at(const Triangle& t, const Triangle& middle) {
  const int n =
      static_cast<int>(std::count_if(middle.begin(), middle.end(), [](int m) { return m >= 0; }));
  if (n == 0) return {t};
  int s = 0;  // the first split side whose next one is not, or any
  while (middle[s] < 0 || (n == 2 && middle[(s + 1) % 3] < 0)) ++s;
  const int a = t[s], b = t[(s + 1) % 3], c = t[(s + 2) % 3];
  const int ab = middle[s], bc = middle[(s + 1) % 3], ca = middle[(s + 2) % 3];
  if (n == 1) return {{a, ab, c}, {ab, b, c}};
  if (n == 2) return {{ab, b, bc}, {a, ab, c}, {ab, bc, c}};
  return {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}};
}

/// Puts a node into the middle of every inner side between two nodes of the boundary: a triangle
/// with all its corners there could not follow a boundary that turns the other way in the image.
std::vector<Triangle> with_chords_split(const std::vector<Triangle>& triangles, int n_boundary,
                                        std::vector<Point2>& points) {
  std::map<std::pair<int, int>, int> uses;
  const auto side = [](const Triangle& t, int i) { return std::minmax(t[i], t[(i + 1) % 3]); };
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) ++uses[side(t, i)];
  std::map<std::pair<int, int>, int> middles;
  for (const auto& [ends, n] : uses)
    if (n == 2 && ends.second < n_boundary) {
      middles[ends] = static_cast<int>(points.size());
      points.push_back(0.5 * (points[ends.first] + points[ends.second]));
    }
  std::vector<Triangle> out;
  for (const Triangle& t : triangles) {
    Triangle middle;
    for (int i = 0; i < 3; ++i) {
      const auto found = middles.find(side(t, i));
      middle[i] = found == middles.end() ? -1 : found->second;
    }
    for (const Triangle& part : split_at(t, middle)) out.push_back(part);
  }
  return out;
}

}  // namespace

std::vector<OutlinePart> joined_loops(const std::vector<OutlinePart>& parts, double tolerance) {
  std::vector<OutlinePart> loops;
  std::vector<char> used(parts.size(), false);
  for (std::size_t first = 0; first < parts.size(); ++first) {
    if (used[first]) continue;
    used[first] = true;
    OutlinePart loop = parts[first];
    while ((loop.from.back() - loop.from.front()).norm() > tolerance) {
      std::size_t next = 0;
      while (next < parts.size() &&
             (used[next] || (parts[next].from.front() - loop.from.back()).norm() > tolerance))
        ++next;
      if (next == parts.size()) return {};
      used[next] = true;
      loop.from.insert(loop.from.end(), parts[next].from.begin() + 1, parts[next].from.end());
      loop.to.insert(loop.to.end(), parts[next].to.begin() + 1, parts[next].to.end());
    }
    loop.from.back() = loop.from.front();
    loop.to.back() = loop.to.front();
    loops.push_back(std::move(loop));
  }
  return loops;
}

bool is_inside(const std::vector<OutlinePart>& loops, const Point2& p) {
  bool inside = false;
  for (const OutlinePart& l : loops)
    for (std::size_t i = 0; i + 1 < l.from.size(); ++i) {
      const Point2 &a = l.from[i], &b = l.from[i + 1];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
  return inside;
}

std::vector<Point2> carried_inside(const std::vector<OutlinePart>& loops,
                                   const std::vector<Point2>& points, double spacing,
                                   Carrying carrying, const Context& context) {
  if (loops.empty())
    throw InvalidMeshError("imprint", "The outline of the section does not close.", {}, {});
  PlanarMesh mesh;
  std::vector<Point2> images;
  std::vector<std::vector<int>> boundary;
  for (const OutlinePart& loop : loops) {
    const OutlinePart fine = refined(loop, spacing);
    boundary.emplace_back();
    for (std::size_t i = 0; i < fine.from.size(); ++i) {
      boundary.back().push_back(mesh.n_nodes());
      mesh.points.push_back(fine.from[i]);
      images.push_back(fine.to[i]);
    }
  }
  mesh.n_boundary = mesh.n_nodes();
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  add_grid(loops, spacing, mesh.points);
  auto triangles = constrained_delaunay(mesh.points, boundary);
  MapOptions options;
  if (carrying == Carrying::smooth) {
    options.poor = -1.0;
    triangles = with_chords_split(triangles, mesh.n_boundary, mesh.points);
  }
  for (const Triangle& t : triangles) mesh.add_cell(t);
  const std::vector<Point2> all = map_planar(mesh, images, options, context).points;
  return {all.begin() + mesh.n_boundary, all.begin() + mesh.n_boundary + points.size()};
}

}  // namespace sweepmesh
