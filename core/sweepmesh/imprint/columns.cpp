#include "sweepmesh/imprint/columns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "sweepmesh/base/disjoint_sets.h"

namespace sweepmesh {

CurveEnds::CurveEnds(const Model& model, const Walls& walls, const Reference& reference)
    : walls_(walls), at_(model.n_vertices()) {
  for (const ReferenceCurve& c : reference.curves) {
    at_[model.start(c.edge).index].push_back({&c, true});
    at_[model.end(c.edge).index].push_back({&c, false});
  }
}

std::vector<Occupancy::Place> CurveEnds::places(VertexId v) const {
  std::vector<Occupancy::Place> out;
  for (const auto& [curve, at_start] : at_[v.index])
    out.push_back({curve->edge, beside(curve->points, at_start)});
  return out;
}

std::vector<std::pair<EdgeId, Point2>> CurveEnds::directions(VertexId v) const {
  std::vector<std::pair<EdgeId, Point2>> out;
  for (const auto& [curve, at_start] : at_[v.index]) {
    const auto& p = curve->points;
    const Point2 away = at_start ? Point2(p[1] - p[0]) : Point2(p[p.size() - 2] - p.back());
    out.push_back({curve->edge, away.normalized()});
  }
  return out;
}

double CurveEnds::turn(EdgeId e, VertexId v) const {
  double least = std::numbers::pi;
  const auto all = directions(v);
  for (const auto& [edge, away] : all) {
    if (edge != e) continue;
    for (const auto& [other, onwards] : all) {
      if ((other == e && onwards == away) || walls_.level[other.index] != walls_.level[e.index])
        continue;
      least =
          std::min(least, std::numbers::pi - std::acos(std::clamp(away.dot(onwards), -1.0, 1.0)));
    }
  }
  return least;
}

Point2 CurveEnds::beside(const Polyline& line, bool at_start) {
  constexpr double little = 0.1;
  return at_arc(line, length(line) * (at_start ? little : 1.0 - little)).point;
}

std::vector<CadColumn> find_columns(const Model& model, const Scheme& scheme,
                                    const Reference& reference, const Occupancy& occupancy,
                                    const CurveEnds& ends) {
  DisjointSets joined(model.n_vertices());
  for (const EdgeId e : model.edges())
    if (scheme.edge_role[e.index] == EdgeRole::axial)
      joined.join(model.start(e).index, model.end(e).index);
  std::map<int, std::vector<VertexId>> vertices;  // by root
  for (const VertexId v : model.vertices()) vertices[joined.root(v.index)].push_back(v);
  std::vector<CadColumn> out;
  for (const auto& [root, list] : vertices) {
    std::vector<Occupancy::Place> places;
    for (const VertexId v : list) std::ranges::copy(ends.places(v), std::back_inserter(places));
    if (!places.empty())
      out.push_back({list, reference.vertex[list.front().index], occupancy.column(list, places)});
  }
  return out;
}

std::vector<int> joined_columns(const std::vector<CadColumn>& columns, const Occupancy& occupancy,
                                double distance) {
  const int n = static_cast<int>(columns.size());
  const auto apart = [&](int a, int b) { return (columns[a].place - columns[b].place).norm(); };
  std::vector<std::tuple<double, int, int>> pairs;
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      if (const double d = apart(a, b); d < distance) pairs.emplace_back(d, a, b);
  std::sort(pairs.begin(), pairs.end());
  DisjointSets joined(n);
  const auto may_join = [&](int a, int b) {
    if (a == b || apart(a, b) > distance) return false;
    for (int p = 0; p < n; ++p)
      for (int q = 0; q < n; ++q)
        if (joined.root(p) == a && joined.root(q) == b &&
            occupancy.collide(columns[p].column, columns[q].column))
          return false;
    return true;
  };
  for (const auto& [d, a, b] : pairs)
    if (may_join(joined.root(a), joined.root(b))) joined.join(a, b);
  std::vector<int> out;
  for (int c = 0; c < n; ++c) out.push_back(joined.root(c));
  return out;
}

}  // namespace sweepmesh
