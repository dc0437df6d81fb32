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

double total_area(const SweepProblem& problem) {
  double out = 0.0;
  for (const ProblemFace& face : problem.faces) out += face.area;
  return out;
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

Rank rank_of(const Network& network, const Division& division) {
  Rank out;
  for (std::size_t f = 0; f < network.problem.faces.size(); ++f) {
    const FaceRole role = role_of(division.choices.role[f]);
    if (role == FaceRole::linking) continue;
    out.cap_area += network.problem.faces[f].area;
    if (role == FaceRole::source) out.sources.push_back(network.problem.faces[f].id);
  }
  constexpr double kStep = 1e-6;  // rounding in the measures must not decide the order
  out.cost = std::round(division.cost / kStep);
  out.cap_area = std::round(out.cap_area / (kStep * total_area(network.problem)));
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
