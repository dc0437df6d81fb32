#include "sweepmesh/imprint/patch_angles.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "sweepmesh/imprint/edge_lengths.h"

namespace sweepmesh {
namespace {

/// The first mesh edge of an imprint edge on a cap's own boundary, away from one end.
struct MeshEdge {
  Point3 along;
  Point3 normal;  ///< of the cap, at the end
};

std::optional<MeshEdge> mesh_edge(const Model& model, const Imprint& imprint, int count,
                                  DirectedEdge d, FaceId cap) {
  for (const Trace& t : imprint.edges[d.edge].traces)
    for (const Coedge& c : model.coedges(t.edge)) {
      if (c.face != cap) continue;
      const double from = d.reversed ? t.last : t.first, to = d.reversed ? t.first : t.last;
      const double next = even_parameters(model, t.edge, from, to, count)[1];
      return MeshEdge{model.point(t.edge, next) - model.point(t.edge, from),
                      model.normal(cap, model.uv(c, from))};
    }
  return std::nullopt;
}

/// Angle of a cap where a loop comes along `in` and goes on along `out`.
std::optional<double> cap_angle(const Model& model, const Imprint& imprint,
                                const std::vector<int>& counts, DirectedEdge in, DirectedEdge out,
                                FaceId cap, bool is_source) {
  const auto back = mesh_edge(model, imprint, counts[in.edge], {in.edge, !in.reversed}, cap);
  const auto along = mesh_edge(model, imprint, counts[out.edge], out, cap);
  if (!back || !along) return std::nullopt;
  const Point3 up = is_source ? along->normal : Point3(-along->normal);
  const double angle =
      std::atan2(along->along.cross(back->along).dot(up), along->along.dot(back->along));
  return angle > 0.0 ? angle : angle + 2 * std::numbers::pi;
}

}  // namespace

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
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const DirectedEdge before = loop[(i + loop.size() - 1) % loop.size()];
          if (const auto angle = cap_angle(model, imprint, counts, before, loop[i],
                                           is_source ? run.source : run.target, is_source)) {
            row[node] = *angle;
            if (!is_given[node]) rows.front()[node] = *angle;
            is_given[node] = true;
          }
          node += counts[loop[i].edge];
        }
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace sweepmesh
