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

/// One of several solids whose numbers are found together.
struct IntervalPart {
  const Model& model;
  const Scheme& scheme;
  const IntervalOptions& options;
  IntervalDemands demands;
};
/// Edges of two parts that get the same number: one edge where the solids share it.
struct EqualCounts {
  int part = 0, other_part = 0;
  EdgeId edge, other_edge;
};
/// The same for all parts as one problem, their layers independent of each other; by part.
std::vector<SolvedIntervals> solve_together(std::vector<IntervalPart> parts,
                                            const std::vector<EqualCounts>& ties, Context& context);

}  // namespace sweepmesh
