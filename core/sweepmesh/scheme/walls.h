// Whether the walls of a sweep run the same way: the part of the geometric verdict that can be had
// before any mesh.
#pragma once

#include <optional>

#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

/// A straight axial edge, another axial edge (SweepProblem indices) between the same levels that
/// runs back against it, and how.
struct OpposedWalls {
  int straight = -1, other = -1;
  double angle = 0.0;  ///< the largest between the other's tangents and the straight one, radians
  double way_back = 0.0;  ///< along the straight one
  double gap = 0.0;       ///< the least distance between the two
};

/// The axial edges that join the same two levels bound the same layers. Where some of them are
/// straight and parallel and another runs back against them, by more than 100 degrees and over more
/// than kMostWayBack of the gap between, the layers there fold over (thesis figure 7.6): the worst
/// pair is returned. Less is no obstacle: a hole that leans over and recovers soon can be meshed,
/// as layers tilt (docs/assessment.md has the calibration). Nothing is said where no two walls tell
/// the direction (bends, radial sweeps). `choices` are decided.
std::optional<OpposedWalls> opposed_walls(const Network& network, const Choices& choices);

/// Of the gap: the longest way back that may still be meshed.
inline constexpr double kMostWayBack = 0.65;

/// Whether closed shells that share no edge agree on the way up: the mean axial directions of each
/// two shells that have axial edges differ by less than 60 degrees. Nothing but geometry relates a
/// void to the outside. `choices` are decided.
bool do_shells_agree(const Network& network, const Choices& choices);

}  // namespace sweepmesh
