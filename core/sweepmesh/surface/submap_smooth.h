// How good a structured grid on a curved surface is, and a better one where it is poor.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/submap_place.h"

namespace sweepmesh {

struct GridQuality {
  double min_scaled_jacobian = 1.0;  ///< in the surface's tangent planes
  /// The most that an edge is longer or shorter than the mean of the boundary's steps in its row or
  /// column, as a factor >= 1.
  double max_stretch = 1.0;
  std::vector<long> inverted;  ///< cells whose scaled Jacobian is not positive
};

GridQuality judge_grid(const Model& model, FaceId face, const PlacedRegion& placed);

/// Moves the interior nodes in (u,v) to the least of a regularised elliptic energy
/// (foldover_free_2d.h) that sees the surface's metric and wants each quad as wide and high as the
/// boundary's steps in its column and row are on average. Keeps the old grid where the new one has
/// a smaller minimum scaled Jacobian.
void smooth_grid(const Model& model, FaceId face, PlacedRegion& placed, const Context& context);

}  // namespace sweepmesh
