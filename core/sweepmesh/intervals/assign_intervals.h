// Numbers of mesh edges for the whole solid at once.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Whole numbers that meet the demands of interval_demands.h and deviate from the wished counts as
/// count_problem.h weighs it. k of every vertex on a linking face or a cap's boundary; the lowest
/// is 0. Throws InputError for options that make no sense and for linking faces with a pole, and
/// SolverError where the demands contradict each other: it names a smallest set of them, and the
/// entities concerned.
Intervals assign_intervals(const Model& model, const Scheme& scheme, const IntervalOptions& options,
                           Context& context);

/// The same for interval_demands that the caller has changed or added to.
struct SolvedIntervals {
  Intervals intervals;
  std::vector<long> values;  ///< of all unknowns of the problem
};
SolvedIntervals solve_intervals(const Model& model, const Scheme& scheme, IntervalDemands demands,
                                const IntervalOptions& options, Context& context);

}  // namespace sweepmesh
