// The mesh of a face taken over from another solid, made ready for the plane.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/face_mesh.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// Cells whose first nodes are those of a boundary in its order; the others are inside.
struct GivenCells {
  int n_boundary = 0;
  std::vector<int> cell_offset, cell_nodes;
  std::vector<Point3> inner;  ///< node n_boundary + i
};

/// Numbers the nodes of `mesh` after `boundary`, whose points they are found by. Throws
/// InvalidMeshError where a boundary point is no node of the mesh, or a node of the mesh's own
/// boundary none of these.
GivenCells numbered_from(const std::vector<Point3>& boundary, const FaceMesh& mesh,
                         double tolerance);

/// The cells in a plane where the boundary lies at `flat`: the affine map that takes the boundary's
/// `points` nearest to it (exact for a plane face), and what that leaves over as map_planar does
/// it. `points` are those of all nodes. Throws what map_planar throws.
PlanarMesh laid_flat(const GivenCells& cells, const std::vector<Point3>& points,
                     const std::vector<Point2>& flat, const Metric& metric, const Context& context);

}  // namespace sweepmesh
