// The boundary of a sweep with any number of sources and targets, meshed.
#pragma once

#include "sweepmesh/imprint/base_mesh.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/imprint_counts.h"
#include "sweepmesh/pipeline/boundary.h"

namespace sweepmesh {

/// Grids on the linking faces, the base mesh of the patches, and its image on every cap; the
/// columns over the base nodes and the runs over its cells. Every patch's cells appear on its
/// target and on its source, node over node. Throws what the surface stage throws, and
/// InvalidMeshError where the columns of a linking face and those of the base mesh do not agree,
/// naming the face. What is given is taken over; a given cap must be one patch, or InvalidMeshError
/// names it.
BoundaryMesh mesh_imprinted_boundary(const Model& model, const Scheme& scheme,
                                     const Imprint& imprint, const PieceCounts& counts,
                                     const IntervalOptions& options, CellKind kind,
                                     Context& context, const GivenBoundary& given = {});

/// Whether several patches cover a cap: then its mesh cannot be given.
bool is_divided(const Imprint& imprint, FaceId cap);

}  // namespace sweepmesh
