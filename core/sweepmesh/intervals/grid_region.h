// Rectilinear regions of the integer (i, k) plane: from their boundary to nodes and cells.
//
//          k                      A loop is a closed walk of unit steps with the region on its
//          left.
//      3   o--o--o                Nodes of the boundary are told apart by their place in the walk,
//          |  |  |                not by (i, k): the two sides of a slit (REVERSAL) lie on the same
//      2   o--o--o  o--o--o       numbers and are different nodes. On a tube, i counts modulo the
//          |  |  |  |  |  |       number of steps around it.
//      1   o--o--o--o--o--o
//          |  |  |  |  |  |
//      0   o--o--o--o--o--o   i
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct GridPoint {
  int i = 0, k = 0;
  auto operator<=>(const GridPoint&) const = default;
};

/// The point one step on.
GridPoint stepped(GridPoint p, Direction d);

struct GridLoop {
  GridPoint start;
  std::vector<Direction> steps;  ///< unit steps; ends where it starts (modulo the period)
};

struct GridRegion {
  /// First those of the loops, loop by loop in the order of steps (node j of a loop is where its
  /// step j starts), then the interior ones by rising k, then i.
  std::vector<GridPoint> nodes;
  int n_boundary = 0;
  /// Corners (i,k), (i+1,k), (i+1,k+1), (i,k+1): counterclockwise.
  std::vector<std::array<int, 4>> cells;
};

/// The region that the loops bound, or nothing where they bound none: a loop that is not closed,
/// runs the wrong way round, or touches or crosses itself or another (slits are allowed), a hole
/// outside. `period` is the number of steps around a tube, 0 for a plane region. Cost: the bounding
/// box's area.
std::optional<GridRegion> fill_region(const std::vector<GridLoop>& loops, int period = 0);

}  // namespace sweepmesh
