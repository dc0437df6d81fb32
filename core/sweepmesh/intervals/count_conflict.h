// Why a problem of counts has no solution: a smallest set of demands that contradict each other.
#pragma once

#include <vector>

#include "sweepmesh/intervals/count_problem.h"

namespace sweepmesh {

/// Whether all demands can be met at once.
bool is_feasible(const CountProblem& problem, const CountOptions& options, Context& context);

/// Indices, ascending, of demands of an infeasible problem such that these alone are infeasible and
/// none of them can be spared. QuickXplain (Junker, "Preferred explanations and relaxations for
/// over-constrained problems", 2004): about 2 m log(n / m) feasibility tests for m of n demands.
/// Never empty: the bounds alone being infeasible gives every demand.
std::vector<int> smallest_conflict(const CountProblem& problem, const CountOptions& options,
                                   Context& context);

}  // namespace sweepmesh
