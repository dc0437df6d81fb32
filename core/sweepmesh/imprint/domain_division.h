// Quads in a plane domain with narrow passages, by cutting it along chords.
//
//      +--------+--------+        Where few nodes lie around re-entrant corners, a mesher that
//      knows |      chord      |        nothing of the whole leaves cells that have all their
//      corners on |   +----o  . . . +        the boundary and are folded. A chord from such a
//      corner across the |   |    |        |        passage gives it the cells that it needs,
//      whatever lies beyond.
//      +---+    +--------+
#pragma once

#include <optional>

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {

/// A mesh of the domain cut along a chord between two nodes of a loop, where both parts have an
/// even number of mesh edges; the parts are meshed each by themselves, and cut again where that
/// leaves them with poor cells. Chords begin at the boundary nodes of the poor cells of `mesh`,
/// which is a mesh of the same loops; the few that leave the best corners are tried. Empty where
/// no chord leaves a mesh with a better worst cell. Cost: some ten times that of
/// candidate_meshes().
std::optional<PlanarMesh> mesh_divided(const PlanarLoops& loops, const PlanarMesh& mesh,
                                       const PlanarMeshOptions& options, const Context& context);

}  // namespace sweepmesh
