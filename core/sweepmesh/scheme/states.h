// The states that a coedge can be in, and what each pair of states costs across an edge.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sweepmesh/scheme/limits.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {

/// 0 to 3: the direction on a linking face (static_cast<Direction>); then: the face is a source, a
/// target.
inline constexpr int kSourceState = 4, kTargetState = 5, kStates = 6;

/// Bit s stands for state s.
using StateSet = std::uint8_t;
inline constexpr StateSet kLinkingStates = 0b001111, kSourceStates = 0b010000,
                          kTargetStates = 0b100000, kAllStates = 0b111111;

inline constexpr double kImpossible = std::numeric_limits<double>::infinity();

inline StateSet states_of(FaceRole role) {
  return role == FaceRole::source   ? kSourceStates
         : role == FaceRole::target ? kTargetStates
                                    : kLinkingStates;
}
inline bool has(StateSet set, int state) {
  return set >> state & 1;
}
inline bool is_single(StateSet set) {
  return set != 0 && (set & (set - 1)) == 0;
}
/// The lowest state of a set that is not empty.
int first_state(StateSet set);

/// What makes a sweep hard besides its angles, in the same unit as their cost (squared quarter
/// turns).
struct Preferences {
  double per_cap = 0.5;  ///< every cap: those beyond one source and one target have to be imprinted
  double per_annulus = 0.5;   ///< linking face whose grid closes upon itself around a hole
  double per_cap_seam = 0.5;  ///< seam inside a cap: its mesh has to close upon itself
};

/// cost[a][b]: state a on the edge's coedge[0] and b on its coedge[1]; kImpossible where they
/// cannot meet.
using PairCosts = std::array<std::array<double, kStates>, kStates>;

/// Rules of the sweep:
/// - two linking faces: opposite directions; transverse edges are SIDE edges, axial ones have any
/// angle;
/// - linking face and cap: a transverse edge, END where the face is on the cap's material side of
/// the level (below a
///   source: -i, above a target: +i), CORNER where it rises from a source (+i) or hangs from a
///   target (-i);
/// - two caps of one kind: a SIDE edge; a source and a target never meet;
/// - a closed edge is not axial: k cannot grow around it.
PairCosts pair_costs(const ProblemEdge& edge, const AngleLimits& limits,
                     const Preferences& preferences = {});
std::vector<PairCosts> pair_costs(const SweepProblem& problem, const AngleLimits& limits,
                                  const Preferences& preferences = {});

}  // namespace sweepmesh
