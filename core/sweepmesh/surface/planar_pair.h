// One connectivity for two shapes of a boundary: source and target cap meshed together.
//
// What a cap's mesh looks like is decided by the shape it is made for; carried to another one, all
// distortion falls on that. Where both are known the mesh is made for both: candidates are those of
// the first shape (quad_mesher.h), and those of the shape half way between the two, in which each
// loop has made half of its own turn, growth and move. Each candidate is carried to both ends and
// smoothed there; the one whose worse end is best is taken. A hole that twists by 90 degrees so
// costs 45 at either end.
#pragma once

#include <vector>

#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {

struct PlanarPair {
  PlanarMesh first;            ///< at the first shape
  std::vector<Point2> second;  ///< positions of the same nodes at the second shape
  PlanarQuality first_quality, second_quality;
};

/// Both shapes are counterclockwise, with equal loops and counts; node i of one is node i of the
/// other. `options` belong to the first shape, `second_metric` to the second. Errors as mesh_planar
/// and map_planar.
PlanarPair mesh_planar_pair(const PlanarLoops& first, const PlanarLoops& second,
                            const PlanarMeshOptions& options, const Metric& second_metric,
                            const Context& context);

/// The loops half way from `first` to `second`, in the place and size of `first`: each turns by
/// half of its own rotation, about its own middle, and what is no rotation, scaling or move is
/// averaged. They may cross.
PlanarLoops half_way(const PlanarLoops& first, const PlanarLoops& second);

}  // namespace sweepmesh
