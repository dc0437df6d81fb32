// How many mesh edges each CAD edge would get if it were alone.
#pragma once

#include <vector>

#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Indexed by edge id; 0 for edges of other solids, else at least 1, not rounded: the length over
/// the size (the edge's own where it has one), or the angle through which the curve turns over
/// `max_turn` where that is more. Throws InputError for sizes that are not positive and finite,
/// counts below one, ratios of a bias that are not positive, and edges that the solid has not.
std::vector<double> wished_counts(const Model& model, const IntervalOptions& options);

/// How much the wish of an edge counts beside those of others: 1, or a thousand for an edge with a
/// size of its own, so that edges tied to it follow.
double importance(const IntervalOptions& options, EdgeId edge);

/// The least number that options.least_count asks for, 1 where it says nothing or the user has
/// given the count.
int least_count(const IntervalOptions& options, EdgeId edge);

/// Elements to expect: volume over size cubed, not less than the edges wished for all CAD edges.
/// For refusing absurd sizes before anything is built; cost: that of the edges' lengths.
double expected_elements(const Model& model, const IntervalOptions& options);

}  // namespace sweepmesh
