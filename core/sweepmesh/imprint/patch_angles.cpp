#include "sweepmesh/imprint/patch_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sweepmesh/imprint/edge_lengths.h"

namespace sweepmesh {
namespace {

/// The nodes of an imprint edge on a cap's own boundary, in the direction of a loop.
struct CapSide {
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< of the cap
};

std::optional<CapSide> cap_side(const Model& model, const Imprint& imprint, int count,
                                DirectedEdge d, FaceId cap) {
  for (const Trace& t : imprint.edges[d.edge].traces)
    for (const Coedge& c : model.coedges(t.edge)) {
      if (c.face != cap) continue;
      CapSide out;
      const double from = d.reversed ? t.last : t.first, to = d.reversed ? t.first : t.last;
      for (const double at : even_parameters(model, t.edge, from, to, count)) {
        out.points.push_back(model.point(t.edge, at));
        out.normals.push_back(model.normal(cap, model.uv(c, at)));
      }
      return out;
    }
  return std::nullopt;
}

/// By edge of a loop.
std::vector<std::optional<CapSide>> cap_sides(const Model& model, const Imprint& imprint,
                                              const std::vector<int>& counts,
                                              const std::vector<DirectedEdge>& loop, FaceId cap) {
  std::vector<std::optional<CapSide>> out;
  for (const DirectedEdge& d : loop)
    out.push_back(cap_side(model, imprint, counts[d.edge], d, cap));
  return out;
}

/// Angle where a boundary comes from `before` to `here` and goes on to `after`, with the cap on its
/// left as seen against `up`.
double angle_at(const Point3& before, const Point3& here, const Point3& after, const Point3& up) {
  const Point3 along = after - here, back = before - here;
  const double angle = std::atan2(along.cross(back).dot(up), along.dot(back));
  return angle > 0.0 ? angle : angle + 2 * std::numbers::pi;
}

/// Rounded to far more than a turned or scaled model's angles differ by: whether 135 degrees are
/// one cell or two must not hang on that.
double without_noise(double angle) {
  constexpr double grid = 1e6;  // per radian
  return std::round(angle * grid) / grid;
}

/// The cap's angles at the nodes of a loop, where the boundary is the cap's own on both sides.
std::vector<std::optional<double>> cap_angles(const Model& model, const Imprint& imprint,
                                              const std::vector<int>& counts,
                                              const std::vector<DirectedEdge>& loop, FaceId cap,
                                              bool is_source) {
  const auto sides = cap_sides(model, imprint, counts, loop, cap);
  std::vector<std::optional<double>> out;
  const auto up = [&](const Point3& normal) { return is_source ? normal : Point3(-normal); };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &before = sides[(i + loop.size() - 1) % loop.size()], &here = sides[i];
    const std::size_t n = counts[loop[i].edge];
    out.resize(out.size() + n);
    if (!here) continue;
    const auto angle = out.end() - n;
    if (before)
      angle[0] = angle_at(before->points[before->points.size() - 2], here->points[0],
                          here->points[1], up(here->normals[0]));
    for (std::size_t s = 1; s < n; ++s)
      angle[s] =
          angle_at(here->points[s - 1], here->points[s], here->points[s + 1], up(here->normals[s]));
  }
  return out;
}

/// Appends the nodes of a loop.
void add_loop(const Model& model, const Imprint& imprint, const std::vector<int>& counts,
              const std::vector<DirectedEdge>& loop, FaceId cap, bool is_source, CapOutline& out) {
  const auto sides = cap_sides(model, imprint, counts, loop, cap);
  const std::size_t n_edges = loop.size();
  for (std::size_t i = 0; i < n_edges; ++i) {
    const auto &here = sides[i], &before = sides[(i + n_edges - 1) % n_edges];
    for (int s = 0; s < counts[loop[i].edge]; ++s) {
      const auto& side = here || s > 0 ? here : before;
      const std::size_t at = here || s > 0 ? s : counts[loop[(i + n_edges - 1) % n_edges].edge];
      out.point.push_back(side ? std::optional(side->points[at]) : std::nullopt);
      const Point3 normal = side ? side->normals[at] : Point3(Point3::Zero());
      out.up.push_back(is_source ? normal : Point3(-normal));
    }
  }
}

}  // namespace

std::vector<CapOutline> cap_outlines(const Model& model, const Imprint& imprint,
                                     const std::vector<int>& counts, const Patch& patch) {
  std::vector<CapOutline> out;
  for (const Run& run : patch.runs)
    for (const bool is_source : {false, true}) {
      out.emplace_back();
      for (const auto& loop : patch.loops)
        add_loop(model, imprint, counts, loop, is_source ? run.source : run.target, is_source,
                 out.back());
    }
  return out;
}

std::vector<char> tied_corners(const PlanarMesh& mesh, const std::vector<CapOutline>& outlines) {
  constexpr double flat = 170.0 / 180.0 * std::numbers::pi;
  std::vector<char> out(mesh.n_boundary, false);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const std::size_t n = cell.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int before = cell[(i + n - 1) % n], here = cell[i], after = cell[(i + 1) % n];
      if (std::max({before, here, after}) >= mesh.n_boundary) continue;
      for (const CapOutline& o : outlines)
        if (o.point[before] && o.point[here] && o.point[after] &&
            angle_at(*o.point[before], *o.point[here], *o.point[after], o.up[here]) > flat)
          out[here] = true;
    }
  }
  return out;
}

BoundaryAngles patch_angles(const Model& model, const Imprint& imprint,
                            const std::vector<int>& counts, const Patch& patch,
                            const PlanarLoops& plane) {
  BoundaryAngles rows = {interior_angles(plane)};
  std::vector<char> is_given(rows.front().size(), false);
  for (const Run& run : patch.runs)
    for (const bool is_source : {false, true}) {
      std::vector<double> row = rows.front();
      std::size_t node = 0;
      for (const auto& loop : patch.loops)
        for (const auto& angle : cap_angles(model, imprint, counts, loop,
                                            is_source ? run.source : run.target, is_source)) {
          if (angle) {
            row[node] = *angle;
            if (!is_given[node]) rows.front()[node] = *angle;
            is_given[node] = true;
          }
          ++node;
        }
      rows.push_back(std::move(row));
    }
  for (auto& row : rows)
    for (double& angle : row) angle = without_noise(angle);
  return rows;
}

}  // namespace sweepmesh
