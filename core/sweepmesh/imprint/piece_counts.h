// The number of mesh edges on the pieces that CAD edges are divided into.
#pragma once

#include <vector>

#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/intervals/intervals.h"

namespace sweepmesh {

/// Of the edges of an imprint or of a shell.
struct PieceCounts {
  Intervals intervals;
  std::vector<int> edge;  ///< mesh edges on each of them, at least 1
};

/// The problem without its solution, for several solids that are counted together
/// (solve_together).
struct PieceDemands {
  IntervalDemands whole;
  std::vector<int> piece;  ///< by imprint or shell edge: its unknown
};

PieceCounts piece_counts(SolvedIntervals solved, const std::vector<int>& piece);

}  // namespace sweepmesh
