#include "sweepmesh/scheme/pairs.h"

#include <algorithm>
#include <map>
#include <set>

namespace sweepmesh {

namespace {

/// Axial edges by their lower vertex: the coedge that runs up.
std::multimap<int, int> rising_coedges(const Network& n, const Choices& choices) {
  std::multimap<int, int> out;
  for (std::size_t c = 0; c < n.problem.coedges.size(); ++c)
    if (first_state(choices.domain[c]) == static_cast<int>(Direction::plus_k))
      out.emplace(n.problem.coedges[c].start, static_cast<int>(c));
  return out;
}

struct Way {
  std::set<int> ends;   ///< vertices from which no axial edge leads on
  std::set<int> faces;  ///< linking faces along the way
};

Way way_up(const Network& n, const std::multimap<int, int>& rising, int vertex) {
  Way out;
  std::vector<int> open = {vertex};
  while (!open.empty()) {
    const int v = open.back();
    open.pop_back();
    const auto [begin, end] = rising.equal_range(v);
    if (begin == end) out.ends.insert(v);
    for (auto it = begin; it != end; ++it) {
      const ProblemCoedge& c = n.problem.coedges[it->second];
      out.faces.insert({c.face, n.problem.coedges[c.partner].face});
      open.push_back(c.end);
    }
  }
  return out;
}

std::vector<int> sources_at(const Network& n, const Choices& choices,
                            const std::set<int>& vertices) {
  std::set<int> out;
  for (const ProblemCoedge& c : n.problem.coedges)
    if (choices.role[c.face] == kSourceStates && vertices.contains(c.start)) out.insert(c.face);
  return {out.begin(), out.end()};
}

Reason contradiction(const Network& n, FaceId source, FaceId target, const std::vector<int>& above,
                     const Way& way) {
  Reason out{ReasonKind::prescribed, {}, {name_of(source), name_of(target)}};
  std::string walls;
  for (int f : way.faces) {
    walls += (walls.empty() ? "" : ", ") + name_of(n.problem.faces[f].id);
    out.entities.push_back(name_of(n.problem.faces[f].id));
  }
  const std::string above_name = name_of(n.problem.faces[above.front()].id);
  out.text = name_of(source) + " cannot be paired with " + name_of(target) + ": along " + walls +
             " a corner of " + name_of(target) + " leads to " + above_name + ". Pair " +
             name_of(target) + " with " + above_name + ", or leave the pairs open.";
  return out;
}

}  // namespace

std::optional<Reason> contradicted_pair(const Network& network, const Division& division,
                                        const std::vector<std::pair<FaceId, FaceId>>& pairs) {
  const Choices& choices = division.choices;
  const auto rising = rising_coedges(network, choices);
  for (const ProblemCoedge& c : network.problem.coedges) {
    const FaceId target = network.problem.faces[c.face].id;
    if (choices.role[c.face] != kTargetStates || !rising.contains(c.start)) continue;
    std::vector<FaceId> wanted;
    for (const auto& [s, t] : pairs)
      if (t == target) wanted.push_back(s);
    if (wanted.empty()) continue;
    const Way way = way_up(network, rising, c.start);
    const std::vector<int> above = sources_at(network, choices, way.ends);
    const bool holds =
        above.empty() || std::ranges::any_of(above, [&](int f) {
          return std::ranges::find(wanted, network.problem.faces[f].id) != wanted.end();
        });
    if (!holds) return contradiction(network, wanted.front(), target, above, way);
  }
  return {};
}

}  // namespace sweepmesh
