#include "sweepmesh/imprint/sweep_levels.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "sweepmesh/base/disjoint_sets.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/imprint/axial_edges.h"

namespace sweepmesh {
namespace {

bool is_cap(FaceRole role) {
  return role == FaceRole::source || role == FaceRole::target;
}

/// Vertices that must lie on one level.
DisjointSets groups_of(const Model& model, const Scheme& scheme) {
  DisjointSets groups(model.n_vertices());
  for (const EdgeId e : model.edges())
    if (scheme.edge_role[e.index] != EdgeRole::axial)
      groups.join(model.start(e).index, model.end(e).index);
  for (const FaceId f : model.faces())
    if (is_cap(scheme.face_role[f.index]))
      for (const Loop& loop : model.loops(f))
        for (const Coedge& c : loop)
          groups.join(model.loops(f).front().front().start.index, c.start.index);
  return groups;
}

/// Mean height of each group's vertices.
std::map<int, double> heights_of(const Model& model, DisjointSets& groups,
                                 const std::vector<AxialEdge>& axial, const SweepPath* path) {
  Point3 direction = Point3::Zero();
  for (const AxialEdge& a : axial) direction += model.point(a.high) - model.point(a.low);
  direction.normalize();
  std::map<int, std::pair<double, int>> sums;
  for (const VertexId v : model.vertices()) {
    auto& [sum, n] = sums[groups.root(v.index)];
    sum += path ? path->straightened(model.point(v)).z() : direction.dot(model.point(v));
    ++n;
  }
  std::map<int, double> out;
  for (const auto& [root, sum] : sums) out[root] = sum.first / sum.second;
  return out;
}

}  // namespace

std::vector<int> sweep_levels(const Model& model, const Scheme& scheme, const SweepPath* path) {
  const auto axial = axial_edges(model, scheme);
  DisjointSets groups = groups_of(model, scheme);
  const auto height = heights_of(model, groups, axial, path);
  std::map<int, std::set<int>> above;
  std::map<int, int> n_below;
  for (const AxialEdge& a : axial) {
    const int low = groups.root(a.low.index), high = groups.root(a.high.index);
    if (above[low].insert(high).second) ++n_below[high];
  }
  std::set<std::pair<double, int>> open;  // groups with everything below them ranked
  for (const auto& [root, h] : height)
    if (n_below[root] == 0) open.insert({h, root});
  const double tie = 2 * model.tolerances().point;
  std::map<int, int> rank;
  while (!open.empty()) {
    const double limit = open.begin()->first + tie;
    std::vector<int> next;
    while (!open.empty() && open.begin()->first <= limit) {
      next.push_back(open.begin()->second);
      open.erase(open.begin());
    }
    const int r =
        rank.empty() ? 0 : 1 + std::max_element(rank.begin(), rank.end(), [](auto& a, auto& b) {
                                 return a.second < b.second;
                               })->second;
    for (const int root : next) rank[root] = r;
    for (const int root : next)
      for (const int high : above[root])
        if (--n_below[high] == 0) open.insert({height.at(high), high});
  }
  if (rank.size() < height.size())
    throw Error("imprint", "The axial edges of the sweep lead around in a circle.");
  std::vector<int> out(model.n_vertices(), -1);
  for (const VertexId v : model.vertices()) out[v.index] = rank.at(groups.root(v.index));
  return out;
}

}  // namespace sweepmesh
