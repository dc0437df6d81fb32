#include "sweepmesh/scheme/to_scheme.h"

#include <cmath>

namespace sweepmesh {

namespace {

FaceRole role_of(StateSet role) {
  if (role & kSourceStates) return FaceRole::source;
  if (role & kTargetStates) return FaceRole::target;
  return FaceRole::linking;
}

Direction direction_of(const Division& division, int coedge) {
  return static_cast<Direction>(first_state(division.choices.domain[coedge]));
}

/// The type whose turn takes one direction into the next.
VertexType type_between(Direction before, Direction after) {
  for (VertexType t : {VertexType::end, VertexType::side, VertexType::corner})
    if (turned(before, t) == after) return t;
  return VertexType::reversal;
}

FaceScheme face_scheme(const Network& n, const Division& division, int face) {
  FaceScheme out;
  for (const ProblemLoop& loop : n.problem.faces[face].loops) {
    out.direction.emplace_back();
    out.type.emplace_back();
    for (int c = loop.first; c < loop.first + loop.count; ++c) {
      const Direction d = direction_of(division, c);
      out.direction.back().push_back(d);
      out.type.back().push_back(type_between(d, direction_of(division, n.problem.next(c))));
    }
  }
  return out;
}

EdgeRole edge_role(const Network& n, const Division& division, const ProblemEdge& edge) {
  EdgeRole out = EdgeRole::none;
  for (int c : edge.coedge) {
    if (!(n.problem.coedges[c].face >= 0) || has(division.choices.domain[c], kSourceState) ||
        has(division.choices.domain[c], kTargetState))
      continue;
    out = is_axial(direction_of(division, c)) ? EdgeRole::axial : EdgeRole::transverse;
  }
  return out;
}

/// A linking face whose outer loop does not turn once around.
bool is_annulus(const FaceScheme& scheme) {
  int sum = 0;
  for (VertexType t : scheme.type.front()) sum += static_cast<int>(t);
  return sum == 0;
}

}  // namespace

Scheme to_scheme(const Network& network, const Division& division, int n_faces, int n_edges) {
  Scheme out;
  out.cost = division.cost;
  out.face_role.assign(n_faces, FaceRole::none);
  out.edge_role.assign(n_edges, EdgeRole::none);
  out.face.resize(n_faces);
  const SweepProblem& problem = network.problem;
  for (std::size_t f = 0; f < problem.faces.size(); ++f) {
    const int id = problem.faces[f].id.index;
    out.face_role[id] = role_of(division.choices.role[f]);
    if (out.face_role[id] == FaceRole::linking)
      out.face[id] = face_scheme(network, division, static_cast<int>(f));
  }
  for (const ProblemEdge& edge : problem.edges)
    out.edge_role[edge.id.index] = edge_role(network, division, edge);
  return out;
}

Rank rank_of(const Network& network, const Division& division, const RankOptions& options) {
  Rank out;
  const SweepProblem& problem = network.problem;
  int n_caps = 0, n_annuli = 0, n_seams = 0;
  for (std::size_t f = 0; f < problem.faces.size(); ++f) {
    const FaceRole role = role_of(division.choices.role[f]);
    if (role == FaceRole::linking) {
      n_annuli += is_annulus(face_scheme(network, division, static_cast<int>(f)));
      continue;
    }
    ++n_caps;
    out.cap_area += problem.faces[f].area;
    if (role == FaceRole::source) out.sources.push_back(problem.faces[f].id);
    const int first = problem.first_coedge(f);
    for (int c = first; c < first + problem.n_coedges(f); ++c)
      n_seams += problem.edges[problem.coedges[c].edge].is_seam;
  }
  out.burden = division.cost + options.per_extra_cap * (n_caps - 2) +
               options.per_annulus * n_annuli + options.per_cap_seam * n_seams / 2;
  constexpr double kStep = 1e-6;  // rounding in the angles must not decide the order
  out.burden = std::round(out.burden / kStep) * kStep;
  return out;
}

void turn_over(Division& division) {
  const auto flip = [](StateSet s) -> StateSet {
    return (s & 0b0011) << 2 | (s & 0b1100) >> 2 | (s & kSourceStates) << 1 |
           (s & kTargetStates) >> 1;
  };
  for (StateSet& s : division.choices.domain) s = flip(s);
  for (StateSet& r : division.choices.role)
    if (r != kLinkingStates) r = flip(r);
}

}  // namespace sweepmesh
