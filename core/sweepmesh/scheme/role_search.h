// All ways to divide the faces of a solid into sources, targets and linking faces, the cheapest
// first.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/scheme/levels.h"
#include "sweepmesh/scheme/network.h"
#include "sweepmesh/scheme/walls.h"

namespace sweepmesh {

struct SearchOptions {
  /// Only schemes that cost no more than this (limits.h) are looked for.
  double max_cost = kImpossible;
  /// At most so many are kept, the cheapest ones; >= 1.
  int max_schemes = 12;
  /// Steps before the search ends as it stands (about ten nanoseconds each); > 0. A count and no
  /// clock, so that the answer does not depend on the machine.
  long max_effort = 40'000'000;
  /// Sources and targets may be exchanged without harm (nothing tells them apart): half of the
  /// search is saved.
  bool is_symmetric = true;
};

/// One scheme: every coedge has one state. `cost` is exact.
struct Division {
  Choices choices;
  double cost = 0.0;
};

/// Why complete divisions were turned down, and an example of each.
struct Rejections {
  int n_without_levels = 0;  ///< k would have to grow around a cycle (partial divisions count too)
  int n_without_ends =
      0;  ///< no source, no target, or a closed shell that is a cap where it cannot be
  int n_unbalanced = 0;      ///< sources and targets are not homeomorphic (is_euler_balanced)
  int n_torn = 0;            ///< columns part at a vertex (torn_vertex)
  int n_voids_askew = 0;     ///< two shells disagree on the way up
  int n_without_counts = 0;  ///< no numbers of mesh edges fit (do_counts_exist)
  int n_walls_opposed = 0;
  std::optional<int> torn;  ///< the first vertex (SweepProblem index) at which columns part
  std::optional<OpposedWalls> walls;  ///< the first pair of walls that run against each other
};

struct SearchResult {
  std::vector<Division> divisions;  ///< ascending cost; each with other roles
  bool is_complete = true;          ///< false where the effort ran out
  long effort = 0;                  ///< steps taken
  /// Why nothing was found where nothing was: the face without a choice before any branching, if
  /// that was so.
  std::optional<Conflict> conflict;
  Rejections rejections;
};

/// Depth-first branch and bound over roles, then over states: propagation by single faces
/// (network.h) gives the bound; the face (then the coedge) whose best choice is the clearest is
/// decided first. Branches whose decided part admits no levels are cut. For the same roles only the
/// cheapest states are kept. Exact within `max_cost` where `is_complete`. `start` has been narrowed
/// by the caller (picks); it need not be propagated.
SearchResult search_divisions(const Network& network, const Choices& start,
                              const SearchOptions& options, Context& context);

/// The cheapest states where every role is given; empty where there are none.
SearchResult search_states(const Network& network, const Choices& start,
                           const SearchOptions& options, Context& context);

}  // namespace sweepmesh
