#include "sweepmesh/imprint/section_map.h"

#include <algorithm>
#include <cmath>

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
                                   const Context& context) {
  if (loops.empty())
    throw InvalidMeshError("imprint", "The outline of the section is not closed.", {}, {});
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
  for (const auto& triangle : constrained_delaunay(mesh.points, boundary)) mesh.add_cell(triangle);
  const std::vector<Point2> all = map_planar(mesh, images, {}, context).points;
  return {all.begin() + mesh.n_boundary, all.begin() + mesh.n_boundary + points.size()};
}

}  // namespace sweepmesh
