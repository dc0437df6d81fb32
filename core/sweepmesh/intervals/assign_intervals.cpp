#include "sweepmesh/intervals/assign_intervals.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "sweepmesh/intervals/areas.h"
#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/intervals/separation.h"

namespace sweepmesh {
namespace {

const char* const stage = "intervals";

void append_once(std::vector<std::string>& list, const std::string& item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

struct Conflict {
  std::string sentence;
  std::vector<std::string> entities;
};

Conflict described(const CountProblem& problem, const std::vector<int>& conflict) {
  std::vector<std::string> entities, texts;
  for (const int d : conflict) {
    for (const auto& e : problem.demands[d].entities) append_once(entities, e);
    append_once(texts, problem.demands[d].text);
  }
  const std::size_t n_shown = 6;
  std::string sentence = "The numbers of mesh edges contradict each other: ";
  for (std::size_t t = 0; t < std::min(n_shown, texts.size()); ++t)
    sentence += (t == 0 ? "" : "; ") + texts[t];
  if (texts.size() > n_shown)
    sentence += "; and " + std::to_string(texts.size() - n_shown) + " more";
  return {sentence + ".", entities};
}

/// The order of some face's sides is too much to ask: what was found without it is used, and its
/// grid will tell whether it can do without.
void note_unmet(const CountProblem& problem, CountOptions how, Context& context, Intervals& out) {
  how.explain = true;
  const CountSolution solution = solve_counts(problem, how, context);
  if (solution.is_feasible) return;
  const Conflict conflict = described(problem, solution.conflict);
  out.unmet = conflict.sentence;
  out.unmet_entities = conflict.entities;
}

Intervals to_intervals(const IntervalDemands& demands, const CountSolution& solution) {
  Intervals out;
  out.is_optimal = solution.is_optimal;
  for (const int u : demands.edge)
    out.edge.push_back(u < 0 ? 0 : static_cast<int>(solution.values[u]));
  long low = std::numeric_limits<long>::max(), high = std::numeric_limits<long>::min();
  for (const int u : demands.vertex) {
    if (u < 0) continue;
    low = std::min(low, solution.values[u]);
    high = std::max(high, solution.values[u]);
  }
  for (const int u : demands.vertex)
    out.k.push_back(u < 0 ? -1 : static_cast<int>(solution.values[u] - low));
  for (const auto& loops : demands.offset) {
    out.loop_i.emplace_back();
    for (const int u : loops)
      out.loop_i.back().push_back(u < 0 ? 0 : static_cast<int>(solution.values[u]));
  }
  out.n_layers = static_cast<int>(high - low);
  return out;
}

}  // namespace

SolvedIntervals solve_intervals(const Model& model, const Scheme& scheme, IntervalDemands demands,
                                const IntervalOptions& options, Context& context) {
  context.check(stage);
  const Separation separation(model, scheme, options.size);
  separation.add_gaps(demands);
  CountOptions how;
  how.time_limit_seconds = options.time_limit_seconds.value_or(unbounded);
  const int max_rounds = 30;  // each adds order to faces whose sides cross; a few are the rule
  std::optional<SolvedIntervals> best;
  for (int round = 0; round < max_rounds; ++round) {
    context.report(static_cast<double>(round) / max_rounds, "Assigning numbers of mesh edges");
    const CountSolution solution = solve_counts(demands.problem, how, context);
    if (!solution.is_feasible) {
      if (best) {
        note_unmet(demands.problem, how, context, best->intervals);
        break;
      }
      const Conflict conflict = described(demands.problem, solution.conflict);
      throw SolverError(stage, conflict.sentence, conflict.entities);
    }
    best = {to_intervals(demands, solution), solution.values};
    how.explain = false;
    const int n_coarse = raise_for_areas(model, options, best->intervals.edge, demands);
    if (separation.add_violated(solution, demands) + n_coarse == 0) break;
  }
  return std::move(*best);
}

Intervals assign_intervals(const Model& model, const Scheme& scheme, const IntervalOptions& options,
                           Context& context) {
  context.check(stage);
  return solve_intervals(model, scheme, interval_demands(model, scheme, options), options, context)
      .intervals;
}

}  // namespace sweepmesh
