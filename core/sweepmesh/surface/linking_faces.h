// Structured quad grids on all linking faces.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

/// Adds the grids of all linking faces to `mesh`, which holds the nodes of `edges` already. New
/// nodes are owned by their face, lie on its surface and know their layer; cells are
/// counterclockwise seen from outside and have the corners (i,k), (i+1,k), (i+1,k+1), (i,k+1).
/// Throws InvalidMeshError where the counts bound no region or
/// where a quad stays inverted (its scaled Jacobian, in the surface's tangent plane, is not
/// positive).
void mesh_linking_faces(const Model& model, const Scheme& scheme, const Intervals& intervals,
                        const EdgeMesh& edges, Context& context, SurfaceMesh& mesh);

}  // namespace sweepmesh
