#include "sweepmesh/intervals/count_conflict.h"

#include <algorithm>
#include <numeric>

namespace sweepmesh {
namespace {

using Set = std::vector<int>;

class Explainer {
 public:
  Explainer(const CountProblem& problem, const CountOptions& options, Context& context)
      : problem_(problem), options_(options), context_(context) {}

  bool is_consistent(const Set& demands) const {
    CountProblem part;
    part.unknowns = problem_.unknowns;
    for (auto& u : part.unknowns) u.wish.reset();
    for (const int d : demands) part.demands.push_back(problem_.demands[d]);
    return is_feasible(part, options_, context_);
  }

  /// The members of `candidates` that a conflict with `background` needs. `has_delta`: the
  /// background was just enlarged, so it may be inconsistent alone.
  Set explain(const Set& background, const Set& candidates, bool has_delta) const {
    if (has_delta && !is_consistent(background)) return {};
    if (candidates.size() <= 1) return candidates;
    const auto middle = candidates.begin() + static_cast<long>(candidates.size() / 2);
    const Set first(candidates.begin(), middle), second(middle, candidates.end());
    const Set of_second = explain(joined(background, first), second, !first.empty());
    const Set of_first = explain(joined(background, of_second), first, !of_second.empty());
    return joined(of_first, of_second);
  }

 private:
  static Set joined(Set a, const Set& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  const CountProblem& problem_;
  const CountOptions& options_;
  Context& context_;
};

}  // namespace

std::vector<int> smallest_conflict(const CountProblem& problem, const CountOptions& options,
                                   Context& context) {
  Set all;
  for (std::size_t d = 0; d < problem.demands.size(); ++d)
    if (problem.demands[d].kind != CountProblem::Kind::preferably_even)
      all.push_back(static_cast<int>(d));
  const Explainer explainer(problem, options, context);
  if (!explainer.is_consistent({})) return all;
  Set found = explainer.explain({}, all, false);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace sweepmesh
