#include "sweepmesh/intervals/assign_intervals.h"

#include <algorithm>
#include <limits>
#include <numeric>

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

std::vector<int> all_demands(const CountProblem& problem) {
  std::vector<int> out(problem.demands.size());
  std::iota(out.begin(), out.end(), 0);
  return out;
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

/// The problems of all parts as one, in which tied edges have one number.
struct JointProblem {
  CountProblem problem;
  std::vector<std::size_t> first;  ///< by part, and one more: its first unknown

  JointProblem(const std::vector<IntervalPart>& parts, const std::vector<EqualCounts>& ties) {
    for (const IntervalPart& part : parts) add(part.demands.problem);
    first.push_back(problem.unknowns.size());
    for (const EqualCounts& tie : ties) {
      const int a = unknown(parts, tie.part, tie.edge);
      const int b = unknown(parts, tie.other_part, tie.other_edge);
      const std::string one = name_of(tie.edge), two = name_of(tie.other_edge);
      problem.demand({CountProblem::Kind::equality,
                      {{a, 1.0}, {b, -1.0}},
                      0.0,
                      {one, two},
                      one + " must have the same mesh edges on both of its solids"});
    }
  }

  CountSolution of_part(const CountSolution& all, std::size_t part) const {
    CountSolution out = all;
    out.values.assign(all.values.begin() + first[part], all.values.begin() + first[part + 1]);
    return out;
  }

 private:
  void add(const CountProblem& part) {
    const int shift = static_cast<int>(problem.unknowns.size());
    first.push_back(problem.unknowns.size());
    problem.unknowns.insert(problem.unknowns.end(), part.unknowns.begin(), part.unknowns.end());
    for (CountProblem::Demand d : part.demands) {
      for (auto& term : d.terms) term.variable += shift;
      problem.demand(std::move(d));
    }
  }

  int unknown(const std::vector<IntervalPart>& parts, int part, EdgeId edge) const {
    return static_cast<int>(first[part]) + parts[part].demands.edge[edge.index];
  }
};

std::vector<SolvedIntervals> solved_parts(const std::vector<IntervalPart>& parts,
                                          const JointProblem& joint,
                                          const CountSolution& solution) {
  std::vector<SolvedIntervals> out;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    CountSolution own = joint.of_part(solution, p);
    out.push_back({to_intervals(parts[p].demands, own), std::move(own.values)});
  }
  return out;
}

}  // namespace

std::vector<SolvedIntervals> solve_together(std::vector<IntervalPart> parts,
                                            const std::vector<EqualCounts>& ties,
                                            Context& context) {
  context.check(stage);
  std::vector<Separation> separations;
  for (IntervalPart& part : parts) {
    separations.emplace_back(part.model, part.scheme, part.options.size);
    separations.back().add_gaps(part.demands);
  }
  CountOptions how;
  how.time_limit_seconds = parts.front().options.time_limit_seconds.value_or(unbounded);
  const int max_rounds = 30;  // each adds order to faces whose sides cross; a few are the rule
  how.any_will_do = parts.front().options.is_trial;
  how.explain = !how.any_will_do;
  std::vector<SolvedIntervals> best;
  for (int round = 0; round < max_rounds; ++round) {
    context.report(static_cast<double>(round) / max_rounds, "Assigning numbers of mesh edges");
    const JointProblem joint(parts, ties);
    const CountSolution solution = solve_counts(joint.problem, how, context);
    if (!solution.is_feasible) {
      if (!best.empty()) {
        if (!how.any_will_do)
          for (SolvedIntervals& part : best)
            note_unmet(joint.problem, how, context, part.intervals);
        break;
      }
      const Conflict conflict =
          described(joint.problem, how.explain ? solution.conflict : all_demands(joint.problem));
      throw SolverError(stage, conflict.sentence, conflict.entities);
    }
    best = solved_parts(parts, joint, solution);
    how.explain = false;
    int n_wrong = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      IntervalPart& part = parts[p];
      best[p].intervals.crossed = separations[p].crossed(joint.of_part(solution, p), part.demands);
      n_wrong += raise_for_areas(part.model, part.options, best[p].intervals.edge, part.demands) +
                 separations[p].add_violated(joint.of_part(solution, p), part.demands);
    }
    if (n_wrong == 0) break;
  }
  return best;
}

SolvedIntervals solve_intervals(const Model& model, const Scheme& scheme, IntervalDemands demands,
                                const IntervalOptions& options, Context& context) {
  return std::move(
      solve_together({{model, scheme, options, std::move(demands)}}, {}, context).front());
}

Intervals assign_intervals(const Model& model, const Scheme& scheme, const IntervalOptions& options,
                           Context& context) {
  context.check(stage);
  return solve_intervals(model, scheme, interval_demands(model, scheme, options), options, context)
      .intervals;
}

}  // namespace sweepmesh
