#include "sweepmesh/imprint/occupancy.h"

#include <algorithm>

namespace sweepmesh {
namespace {

struct Candidate {
  EdgeId edge;
  int level;
  double distance;
};

/// Of the edges over the place (those as near as the nearest one) the ones at the level that comes
/// first, going away from the place's own.
std::vector<EdgeId> first_met(const std::vector<Candidate>& candidates, bool upwards,
                              double tolerance) {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& c : candidates) least = std::min(least, c.distance);
  std::vector<EdgeId> out;
  int level = 0;
  for (const Candidate& c : candidates) {
    if (c.distance > least + tolerance) continue;
    if (!out.empty() && c.level != level && (c.level > level) == upwards) continue;
    if (out.empty() || c.level != level) out.clear();
    level = c.level;
    out.push_back(c.edge);
  }
  return out;
}

bool have_common(const std::vector<EdgeId>& a, const std::vector<EdgeId>& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](EdgeId e) { return std::find(b.begin(), b.end(), e) != b.end(); });
}

}  // namespace

Occupancy::Occupancy(const Model& model, const Walls& walls, const Reference& reference)
    : model_(model),
      walls_(walls),
      curve_(walls.level.size()),
      coincidence_(reference.coincidence) {
  for (const ReferenceCurve& c : reference.curves) curve_[c.edge.index] = &c.points;
}

std::optional<Occupancy::Reach> Occupancy::reach(const Place& place, bool upwards) const {
  const FaceId face = (upwards ? walls_.above : walls_.below)[place.edge.index];
  if (!face.is_valid()) return std::nullopt;
  const int level = walls_.level[place.edge.index];
  std::vector<Candidate> candidates;
  for (const EdgeId e : (upwards ? walls_.tops : walls_.bottoms)[face.index]) {
    const int other = walls_.level[e.index];
    if (upwards ? other > level : other < level)
      candidates.push_back({e, other, nearest(*curve_[e.index], place.point).distance});
  }
  auto edges = first_met(candidates, upwards, 2 * coincidence_);
  if (edges.empty()) return std::nullopt;
  const int end = walls_.level[edges.front().index];
  return Reach{face, end, std::move(edges)};
}

Occupancy::Span Occupancy::span(const Place& place) const {
  const int level = walls_.level[place.edge.index];
  Span out{level, level, {place.edge}, {place.edge}};
  if (auto up = reach(place, true)) out.high = up->level, out.tops = std::move(up->edges);
  if (auto down = reach(place, false)) out.low = down->level, out.bottoms = std::move(down->edges);
  return out;
}

Occupancy::Column Occupancy::column(const std::vector<VertexId>& vertices,
                                    const std::vector<Place>& ends) const {
  Column out{std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), {}, {}};
  for (const Place& p : ends) {
    out.low = std::min(out.low, walls_.level[p.edge.index]);
    out.high = std::max(out.high, walls_.level[p.edge.index]);
  }
  for (const VertexId v : vertices)
    if (const int level = walls_.vertex_level[v.index]; level >= 0) {
      out.low = std::min(out.low, level);
      out.high = std::max(out.high, level);
    }
  for (const Place& p : ends) {
    if (walls_.level[p.edge.index] == out.high)
      if (auto up = reach(p, true)) out.up.push_back(std::move(*up));
    if (walls_.level[p.edge.index] == out.low)
      if (auto down = reach(p, false)) out.down.push_back(std::move(*down));
  }
  return out;
}

bool Occupancy::meet_in(const std::vector<VertexId>& there, const Span& a, const Span& b) const {
  const auto ends_there = [&](const std::vector<EdgeId>& edges) {
    return std::ranges::any_of(edges, [&](EdgeId e) {
      return std::ranges::any_of(
          there, [&](VertexId v) { return model_.start(e) == v || model_.end(e) == v; });
    });
  };
  return (ends_there(a.bottoms) || ends_there(a.tops)) &&
         (ends_there(b.bottoms) || ends_there(b.tops));
}

bool Occupancy::collide(const Place& a, const Place& b, const std::vector<VertexId>& there) const {
  if (a.edge == b.edge) return true;
  const Span sa = span(a), sb = span(b);
  if (sa.high < sb.low || sb.high < sa.low || meet_in(there, sa, sb)) return false;
  if (sa.high == sb.low) return !have_common(sa.tops, sb.bottoms);
  if (sb.high == sa.low) return !have_common(sb.tops, sa.bottoms);
  const int la = walls_.level[a.edge.index], lb = walls_.level[b.edge.index];
  const auto ends_one_face = [&](EdgeId low, EdgeId high) {
    const FaceId f = walls_.above[low.index];
    return f.is_valid() && f == walls_.below[high.index];
  };
  if (la < lb) return !(ends_one_face(a.edge, b.edge) && (sa.high == lb || sb.low == la));
  return !(ends_one_face(b.edge, a.edge) && (sb.high == la || sa.low == lb));
}

bool Occupancy::collide(const Column& a, const Column& b) const {
  if (a.low > b.high) return collide(b, a);
  if (a.high >= b.low) return true;
  int high = a.high, low = b.low;
  for (const Reach& up : a.up) high = std::max(high, up.level);
  for (const Reach& down : b.down) low = std::min(low, down.level);
  if (high < low) return false;
  for (const Reach& up : a.up)
    for (const Reach& down : b.down)
      if (up.face == down.face || (up.level == down.level && have_common(up.edges, down.edges)))
        return false;
  return true;
}

bool Occupancy::collide(const Column& a, const Place& b) const {
  const int level = walls_.level[b.edge.index];
  Column column{level, level, {}, {}};
  if (auto up = reach(b, true)) column.up.push_back(std::move(*up));
  if (auto down = reach(b, false)) column.down.push_back(std::move(*down));
  return collide(a, column);
}

}  // namespace sweepmesh
