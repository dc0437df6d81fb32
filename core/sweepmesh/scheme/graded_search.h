// The search for divisions with a rising limit of cost, and within what a whole verdict may take.
#pragma once

#include <vector>

#include "sweepmesh/scheme/asked.h"
#include "sweepmesh/scheme/role_search.h"

namespace sweepmesh {

/// Steps (SearchOptions::max_effort) that are left to all searches of one verdict: about a quarter
/// of a second. Each search may take half of what is left, so the first, which matters most, has
/// most, and none is without.
struct SearchBudget {
  long left = 48'000'000;
};

/// Raises the limit of cost until something is found, then looks once more for what is nearly as
/// good. `share` of what a search may take, 0..1. What it took is taken from the budget.
SearchResult graded_search(const Network& network, const std::vector<Pick>& picks,
                           SearchBudget& budget, Context& context, double share = 1.0);

}  // namespace sweepmesh
