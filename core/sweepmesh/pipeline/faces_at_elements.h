// The CAD faces at which elements of a volume mesh lie, for errors that name them.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/surface/surface_mesh.h"
#include "sweepmesh/volume/assemble.h"

namespace sweepmesh {

/// Names of the faces, ascending, that have a side of one of the elements (numbers of
/// element_index.h); where none has, those that they have a node on; where they are all inside,
/// none.
std::vector<std::string> faces_at_elements(const SurfaceMesh& surface, const Assembly& assembly,
                                           const std::vector<long>& elements);

}  // namespace sweepmesh
