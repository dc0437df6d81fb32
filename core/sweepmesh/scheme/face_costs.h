// What each state of each coedge of a face costs at least, all loops and all roles of the face
// considered.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/scheme/states.h"
#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {

using StateCosts = std::array<double, kStates>;

struct FaceCosts {
  double best = kImpossible;
  /// Per coedge of the face: least cost of the whole face with the coedge in that state.
  std::vector<StateCosts> marginal;
  long work = 0;  ///< LoopMarginals::work, all loops together

  double of_role(FaceRole role) const;
};

/// `coedge_cost[j]` is the cost of each state of the face's coedge j alone (kImpossible: ruled
/// out); `corner_cost[j]` that of the four types at its end (loop_program.h).
///
/// As a source or a target the face costs the sum over its coedges and Preferences::per_cap. As a
/// linking face its loops are independent but for:
/// - sums of types: 4 for the outer loop and -4 for each hole (together 4 - 4 g), or, where the
/// grid closes upon itself around
///   a hole, 0 for the outer loop and that hole (an annulus: k grows from one to the other) and -4
///   for the others;
/// - one frame: the i direction of a hole is that of the outer loop, carried over by the headings.
/// It may be off by up to
///   75 degrees, more than half a quarter turn, as edges are bent.
/// What costs more than `limit` may be infinite instead. A face with a pole is no linking face.
/// Exact for these rules. In an annulus a loop that turns back on itself in i is not considered.
FaceCosts face_costs(const SweepProblem& problem, int face,
                     const std::vector<StateCosts>& coedge_cost,
                     const std::vector<std::array<double, 4>>& corner_cost,
                     const Preferences& preferences = {}, double limit = kImpossible);

}  // namespace sweepmesh
