#include "sweepmesh/scheme/assess.h"

#include <algorithm>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/to_scheme.h"

namespace sweepmesh {

namespace {

/// Costs up to which schemes are looked for, one after the other until one is found: with a low limit most choices are ruled out at once.
constexpr std::array kCostLimits = {2.0, 4.0, 8.0, 16.0, 64.0, kImpossible};

int index_of(const SweepProblem& problem, FaceId id) {
  const auto at = std::ranges::find(problem.faces, id, &ProblemFace::id);
  if (at == problem.faces.end())
    throw InputError("assess", name_of(id) + " is not a face of this solid.", {name_of(id)});
  return static_cast<int>(at - problem.faces.begin());
}

bool has_picks(const Picks& picks) {
  return !picks.sources.empty() || !picks.targets.empty() || !picks.pairs.empty();
}

void apply(const Picks& picks, const Network& network, Choices& choices) {
  std::vector<int> touched;
  const auto set = [&](FaceId id, StateSet role) {
    set_role(network, choices, index_of(network.problem, id), role, touched);
  };
  for (FaceId id : picks.sources) set(id, kSourceStates);
  for (FaceId id : picks.targets) set(id, kTargetStates);
  for (const auto& [source, target] : picks.pairs) {
    set(source, kSourceStates);
    set(target, kTargetStates);
  }
}

std::vector<Reason> open_edges(const SweepProblem& problem) {
  std::vector<std::string> entities;
  for (const ProblemEdge& edge : problem.edges)
    if (edge.coedge[1] < 0) entities.push_back(name_of(edge.id));
  if (entities.empty()) return {};
  return {{ReasonKind::unsupported,
           "Edges of this solid bound one face only, so its boundary is not closed: repair the "
           "shape.",
           entities}};
}

SearchResult search(const Network& network, const Choices& start, SearchOptions options,
                    const Context& context) {
  SearchResult result;
  for (double limit : kCostLimits) {
    options.max_cost = limit;
    result = search_divisions(network, start, options, context);
    options.max_effort -= result.effort;
    if (!result.divisions.empty() || options.max_effort <= 0) break;
  }
  return result;
}

std::vector<Scheme> ranked(const Model& model, const Network& network,
                           const std::vector<Division>& divisions) {
  std::vector<std::pair<Rank, const Division*>> order;
  for (const Division& d : divisions) order.emplace_back(rank_of(network, d), &d);
  std::ranges::sort(order, {}, &std::pair<Rank, const Division*>::first);
  std::vector<Scheme> out;
  for (const auto& [rank, d] : order)
    out.push_back(to_scheme(network, *d, model.n_faces(), model.n_edges()));
  return out;
}

}  // namespace

Assessment assess(const Model& model, const Picks& picks, Context& context) {
  SweepProblem problem = sweep_problem(model, context);
  if (auto reasons = open_edges(problem); !reasons.empty()) return {{}, reasons};
  const Network network = make_network(std::move(problem), strict_limits());
  Choices start = open_choices(network);
  apply(picks, network, start);
  SearchOptions options;
  options.is_symmetric = !has_picks(picks);
  const SearchResult result = search(network, start, options, context);
  if (!result.divisions.empty()) return {ranked(model, network, result.divisions), {}};
  return {{}, {{ReasonKind::topological, "No way to sweep this solid was found.", {}}}};
}

}  // namespace sweepmesh
