// The boundary nodes that may be moved on their face, so that elements get better.
#pragma once

#include <set>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/surface_mesh.h"
#include "sweepmesh/volume/assemble.h"
#include "sweepmesh/volume/raise_least.h"

namespace sweepmesh {

/// Those inside faces that are not `held`: on planar ones, and on curved ones. Nodes on edges and
/// at vertices stay, so that a valid mesh of the face stays within it. The result keeps a reference
/// to the model.
struct MovableNodes {
  std::vector<SlidingNode> sliding;
  CurvedNodes curved;
};
MovableNodes movable_nodes(const Model& model, const SurfaceMesh& surface, const Assembly& assembly,
                           const std::set<FaceId>& held = {});

}  // namespace sweepmesh
