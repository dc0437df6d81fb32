// What the user wishes of the number of mesh edges.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sweepmesh/base/ids.h"

namespace sweepmesh {

/// How the nodes of one edge are spaced: each interval is `ratio` times as long as the one before.
struct Bias {
  double ratio =
      1.0;  ///< > 0; 1 is even, above 1 the intervals grow from the edge's start to its end
  bool symmetric =
      false;  ///< grow (ratio above 1) from both ends to the middle, or shrink (below 1)
};

struct IntervalOptions {
  double size = 1.0;  ///< wished length of a mesh edge, > 0
  std::optional<int> layers =
      {};  ///< from the lowest to the highest level, >= 1; empty: from the sizes
  std::map<EdgeId, double> edge_size = {};  ///< wished length on chosen edges, > 0
  std::map<EdgeId, int> edge_count = {};    ///< exact number of mesh edges on chosen edges, >= 1
  /// At least so many mesh edges on chosen edges, >= 1; of no effect on edges of edge_count.
  std::map<EdgeId, int> least_count = {};
  std::map<EdgeId, Bias> edge_bias = {};  ///< spacing on chosen edges; others are spaced evenly
  /// Spacing along the sweep: on every axial edge that has none of its own, read from the lower to
  /// the higher layer whichever way the edge runs.
  std::optional<Bias> sweep_bias = {};
  /// Pairs of edges that must get the same number, besides those that the linking faces tie
  /// together.
  std::vector<std::pair<EdgeId, EdgeId>> equal_edges = {};
  /// The largest angle, in radians, by which a mesh edge should turn along a curved edge, > 0. The
  /// default gives a full circle ten edges, whose polygon has 94 % of its area.
  double max_turn = 0.65;
  /// The largest part of a plane face's area, 0 to 1, by which the chords along its curved edges
  /// should miss it: small segments of circles need more edges than their length and turn say.
  double max_area_error = 0.07;
  bool quad_caps = true;  ///< caps are meshed by quads: their boundaries need even sums
  /// Only whether there are counts is asked: the first ones found will do. Where there are none,
  /// all demands are named instead of the fewest that contradict each other, which take a few dozen
  /// times as long to find.
  bool is_trial = false;
  /// Seconds for the integer solver, for each independent part, > 0; empty: only its work is
  /// limited, so the counts do not depend on the machine.
  std::optional<double> time_limit_seconds = {};
};

}  // namespace sweepmesh
