#include "sweepmesh/imprint/occupancy.h"

#include <algorithm>

namespace sweepmesh {
namespace {

struct Candidate {
  EdgeId edge;
  int k;
  double distance;
};

/// Of the edges over the place (those as near as the nearest one) the ones at the layer that comes
/// first, going away from the place's own.
std::vector<EdgeId> first_met(const std::vector<Candidate>& candidates, bool upwards,
                              double tolerance) {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& c : candidates) least = std::min(least, c.distance);
  std::vector<EdgeId> out;
  int k = 0;
  for (const Candidate& c : candidates) {
    if (c.distance > least + tolerance) continue;
    if (!out.empty() && c.k != k && (c.k > k) == upwards) continue;
    if (out.empty() || c.k != k) out.clear();
    k = c.k;
    out.push_back(c.edge);
  }
  return out;
}

bool is_in(VertexId v, const std::vector<VertexId>& sorted) {
  return std::binary_search(sorted.begin(), sorted.end(), v);
}

}  // namespace

Occupancy::Occupancy(const Model& model, const Walls& walls, const Reference& reference)
    : model_(model), walls_(walls), curve_(walls.k.size()), coincidence_(reference.coincidence) {
  for (const ReferenceCurve& c : reference.curves) curve_[c.edge.index] = &c.points;
}

Occupancy::Span Occupancy::span(const Place& place) const {
  const int k = walls_.k[place.edge.index];
  Span out{k, k, {place.edge}, {place.edge}};
  const auto met = [&](FaceId face, bool upwards) {
    std::vector<Candidate> candidates;
    for (const EdgeId e : (upwards ? walls_.tops : walls_.bottoms)[face.index]) {
      const int ke = walls_.k[e.index];
      if (upwards ? ke > k : ke < k)
        candidates.push_back({e, ke, nearest(*curve_[e.index], place.point).distance});
    }
    return first_met(candidates, upwards, 2 * coincidence_);
  };
  if (const FaceId f = walls_.above[place.edge.index]; f.is_valid())
    if (auto tops = met(f, true); !tops.empty()) {
      out.high = walls_.k[tops.front().index];
      out.tops = std::move(tops);
    }
  if (const FaceId f = walls_.below[place.edge.index]; f.is_valid())
    if (auto bottoms = met(f, false); !bottoms.empty()) {
      out.low = walls_.k[bottoms.front().index];
      out.bottoms = std::move(bottoms);
    }
  return out;
}

bool Occupancy::touch_rightly(const std::vector<EdgeId>& lower, const std::vector<EdgeId>& upper,
                              const std::vector<VertexId>& shared) const {
  for (const EdgeId a : lower)
    for (const EdgeId b : upper) {
      if (a == b) return true;
      for (const VertexId v : {model_.start(a), model_.end(a)})
        if (is_in(v, shared) && (v == model_.start(b) || v == model_.end(b))) return true;
    }
  return false;
}

bool Occupancy::collide(const Place& a, const Place& b, const std::vector<VertexId>& shared) const {
  if (a.edge == b.edge) return true;
  const Span sa = span(a), sb = span(b);
  if (sa.high < sb.low || sb.high < sa.low) return false;
  if (sa.high == sb.low) return !touch_rightly(sa.tops, sb.bottoms, shared);
  if (sb.high == sa.low) return !touch_rightly(sb.tops, sa.bottoms, shared);
  const int ka = walls_.k[a.edge.index], kb = walls_.k[b.edge.index];
  const auto ends_one_face = [&](EdgeId low, EdgeId high) {
    const FaceId f = walls_.above[low.index];
    return f.is_valid() && f == walls_.below[high.index];
  };
  if (ka < kb) return !(ends_one_face(a.edge, b.edge) && (sa.high == kb || sb.low == ka));
  return !(ends_one_face(b.edge, a.edge) && (sb.high == ka || sa.low == kb));
}

}  // namespace sweepmesh
