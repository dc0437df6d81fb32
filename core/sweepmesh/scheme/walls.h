// Whether the walls of a sweep run the same way: the part of the geometric verdict that can be had
// before any mesh.
#pragma once

#include <optional>

#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

/// A straight axial edge, another axial edge (SweepProblem indices) between the same levels, and
/// the largest angle between the latter's tangents and the former, radians.
struct OpposedWalls {
  int straight = -1, other = -1;
  double angle = 0.0;
};

/// The axial edges that join the same two levels bound the same layers. Where some of them are
/// straight and parallel and another runs back against them, by more than 100 degrees, the layers
/// between must fold over (thesis figure 7.6): that pair is returned. Nothing is said where no two
/// walls tell the direction (bends, radial sweeps), nor between 90 and 100 degrees: there placement
/// decides. `choices` are decided.
std::optional<OpposedWalls> opposed_walls(const Network& network, const Choices& choices);

/// Whether closed shells that share no edge agree on the way up: the mean axial directions of each
/// two shells that have axial edges differ by less than 60 degrees. Nothing but geometry relates a
/// void to the outside. `choices` are decided.
bool do_shells_agree(const Network& network, const Choices& choices);

}  // namespace sweepmesh
