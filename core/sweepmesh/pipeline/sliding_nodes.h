// The boundary nodes that may be moved on their face, so that elements get better.
#pragma once

#include <set>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/surface_mesh.h"
#include "sweepmesh/volume/assemble.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

/// Those inside planar faces that are not `held`, ascending by volume node. Nodes on edges and at
/// vertices stay, so that a valid mesh of the face stays within it.
std::vector<SlidingNode> sliding_nodes(const Model& model, const SurfaceMesh& surface,
                                       const Assembly& assembly, const std::set<FaceId>& held = {});

}  // namespace sweepmesh
