#include "sweepmesh/imprint/section_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/surface/cap_map.h"

namespace sweepmesh {
namespace {

/// Points along a loop at most 1 apart, the first not repeated, and no two so near to each other,
/// here or in R, that a triangle between them is nothing but rounding.
OutlinePart refined(const OutlinePart& loop) {
  constexpr double least = 1e-4;
  OutlinePart out;
  const auto is_free = [&](const Point2& from, const Point2& to, std::size_t i) {
    return (from - out.from[i]).norm() > least && (to - out.to[i]).norm() > least;
  };
  for (const PolylinePoint& p : resampled(loop.from, 1.0)) {
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

/// Grid points 1 apart inside the loops that keep their distance from all other points.
void add_grid(const std::vector<OutlinePart>& loops, std::vector<Point2>& points) {
  constexpr double least = 0.6;  // to the nearest other point
  Box2 box = box_of(loops.front().from);
  for (const OutlinePart& l : loops) {
    const Box2 b = box_of(l.from);
    box = {box.low.cwiseMin(b.low), box.high.cwiseMax(b.high)};
  }
  const std::vector<Point2> given = points;
  const int nx = static_cast<int>(box.high.x() - box.low.x());
  const int ny = static_cast<int>(box.high.y() - box.low.y());
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j <= ny; ++j) {
      const Point2 p = box.low + Point2(i + (j % 2 == 0 ? 0.25 : 0.75), j + 0.5);
      const bool is_free = std::none_of(given.begin(), given.end(), [&](const Point2& q) {
        return (p - q).squaredNorm() < least * least;
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
    // A part that is all within the tolerance is no loop: its neighbours join over it.
    if (used[first] || length(parts[first].from) <= tolerance) continue;
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

namespace {

struct Side {
  Point2 start, end;  // that with the smaller x first

  /// Whether both ends of another side lie clearly on different sides of the line of this one.
  bool parts(const Side& other, double tolerance) const {
    const Point2 d = end - start;
    const double a = cross2(d, other.start - start), b = cross2(d, other.end - start);
    const double least = tolerance * d.norm();
    return std::max(a, b) > least && std::min(a, b) < -least;
  }
};

}  // namespace

bool is_crossed(const std::vector<OutlinePart>& loops, double tolerance) {
  std::vector<Side> sides;
  for (const OutlinePart& l : loops)
    for (std::size_t i = 0; i + 1 < l.to.size(); ++i) {
      const Point2 &a = l.to[i], &b = l.to[i + 1];
      sides.push_back(a.x() < b.x() ? Side{a, b} : Side{b, a});
    }
  std::ranges::sort(sides, {}, [](const Side& s) { return s.start.x(); });
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size() && sides[j].start.x() < sides[i].end.x(); ++j)
      if (sides[i].parts(sides[j], tolerance) && sides[j].parts(sides[i], tolerance)) return true;
  return false;
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

namespace {

/// The outline of a section as the boundary of a mesh, and its images.
struct SectionOutline {
  PlanarMesh mesh;
  std::vector<Point2> images;
  std::vector<std::vector<int>> loops;
};

/// Lengths in a section are measured by the spacing, and rounded to far less than that, so that a
/// solid that is turned or scaled is triangulated alike.
constexpr double lattice = 1.0 / (1 << 24);

Polyline in_spacings(Polyline points, double spacing) {
  for (Point2& p : points) p = on_lattice(p / spacing, lattice);
  return points;
}

std::vector<OutlinePart> in_spacings(std::vector<OutlinePart> loops, double spacing) {
  for (OutlinePart& l : loops)
    l = {in_spacings(std::move(l.from), spacing), in_spacings(std::move(l.to), spacing)};
  return loops;
}

/// Lengths in spacings.
SectionOutline outline_of(const std::vector<OutlinePart>& loops) {
  if (loops.empty())
    throw InvalidMeshError("imprint", "The outline of the section does not close.", {}, {});
  SectionOutline out;
  for (const OutlinePart& loop : loops) {
    const OutlinePart fine = refined(loop);
    out.loops.emplace_back();
    for (std::size_t i = 0; i < fine.from.size(); ++i) {
      out.loops.back().push_back(out.mesh.n_nodes());
      out.mesh.points.push_back(fine.from[i]);
      out.images.push_back(fine.to[i]);
    }
  }
  out.mesh.n_boundary = out.mesh.n_nodes();
  return out;
}

/// The image of a point by the triangle that it lies in (or, for rounding, nearly lies in).
Point2 image_in(const PlanarMesh& mesh, const std::vector<Point2>& images, const Point2& p) {
  double best = -std::numeric_limits<double>::infinity();
  Point2 out = p;
  for (int c = 0; c < mesh.n_cells() && best < 0.0; ++c) {
    const auto cell = mesh.cell(c);
    const Point2 &a = mesh.points[cell[0]], &b = mesh.points[cell[1]], &d = mesh.points[cell[2]];
    const double area = cross2(b - a, d - a);
    const Eigen::Vector3d share =
        Eigen::Vector3d(cross2(b - p, d - p), cross2(d - p, a - p), cross2(a - p, b - p)) / area;
    if (share.minCoeff() <= best) continue;
    best = share.minCoeff();
    out = share[0] * images[cell[0]] + share[1] * images[cell[1]] + share[2] * images[cell[2]];
  }
  return out;
}

}  // namespace

namespace {

/// A section triangulated with given points as its first inner nodes.
SectionOutline triangulated(const std::vector<OutlinePart>& loops,
                            const std::vector<Point2>& points, double spacing) {
  const std::vector<OutlinePart> scaled = in_spacings(loops, spacing);
  SectionOutline section = outline_of(scaled);
  PlanarMesh& mesh = section.mesh;
  for (const Point2& p : in_spacings(points, spacing)) mesh.points.push_back(p);
  add_grid(scaled, mesh.points);
  const auto triangles = constrained_delaunay(mesh.points, section.loops);
  for (const Triangle& t : with_chords_split(triangles, mesh.n_boundary, mesh.points))
    mesh.add_cell(t);
  return section;
}

/// Those of the given points, in lengths of the model.
std::vector<Point2> images_of(const std::vector<Point2>& all, const SectionOutline& section,
                              std::size_t n_points, double spacing) {
  const auto first = all.begin() + section.mesh.n_boundary;
  std::vector<Point2> out(first, first + static_cast<std::ptrdiff_t>(n_points));
  for (Point2& p : out) p *= spacing;
  return out;
}

}  // namespace

std::vector<Point2> carried_inside(const std::vector<OutlinePart>& loops,
                                   const std::vector<Point2>& points, double spacing,
                                   const Context& context) {
  const SectionOutline section = triangulated(loops, points, spacing);
  MapOptions options;
  options.poor = 0.0;  // slivers do no harm to what is carried
  options.squeezed = 0.0;
  return images_of(map_planar(section.mesh, section.images, options, context).points, section,
                   points.size(), spacing);
}

std::optional<std::vector<Point2>> carried_harmonically(const std::vector<OutlinePart>& loops,
                                                        const std::vector<Point2>& points,
                                                        double spacing) {
  const SectionOutline section = triangulated(loops, points, spacing);
  const PlanarMesh& mesh = section.mesh;
  const std::vector<Point2> all = harmonic_map(mesh, section.images);
  if (quality(all, mesh).n_inverted > 0) return {};
  return images_of(all, section, points.size(), spacing);
}

namespace {

std::vector<Point2> carried_at(const std::vector<OutlinePart>& loops,
                               const std::vector<Point2>& points, double spacing,
                               const Context& context) {
  const std::vector<OutlinePart> scaled = in_spacings(loops, spacing);
  SectionOutline section = outline_of(scaled);
  PlanarMesh& mesh = section.mesh;
  add_grid(scaled, mesh.points);
  const auto triangles = constrained_delaunay(mesh.points, section.loops);
  for (const Triangle& t : with_chords_split(triangles, mesh.n_boundary, mesh.points))
    mesh.add_cell(t);
  MapOptions options;
  options.poor = -1.0;
  options.squeezed = 0.0;
  const std::vector<Point2> images = map_planar(mesh, section.images, options, context).points;
  std::vector<Point2> out;
  for (const Point2& p : points) out.push_back(spacing * image_in(mesh, images, p / spacing));
  return out;
}

}  // namespace

std::vector<Point2> carried_smoothly(const std::vector<OutlinePart>& loops,
                                     const std::vector<Point2>& points, double spacing,
                                     const Context& context) {
  constexpr int n_refinements = 2;
  for (int i = 0;; ++i) try {
      return carried_at(loops, points, spacing / (1 << i), context);
    } catch (const InvalidMeshError&) {
      if (i == n_refinements) throw;
    }
}

}  // namespace sweepmesh
