// Columns of nodes on the linking faces, from target to source.
#pragma once

#include <vector>

#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

struct ColumnChains {
  /// Each chain's nodes for k = low, low + 1, ..., high (SurfaceMesh::k tells them); chains are
  /// ordered by their lowest node.
  std::vector<std::vector<NodeId>> chains;
};

/// Follows the sides of all quads that rise by one layer (cells of linking faces; others are passed
/// over). Throws InvalidMeshError where a node has two nodes above or below it, naming the faces
/// there.
ColumnChains columns_from(const SurfaceMesh& mesh);

}  // namespace sweepmesh
