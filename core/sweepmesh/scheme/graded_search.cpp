#include "sweepmesh/scheme/graded_search.h"

#include <algorithm>

namespace sweepmesh {
namespace {

/// Costs up to which schemes are looked for, one after the other until one is found: with a low
/// limit most choices are ruled out at once, and a solid with many rounds to turn at has a high
/// cost.
constexpr std::array kCostLimits = {2.0,   4.0,   8.0,   16.0,   32.0,   64.0,
                                    128.0, 256.0, 512.0, 1024.0, 2048.0, kImpossible};

/// Schemes that cost so much more than the best are offered too.
constexpr double kOffered = 2.0;

SearchResult search_within(const Network& network, const Choices& start, SearchOptions options,
                           Context& context, long& effort) {
  SearchResult result;
  const auto look = [&](double limit) {
    options.max_cost = limit;
    SearchResult found = search_divisions(network, start, options, context);
    effort += found.effort;
    options.max_effort -= found.effort;
    return found;
  };
  for (double limit : kCostLimits) {
    result = look(limit);
    if (!result.divisions.empty() || options.max_effort <= 0) break;
  }
  if (result.divisions.empty() || options.max_effort <= 0) return result;
  SearchResult wider = look(std::max(options.max_cost, result.divisions.front().cost + kOffered));
  return wider.is_complete ? wider : result;
}

}  // namespace

SearchResult graded_search(const Network& network, const std::vector<Pick>& picks,
                           SearchBudget& budget, Context& context, double share) {
  SearchOptions options;
  options.max_effort = std::max(1L, static_cast<long>(share * (budget.left / 2)));
  options.is_symmetric = std::ranges::none_of(picks, is_cap);
  long effort = 0;
  SearchResult out = search_within(network, start_of(network, picks), options, context, effort);
  budget.left = std::max(0L, budget.left - effort);
  return out;
}

}  // namespace sweepmesh
