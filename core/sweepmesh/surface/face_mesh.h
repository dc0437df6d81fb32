// The mesh of one face by itself: what one solid hands to another that touches it there.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

/// Polygons in compressed rows, counterclockwise seen from outside the solid that they are for.
struct FaceMesh {
  std::vector<Point3> points;
  std::vector<int> cell_offset = {0};
  std::vector<int> cell_nodes;

  int n_cells() const { return static_cast<int>(cell_offset.size()) - 1; }
  std::span<const int> cell(int c) const {
    return {cell_nodes.data() + cell_offset[c], cell_nodes.data() + cell_offset[c + 1]};
  }
};

/// The cells of one face of a surface mesh; `nodes`, if given, receives their nodes there.
FaceMesh mesh_of_face(const SurfaceMesh& mesh, FaceId face, std::vector<NodeId>* nodes = nullptr);

/// The same for the solid on the other side of the face.
FaceMesh seen_from_behind(FaceMesh mesh);

/// Which node of `b` each node of `a` is, where the two are the same mesh: `known` tells it for the
/// nodes on the boundary (by node of `a`, -1 for others). Empty where they differ. Linear.
std::optional<std::vector<int>> matched(const FaceMesh& a, const FaceMesh& b,
                                        std::vector<int> known);

}  // namespace sweepmesh
