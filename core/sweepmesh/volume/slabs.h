// An extrusion between its neighbouring levels: cross-sections and their connected parts.
#pragma once

#include <utility>
#include <vector>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

/// Connected sets of runs with the same two ends.
struct RunBlocks {
  std::vector<std::pair<int, int>> ends;  ///< per block: k_low, k_high
  std::vector<int> of_cell;
  /// Blocks of every column in compressed rows, ascending.
  std::vector<int> column_offset, column_blocks;
};

RunBlocks find_blocks(const Extrusion& extrusion);

/// What is between two neighbouring levels (layers at which a run begins or ends).
struct Slab {
  int k_low = 0, k_high = 0;
  std::vector<int> part;  ///< per column: connected part of the section, or -1
  /// Per part: its columns that are fixed all the way, on its bounding loops; ascending.
  std::vector<std::vector<int>> loops;

  bool holds(const Extrusion& x, int cell) const {
    return x.cell_k_low[cell] <= k_low && k_high <= x.cell_k_high[cell];
  }
};

/// From the lowest to the highest.
std::vector<Slab> find_slabs(const Extrusion& extrusion, const std::vector<char>& fixed,
                             const RunBlocks& blocks, ThreadTeam& team);

}  // namespace sweepmesh
