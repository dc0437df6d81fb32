// Counts on curved edges, so that small plane faces keep their areas.
//
// A mesh edge is a chord. On a segment of a circle that is little larger than the size, length and
// turn of the arc ask for one or two chords, and a fifth of the face's area is gone.
#pragma once

#include <vector>

#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Indexed by edge id: the counts that curved edges of plane faces need so that their chords miss
/// no face's area by more than `max_area_error`, at most six times the wish; 0 where the wish will
/// do. `wishes` as in wishes.h. Cost: some fifty points a coedge of plane faces.
std::vector<double> area_counts(const Model& model, const IntervalOptions& options,
                                const std::vector<double>& wishes);

/// Where counts that were chosen miss a face's area by a little more than that, raises the lowest
/// counts of those edges whose chords are to blame, but for those that the user has given counts.
/// `counts` by edge id. Returns how many were raised.
int raise_for_areas(const Model& model, const IntervalOptions& options,
                    const std::vector<int>& counts, IntervalDemands& demands);

}  // namespace sweepmesh
