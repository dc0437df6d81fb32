// Makes a mesh of quads and a few triangles all quads, and its nodes' valences regular.
//
//   pairing: a triangle wanders over quads to the      rotation: the edge between two quads turns
//   within next triangle and makes a quad with it             their hexagon
//      .---.---.         .---.---.                        .---.---.      .---.---.
//      | / |   |   ->    |    \  |                        |   |   |  ->  | \     |
//      '---'---'         '---.---'                        '---'---'      '---'-\-'
//   doublet: an inside node of two quads goes          collapse: two opposite nodes of a quad
//   become one
//
// An operation is done where it lowers the sum, over all nodes, of (number of quads - wished
// number)^2; the wish is 4 inside and the boundary's angle in right angles on the boundary.
// Boundary nodes stay.
#pragma once

#include <optional>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// The same nodes with all triangles paired to quads. Empty where that is not possible (an odd
/// number of boundary edges, or no path). Cells may come out inverted: smooth afterwards.
std::optional<PlanarMesh> with_triangles_paired(const PlanarMesh& mesh);

/// Fewer irregular nodes. All cells must be quads. Nodes that nothing uses any more are left out;
/// the others keep their order. `angles` are the interior angles at the boundary nodes, one row for
/// each shape that the boundary is to take: a node wishes a number of quads that suits all. Cells
/// may come out inverted: smooth afterwards.
PlanarMesh with_regular_valences(const PlanarMesh& mesh,
                                 const std::vector<std::vector<double>>& angles);

/// A ring of quads put around every loop that needs one: a hole that shares a cell with another
/// loop and has no inside node there (so that it may move on its own), a loop where a single cell
/// has to open its corner almost flat in one of the shapes of `angles`, and one with a node that is
/// marked in `wants_ring` (by boundary node; empty: none). Cells may come out inverted. `loops` are
/// the mesh's boundary.
PlanarMesh with_rings(const PlanarMesh& mesh, const PlanarLoops& loops,
                      const std::vector<std::vector<double>>& angles,
                      const std::vector<char>& wants_ring = {});

/// Every triangle cut into three quads, every quad into four, with new nodes on the middle of
/// inside edges and of cells. `boundary` are the nodes of the finer boundary: those of the mesh are
/// every second one.
PlanarMesh refined_to_quads(const PlanarMesh& mesh, const PlanarLoops& boundary);

}  // namespace sweepmesh
