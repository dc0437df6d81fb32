// Mid-side nodes of a swept mesh on the faces and edges of its model.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// add_mid_nodes (volume/second_order.h) with the middles of boundary sides projected onto the face
/// that both cells of a side lie on, or onto the edge between their faces. Adds a warning where
/// nodes had to leave the CAD geometry to keep elements valid.
void add_mid_nodes_on(const Model& model, VolumeMesh& mesh, Context& context,
                      std::vector<std::string>& warnings);

}  // namespace sweepmesh
