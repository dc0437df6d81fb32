#include "sweepmesh/scheme/reasons.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sweepmesh/scheme/vertex_types.h"

namespace sweepmesh {

namespace {

std::string joined(const std::vector<std::string>& names, std::size_t most = 8) {
  std::string out;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    out += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) out += " and " + std::to_string(names.size() - most) + " more";
  return out;
}

std::string degrees(double radians) {
  return std::to_string(std::lround(radians * 90 / kQuarterTurn)) + " degrees";
}

std::vector<std::string> faces_with(const Network& n, const Choices& choices, StateSet role) {
  std::vector<std::string> out;
  for (std::size_t f = 0; f < n.problem.faces.size(); ++f)
    if (choices.role[f] == role) out.push_back(name_of(n.problem.faces[f].id));
  return out;
}

std::string text_of(const TypePick& pick) {
  return name_of(pick.vertex) + " of " + name_of(pick.face) + " as " + name_of(pick.type);
}

std::vector<std::string> neighbours(const Network& n, int face) {
  std::set<FaceId> ids;
  const int first = n.problem.first_coedge(face);
  for (int c = first; c < first + n.problem.n_coedges(face); ++c)
    ids.insert(n.problem.faces[n.problem.coedges[n.problem.coedges[c].partner].face].id);
  ids.erase(n.problem.faces[face].id);
  std::vector<std::string> out;
  for (FaceId id : ids) out.push_back(name_of(id));
  return out;
}

/// Faces that cannot carry a structured grid, whatever their neighbours are.
std::vector<int> cap_only_faces(const Network& n, const Context& context) {
  Choices choices = open_choices(n);
  long effort = 0;
  propagate(n, kImpossible, all_faces(n), choices, effort, context, SearchOptions{}.max_effort);
  std::vector<int> out;
  for (int f : all_faces(n))
    if (!(choices.role[f] & kLinkingStates)) out.push_back(f);
  return out;
}

Reason no_linking_face(const Network& n) {
  int n_shells = 0;
  std::vector<std::string> all;
  for (const ProblemFace& face : n.problem.faces) {
    n_shells = std::max(n_shells, face.shell + 1);
    all.push_back(name_of(face.id));
  }
  std::string text =
      "No face of this solid can carry a structured grid, so nothing links a source with a "
      "target; ";
  text += n_shells == 1 ? "there is one closed shell only"
                        : "its " + std::to_string(n_shells) +
                              " closed shells are not two that map onto each other";
  return {ReasonKind::topological,
          text + ". Cut the solid, or split faces where the sweep is to turn.", all};
}

Reason face_without_role(const Network& n, int face) {
  const std::string name = name_of(n.problem.faces[face].id);
  std::vector<std::string> entities = neighbours(n, face);
  const std::string around = joined(entities);
  entities.insert(entities.begin(), name);
  return {ReasonKind::topological,
          name + " can be neither a source or target nor a linking face next to " + around +
              ". Split it, or cut the solid there.",
          entities};
}

/// The faces around it are named, too.
Reason torn_section(const Network& n, int vertex) {
  const std::string name = name_of(VertexId{vertex});
  std::vector<std::string> entities = {name};
  for (const ProblemCoedge& c : n.problem.coedges)
    if (c.end == vertex) entities.push_back(name_of(n.problem.faces[c.face].id));
  std::sort(entities.begin() + 1, entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
  return {ReasonKind::topological,
          "Sections of the solid fall apart into pieces that touch at " + name +
              " only, so no layers pass there. Cut the solid at " + name + ".",
          entities};
}

Reason summary(const Network& n, const Context& context) {
  std::vector<std::string> entities;
  for (int f : cap_only_faces(n, context)) entities.push_back(name_of(n.problem.faces[f].id));
  if (entities.empty())
    return {ReasonKind::topological,
            "No division of the faces into sources, targets and linking faces gives layers "
            "that grow from one end to the other. Cut the solid.",
            {}};
  return {
      ReasonKind::topological,
      joined(entities) +
          " cannot carry a structured grid and so would have to be sources or targets, but no "
          "such choice leaves faces that link them in layers. Split these faces, or cut the solid.",
      entities};
}

}  // namespace

std::vector<Reason> reasons_in_boundary(const SweepProblem& problem) {
  std::set<std::string> entities;
  for (const ProblemEdge& edge : problem.edges)
    if (edge.coedge[1] < 0) entities.insert(name_of(edge.id));
  for (const ProblemCoedge& coedge : problem.coedges)
    if (coedge.partner < 0) entities.insert(name_of(problem.edges[coedge.edge].id));
  if (entities.empty()) return {};
  return {{ReasonKind::unsupported,
           "Edges of this solid do not lie between two faces, so its boundary is not closed. "
           "Repair the shape.",
           {entities.begin(), entities.end()}}};
}

std::vector<Reason> reasons_in_picks(const SweepProblem& problem, const Picks& picks) {
  std::set<FaceId> sources(picks.sources.begin(), picks.sources.end());
  std::set<FaceId> targets(picks.targets.begin(), picks.targets.end());
  for (const auto& [s, t] : picks.pairs) {
    sources.insert(s);
    targets.insert(t);
  }
  std::vector<Reason> out;
  for (FaceId id : sources)
    if (targets.contains(id))
      out.push_back(
          {ReasonKind::prescribed,
           name_of(id) + " is picked as a source and as a target. Leave it in one of them.",
           {name_of(id)}});
  if (!out.empty()) return out;
  for (const ProblemEdge& edge : problem.edges) {
    FaceId a = problem.faces[problem.coedges[edge.coedge[0]].face].id;
    FaceId b = problem.faces[problem.coedges[edge.coedge[1]].face].id;
    if (!sources.contains(a)) std::swap(a, b);
    if (sources.contains(a) && targets.contains(b))
      out.push_back({ReasonKind::prescribed,
                     "Source " + name_of(a) + " and target " + name_of(b) + " share " +
                         name_of(edge.id) +
                         ", where no linking face is between them. Pick other faces.",
                     {name_of(a), name_of(b), name_of(edge.id)}});
  }
  return out;
}

Reason reason_of_walls(const Network& n, const OpposedWalls& walls) {
  const auto name = [&](int e) { return name_of(n.problem.edges[e].id); };
  std::vector<std::string> entities = {name(walls.other), name(walls.straight)};
  for (int c : n.problem.edges[walls.other].coedge) {
    const std::string face = name_of(n.problem.faces[n.problem.coedges[c].face].id);
    if (std::ranges::find(entities, face) == entities.end())
      entities.insert(entities.begin(), face);
  }
  return {ReasonKind::geometric,
          "The wall at " + name(walls.other) + " runs back against the sweep (" +
              degrees(walls.angle) + " to " + name(walls.straight) +
              "), so layers would fold over each other. Cut the solid where the wall turns back.",
          entities};
}

std::vector<Reason> reasons_of_failure(const Network& network, const SearchResult& result,
                                       const Context& context) {
  std::vector<Reason> out;
  if (!result.is_complete)
    out.push_back(
        {ReasonKind::unsupported,
         "The search for sources and targets was given up before all choices were seen. Pick "
         "some sources or targets.",
         {}});
  if (result.rejections.walls) out.push_back(reason_of_walls(network, *result.rejections.walls));
  if (!out.empty()) return out;
  if (result.rejections.torn) return {torn_section(network, *result.rejections.torn)};
  if (cap_only_faces(network, context).size() == network.problem.faces.size())
    return {no_linking_face(network)};
  if (result.conflict) return {face_without_role(network, result.conflict->face)};
  return {summary(network, context)};
}

Reason angle_reason(const Network& network, const Division& division) {
  std::vector<std::string> entities, texts;
  const std::vector<PairCosts> strict = pair_costs(network.problem, strict_limits());
  for (std::size_t e = 0; e < network.problem.edges.size(); ++e) {
    const ProblemEdge& edge = network.problem.edges[e];
    const int a = first_state(division.choices.domain[edge.coedge[0]]);
    const int b = first_state(division.choices.domain[edge.coedge[1]]);
    if (strict[e][a][b] < kImpossible) continue;
    entities.push_back(name_of(edge.id));
    texts.push_back(name_of(edge.id) + " (" + degrees(edge.mean) + ")");
  }
  return {
      ReasonKind::geometric,
      "The faces could be swept from " +
          joined(faces_with(network, division.choices, kTargetStates)) + " to " +
          joined(faces_with(network, division.choices, kSourceStates)) +
          " only with layers forced over angles that are too far from what the sweep needs, at " +
          joined(texts) + ".",
      entities};
}

Reason pick_reason(const Network& network, const std::vector<FaceId>& blamed,
                   const Division& best) {
  constexpr std::size_t all = 1000;  // somebody is to pick them
  std::vector<std::string> entities;
  for (FaceId id : blamed) entities.push_back(name_of(id));
  return {ReasonKind::prescribed,
          "The solid can be swept, but not with " + joined(entities) + " as picked. It can with " +
              joined(faces_with(network, best.choices, kSourceStates), all) + " as sources and " +
              joined(faces_with(network, best.choices, kTargetStates), all) + " as targets.",
          entities};
}

Reason type_reason(const std::vector<TypePick>& blamed, const std::optional<TypePick>& instead) {
  Reason out{ReasonKind::prescribed, {}, {}};
  std::string list;
  for (const TypePick& pick : blamed) {
    list += (list.empty() ? "" : ", ") + text_of(pick);
    out.entities.push_back(name_of(pick.vertex));
    out.entities.push_back(name_of(pick.face));
  }
  out.text =
      "The solid can be swept, but not with " + list + ". " +
      (instead ? "It can with " + text_of(*instead) + "." : "Free one of these vertex types.");
  return out;
}

}  // namespace sweepmesh
