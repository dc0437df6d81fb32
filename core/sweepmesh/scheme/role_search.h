// All ways to divide the faces of a solid into sources, targets and linking faces, the cheapest first.
#pragma once

#include <vector>

#include "sweepmesh/scheme/levels.h"
#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

struct SearchOptions {
  /// Only schemes that cost no more than this (limits.h) are looked for.
  double max_cost = kImpossible;
  /// At most so many are kept, the cheapest ones; >= 1.
  int max_schemes = 12;
  /// Coedges looked at before the search ends as it stands (about a microsecond each); > 0. A count and no
  /// clock, so that the answer does not depend on the machine.
  long max_effort = 1'500'000;
  /// Sources and targets may be exchanged without harm (nothing tells them apart): half of the search is saved.
  bool is_symmetric = true;
};

/// One scheme: every coedge has one state. `cost` is exact.
struct Division {
  Choices choices;
  double cost = 0.0;
};

struct SearchResult {
  std::vector<Division> divisions;  ///< ascending cost; each with other roles
  bool is_complete = true;          ///< false where the effort ran out
  long effort = 0;                  ///< coedges looked at
  /// Why nothing was found where nothing was: the face without a choice before any branching, if that was so.
  std::optional<Conflict> conflict;
  /// Divisions that failed by their levels, for want of a source or target, by the Euler characteristic, by voids.
  int n_without_levels = 0, n_without_ends = 0, n_unbalanced = 0, n_voids_askew = 0;
};

/// Depth-first branch and bound over roles, then over states: propagation by single faces (network.h) gives the bound; the face
/// (then the coedge) whose best choice is the clearest is decided first. Branches whose decided part admits no levels are cut.
/// For the same roles only the cheapest states are kept. Exact within `max_cost` where `is_complete`.
/// `start` has been narrowed by the caller (picks); it need not be propagated.
SearchResult search_divisions(const Network& network, const Choices& start, const SearchOptions& options,
                              const Context& context);

/// The cheapest states where every role is given; empty where there are none.
SearchResult search_states(const Network& network, const Choices& start, const SearchOptions& options,
                           const Context& context);

}  // namespace sweepmesh
