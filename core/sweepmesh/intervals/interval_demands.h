// The interval problem of a whole solid: what the sweep and its structured sides demand of the
// counts.
#pragma once

#include <vector>

#include "sweepmesh/intervals/count_problem.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// The problem, and which unknown is which (-1 where an entity has none).
struct IntervalDemands {
  CountProblem problem;
  std::vector<int> edge;    ///< unknown: number of mesh edges, by edge id
  std::vector<int> vertex;  ///< unknown: layer k, by vertex id
  /// Per face id and loop: unknown i of the loop's first vertex relative to that of loop 0; -1
  /// where the face is not linking or the loop is the first.
  std::vector<std::vector<int>> offset;
};

/// Demands:
///  - a transverse edge and a cap's boundary keep k; an axial edge's count is the rise of k along
///  it;
///  - on each linking face the steps to +i and -i cancel loop by loop; where two loops wind around
///  a
///    tube they cancel together, and the upper one lies at least a layer above the lower;
///  - quad caps: an even sum around all loops, preferably around each, and no loop below four;
///  - closed edges get at least three; user's counts and number of layers.
/// Roles `none` demand nothing beyond the caps' sums. Throws what wished_counts throws, and
/// InputError for a linking face with a pole (a degenerate edge).
IntervalDemands interval_demands(const Model& model, const Scheme& scheme,
                                 const IntervalOptions& options);

/// Sum of the turns of a loop, in quarter turns: 4 for an outer loop, -4 for a hole, 0 for a loop
/// that winds around a tube.
int turning_of(const FaceScheme& face, std::size_t loop);

}  // namespace sweepmesh
