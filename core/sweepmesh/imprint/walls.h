// Which linking face stands on, or hangs below, each transverse edge.
#pragma once

#include <utility>
#include <vector>

#include "sweepmesh/base/ids.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Vectors by EdgeId, FaceId or VertexId of the whole shape.
struct Walls {
  std::vector<int> vertex_level;  ///< -1 where it has none
  std::vector<int> level;         ///< of a transverse or cap-to-cap edge; -1 for others
  std::vector<FaceId> above;      ///< the linking face that stands on the edge; invalid if none
  std::vector<FaceId> below;      ///< the linking face that ends at the edge from below
  /// Whether the solid lies on the left of the edge's own direction, seen from above, next to
  ///  `above` and of `below`.
  std::vector<char> solid_left_above, solid_left_below;
  std::vector<std::vector<EdgeId>> bottoms,
      tops;                   ///< of a linking face: edges it stands on, ends at
  std::vector<EdgeId> edges;  ///< all with a level, ascending
  /// Of a linking face: the ends of each run of axial edges along its loops.
  std::vector<std::vector<std::pair<VertexId, VertexId>>> sides;
};

/// From the directions of the scheme and the levels of vertices (sweep_levels.h). Edges that one
/// cap uses on both sides are left out: nothing depends on them. Throws Error("imprint") when an
/// edge's ends have no level or different ones, or two linking faces lie on the same side of an
/// edge.
Walls find_walls(const Model& model, const Scheme& scheme, const std::vector<int>& level);

}  // namespace sweepmesh
