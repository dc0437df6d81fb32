#include "sweepmesh/scheme/asked.h"

#include <algorithm>
#include <map>
#include <set>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/vertex_types.h"

namespace sweepmesh {

std::vector<Pick> all_picks(const Picks& picks) {
  std::vector<Pick> out;
  for (FaceId id : picks.sources) out.emplace_back(id, kSourceStates);
  for (FaceId id : picks.targets) out.emplace_back(id, kTargetStates);
  for (const auto& [source, target] : picks.pairs) {
    out.emplace_back(source, kSourceStates);
    out.emplace_back(target, kTargetStates);
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

std::vector<Pick> with_types(std::vector<Pick> caps, const std::vector<TypePick>& types) {
  for (const TypePick& pick : types) caps.emplace_back(pick.face, kLinkingStates);
  return caps;
}

bool is_cap(const Pick& pick) {
  return pick.second != kLinkingStates;
}

bool has_picked(const std::vector<Pick>& picks, StateSet role) {
  return std::ranges::any_of(picks, [&](const Pick& p) { return p.second == role; });
}

int index_of(const SweepProblem& problem, FaceId id) {
  const auto at = std::ranges::find(problem.faces, id, &ProblemFace::id);
  if (at == problem.faces.end())
    throw InputError("assess", name_of(id) + " is not a face of this solid.", {name_of(id)});
  return static_cast<int>(at - problem.faces.begin());
}

void check_types(const Picks& picks) {
  std::set<FaceId> caps(picks.sources.begin(), picks.sources.end());
  caps.insert(picks.targets.begin(), picks.targets.end());
  for (const auto& [source, target] : picks.pairs) caps.insert({source, target});
  std::map<std::pair<FaceId, VertexId>, VertexType> seen;
  for (const TypePick& pick : picks.types) {
    const std::string face = name_of(pick.face), vertex = name_of(pick.vertex);
    const VertexType other = seen.try_emplace({pick.face, pick.vertex}, pick.type).first->second;
    if (other != pick.type)
      throw InputError("assess",
                       vertex + " of " + face + " is given as " + name_of(other) + " and as " +
                           name_of(pick.type) + ".",
                       {vertex, face});
    if (caps.contains(pick.face))
      throw InputError("assess",
                       vertex + " is given a vertex type on " + face +
                           ", which is picked as a source or target: only linking faces have "
                           "vertex types.",
                       {vertex, face});
  }
}

std::vector<FixedCorner> fixed_corners(const SweepProblem& problem,
                                       const std::vector<TypePick>& types) {
  std::vector<FixedCorner> out;
  for (const TypePick& pick : types) {
    const int face = index_of(problem, pick.face), first = problem.first_coedge(face);
    const std::size_t n_before = out.size();
    for (int c = first; c < first + problem.n_coedges(face); ++c)
      if (problem.coedges[c].end == pick.vertex.index) out.push_back({c, pick.type});
    if (out.size() == n_before)
      throw InputError("assess",
                       name_of(pick.vertex) + " is not a vertex of " + name_of(pick.face) + ".",
                       {name_of(pick.vertex), name_of(pick.face)});
  }
  return out;
}

Choices start_of(const Network& network, const std::vector<Pick>& picks) {
  Choices out = open_choices(network);
  std::vector<int> touched;
  for (const auto& [id, states] : picks)
    set_role(network, out, index_of(network.problem, id), states, touched);
  return out;
}

}  // namespace sweepmesh
