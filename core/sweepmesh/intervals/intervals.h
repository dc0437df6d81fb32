// The number of mesh edges on every edge, and the layer of every vertex.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/ids.h"

namespace sweepmesh {

/// Vectors are indexed by the whole shape's ids; 0 for edges of other solids.
struct Intervals {
  std::vector<int> edge;  ///< mesh edges on a CAD edge; for an axial edge also |k(end) - k(start)|
  std::vector<int> k;     ///< layer of a vertex on a linking face; -1 where it has none
  /// By face id, for linking faces one number a loop: i of the loop's first vertex, where that of
  /// the first loop has i = 0; empty for other faces.
  std::vector<std::vector<int>> loop_i;
  int n_layers = 0;  ///< highest k; the lowest is 0
  /// Linking faces whose sides touch or cross in these counts, as far as is known: they bound no
  /// structured grid.
  std::vector<FaceId> crossed;
  /// Where the order of a face's sides cannot be kept: the demands that contradict each other, as a
  /// sentence, and their entities; the counts leave that order out. Empty: none was left out.
  std::string unmet;
  std::vector<std::string> unmet_entities;
  bool is_optimal = true;  ///< false where the solver reached a limit and its best solution is used
};

}  // namespace sweepmesh
