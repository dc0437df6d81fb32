// More mesh edges where a mesh of the surface covers CAD faces poorly.
#pragma once

#include <vector>

#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/quality/face_coverage.h"

namespace sweepmesh {

/// Raises options.least_count for the faces whose area `coverage` misses by more than what is good
/// enough for a start (a little less than kMostAreaDeviation), where the mesh has the counts of
/// `intervals`: on edges whose chords are to blame, on all of a face's where it bulges between
/// straight ones. Chords miss an area by the square of their length, which says how many more are
/// needed; at most twice as many. Edges to which the user gave a count or a size stay. False where
/// there is nothing to raise.
bool raise_for_coverage(const Model& model, const std::vector<FaceCoverage>& coverage,
                        const Intervals& intervals, IntervalOptions& options);

/// Whether a mesh of the surface is to be made again, with more edges.
bool is_poorly_covered(const std::vector<FaceCoverage>& coverage);

}  // namespace sweepmesh
