// The boundary of a sweep through the thickness of a wall, meshed.
#pragma once

#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/pipeline/boundary.h"

namespace sweepmesh {

/// Grids on the linking faces, and every patch of the shell meshed on its source and its target
/// together; the columns between the two images and the runs over all cells. Closed edges that no
/// linking face ties to one another are turned so that their nodes lie nearest. Throws what the
/// surface stage throws, and InvalidMeshError where the columns of a linking face do not lead from
/// an edge to its image, naming both.
BoundaryMesh mesh_shell_boundary(const Model& model, const Scheme& scheme, const Shell& shell,
                                 const PieceCounts& counts, const IntervalOptions& options,
                                 CellKind kind, Context& context);

/// Its first steps alone, for what they throw: all that fails without regard to the caps' meshes.
/// Cost: the grids of the linking faces.
void try_shell_walls(const Model& model, const Scheme& scheme, const Shell& shell,
                     const PieceCounts& counts, const IntervalOptions& options, Context& context);

}  // namespace sweepmesh
