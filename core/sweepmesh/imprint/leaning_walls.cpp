#include "sweepmesh/imprint/leaning_walls.h"

#include <algorithm>
#include <limits>
#include <map>

namespace sweepmesh {

std::set<FaceId> free_leaning_faces(const Model& model, const Walls& walls,
                                    const std::vector<ReferenceCurve>& curves,
                                    const std::vector<Panel>& panels,
                                    const std::vector<char>& is_upright, int level, bool upwards) {
  const auto& begins = upwards ? walls.above : walls.below;
  const auto& ends = upwards ? walls.below : walls.above;
  std::set<FaceId> out, tied;
  for (const Panel& p : panels) {
    if ((upwards ? p.low : p.high) == level && !is_upright[p.face.index]) out.insert(p.face);
    if ((upwards ? p.high : p.low) == level) tied.insert(p.face);
  }
  std::map<VertexId, std::set<FaceId>> at;  // invalid ids stand for what is no such face
  for (const ReferenceCurve& c : curves) {
    if (walls.level[c.edge.index] != level) continue;
    const FaceId f = ends[c.edge.index].is_valid() ? FaceId{} : begins[c.edge.index];
    if (!f.is_valid()) tied.insert(begins[c.edge.index]);
    for (const VertexId v : {model.start(c.edge), model.end(c.edge)}) at[v].insert(f);
  }
  for (const FaceId f : tied) out.erase(f);
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [v, faces] : at) {
      if (std::ranges::all_of(faces, [&](FaceId f) { return out.contains(f); })) continue;
      for (const FaceId f : faces) changes |= out.erase(f) > 0;
    }
  }
  return out;
}

void lean_halfway(FaceId face, const std::vector<Panel>& panels, int level, bool upwards,
                  ReferenceCurve& curve) {
  const Point2 middle = at_arc(curve.points, length(curve.points) / 2).point;
  const Panel* panel = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Panel& p : panels) {
    if (p.face != face || (upwards ? p.low : p.high) != level) continue;
    const double distance = nearest(upwards ? p.bottom : p.top, middle).distance;
    if (distance >= least) continue;
    least = distance;
    panel = &p;
  }
  if (!panel) return;
  const Polyline &line = upwards ? panel->bottom : panel->top, half = panel->at(0.5);
  for (Point2& x : curve.points) x = at_position(half, nearest(line, x).position).point;
}

}  // namespace sweepmesh
