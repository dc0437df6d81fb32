// The walls of a sweep as rings of columns: what a bound on folding looks at.
//
// Between two neighbouring levels the cross-section of a solid does not change its topology. Its
// walls are the linking faces there; the columns of their structured coordinates, cut at every
// layer, make closed rings, which lie over each other column by column:
//
//      k_high  o------o------o      layers[k - k_low][j]: column j at layer k. The material is on
//      the
//              |      |      |      left of j -> j + 1 seen from above (larger k): the outer ring
//              runs o------o------o      counterclockwise, the rings of holes clockwise. |      | |
//       k_low  o------o------o
//              j
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"

namespace sweepmesh {

struct WallRing {
  std::vector<int> columns;                 ///< their numbers, the same below and above a level
  std::vector<FaceId> face;                 ///< the linking face between columns j and j + 1
  std::vector<std::vector<Point3>> layers;  ///< at least two, all of one length, >= 3

  int n_layers() const { return static_cast<int>(layers.size()); }
  int n_columns() const { return static_cast<int>(columns.size()); }
};

/// One connected part of the cross-section between two neighbouring levels.
struct WallSection {
  int k_low = 0, k_high = 0;
  WallRing outer;
  std::vector<WallRing> holes;
};

/// Joins rings of one slab to sections: a hole belongs to the smallest outer ring that contains it,
/// in the plane of that ring, half way up. Rings that turn clockwise seen along their columns are
/// holes. A hole in no outer ring is left out, with all that may be said of it. Quadratic in rings.
std::vector<WallSection> joined_to_sections(int k_low, int k_high, std::vector<WallRing> rings);

// Of one layer of a ring.
Point3 centre_of(const std::vector<Point3>& ring);
/// The area vector, which points up for an outer ring.
Point3 area_of(const std::vector<Point3>& ring);

}  // namespace sweepmesh
