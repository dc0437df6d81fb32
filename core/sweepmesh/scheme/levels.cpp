#include "sweepmesh/scheme/levels.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "sweepmesh/base/disjoint_sets.h"

namespace sweepmesh {

namespace {

constexpr StateSet kTransverseStates = 0b000101;
constexpr int kPlusK = static_cast<int>(Direction::plus_k);

bool is_within(StateSet set, StateSet all) {
  return set != 0 && (set & ~all) == 0;
}

DisjointSets joined_vertices(const Network& n, const Choices& choices) {
  DisjointSets groups(n.problem.n_vertices);
  for (std::size_t c = 0; c < n.problem.coedges.size(); ++c)
    if (is_within(choices.domain[c], kTransverseStates | kSourceStates | kTargetStates))
      groups.join(n.problem.coedges[c].start, n.problem.coedges[c].end);
  for (std::size_t f = 0; f < n.problem.faces.size(); ++f) {
    if (!is_within(choices.role[f], kSourceStates | kTargetStates)) continue;
    const int first = n.problem.first_coedge(f);
    for (int c = first; c < first + n.problem.n_coedges(f); ++c)
      groups.join(n.problem.coedges[first].start, n.problem.coedges[c].start);
  }
  return groups;
}

/// +1 or -1 where all coedges of a loop are known to run along +i or -i, else 0.
int way_around(const Choices& choices, const ProblemLoop& loop) {
  constexpr StateSet kPlusI = 0b0001, kMinusI = 0b0100;
  const auto all = [&](StateSet state) {
    for (int c = loop.first; c < loop.first + loop.count; ++c)
      if (choices.domain[c] != state) return false;
    return loop.count > 0;
  };
  return all(kPlusI) ? 1 : all(kMinusI) ? -1 : 0;
}

/// In an annulus without axial edges k grows from the loop along +i to the one along -i.
void add_annuli(const Network& n, const Choices& choices, std::vector<std::pair<int, int>>& out) {
  for (const ProblemFace& face : n.problem.faces)
    for (std::size_t hole = 1; hole < face.loops.size(); ++hole) {
      const int way = way_around(choices, face.loops[0]);
      if (way == 0 || way_around(choices, face.loops[hole]) != -way) continue;
      const int outer = n.problem.coedges[face.loops[0].first].start;
      const int inner = n.problem.coedges[face.loops[hole].first].start;
      out.push_back(way > 0 ? std::pair{outer, inner} : std::pair{inner, outer});
    }
}

/// Lower and upper end of each coedge that is known to be axial and to run up.
std::vector<std::pair<int, int>> rises(const Network& n, const Choices& choices) {
  std::vector<std::pair<int, int>> out;
  for (std::size_t c = 0; c < n.problem.coedges.size(); ++c)
    if (is_single(choices.domain[c]) && has(choices.domain[c], kPlusK))
      out.emplace_back(n.problem.coedges[c].start, n.problem.coedges[c].end);
  add_annuli(n, choices, out);
  return out;
}

/// CORNER edge of a cap: its linking face is not on the material side of the cap's level.
bool is_corner_edge(const Network& n, const Choices& choices, int cap_coedge) {
  const int other = n.problem.coedges[cap_coedge].partner;
  const int d = first_state(choices.domain[other]);
  if (d >= kSourceState) return false;
  const bool is_above = d == static_cast<int>(Direction::plus_i);
  return is_above == has(choices.domain[cap_coedge], kSourceState);
}

/// chi of all caps of one kind, less that of their CORNER edges.
int relative_euler(const Network& n, const Choices& choices, int state) {
  std::set<int> vertices, edges, corner_vertices, corner_edges;
  int chi = 0;
  for (std::size_t f = 0; f < n.problem.faces.size(); ++f) {
    if (!has(choices.role[f], state)) continue;
    chi += 2 - static_cast<int>(n.problem.faces[f].loops.size());
    const int first = n.problem.first_coedge(f);
    for (int c = first; c < first + n.problem.n_coedges(f); ++c) {
      const ProblemCoedge& coedge = n.problem.coedges[c];
      vertices.insert({coedge.start, coedge.end});
      edges.insert(coedge.edge);
      if (!is_corner_edge(n, choices, c)) continue;
      corner_vertices.insert({coedge.start, coedge.end});
      corner_edges.insert(coedge.edge);
    }
  }
  const auto size = [](const std::set<int>& s) { return static_cast<int>(s.size()); };
  return chi + size(vertices) - size(edges) - size(corner_vertices) + size(corner_edges);
}

}  // namespace

std::optional<LevelGroups> level_groups(const Network& network, const Choices& choices) {
  DisjointSets groups = joined_vertices(network, choices);
  std::vector<std::vector<int>> above(network.problem.n_vertices);
  std::vector<int> n_below(network.problem.n_vertices, 0);
  for (const auto& [low, high] : rises(network, choices)) {
    above[groups.root(low)].push_back(groups.root(high));
    ++n_below[groups.root(high)];
  }
  LevelGroups out{std::vector<int>(network.problem.n_vertices, -1), 0};
  std::vector<bool> is_used(network.problem.n_vertices, false);
  for (const ProblemCoedge& c : network.problem.coedges) is_used[groups.root(c.start)] = true;
  std::vector<int> open, number(network.problem.n_vertices, -1);
  int n_used = 0;
  for (int v = 0; v < network.problem.n_vertices; ++v) {
    if (!is_used[v]) continue;
    ++n_used;
    if (n_below[v] == 0) open.push_back(v);
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    number[open[i]] = out.n_groups++;
    for (int high : above[open[i]])
      if (--n_below[high] == 0) open.push_back(high);
  }
  if (out.n_groups < n_used) return {};
  for (const ProblemCoedge& c : network.problem.coedges)
    out.group[c.start] = number[groups.root(c.start)];
  return out;
}

bool has_both_ends(const Network& network, const Choices& choices) {
  std::vector<StateSet> of_shell;
  bool has_source = false, has_target = false;
  for (std::size_t f = 0; f < network.problem.faces.size(); ++f) {
    const int shell = network.problem.faces[f].shell;
    if (shell >= static_cast<int>(of_shell.size())) of_shell.resize(shell + 1, 0);
    of_shell[shell] |= choices.role[f];
    has_source |= choices.role[f] == kSourceStates;
    has_target |= choices.role[f] == kTargetStates;
  }
  if (!has_source || !has_target) return false;
  const bool has_closed_cap = std::ranges::any_of(
      of_shell, [](StateSet roles) { return roles == kSourceStates || roles == kTargetStates; });
  if (!has_closed_cap) return true;
  return of_shell.size() == 2 && (of_shell[0] ^ of_shell[1]) == (kSourceStates | kTargetStates);
}

bool is_euler_balanced(const Network& network, const Choices& choices) {
  return relative_euler(network, choices, kSourceState) ==
         relative_euler(network, choices, kTargetState);
}

}  // namespace sweepmesh
