// The boundary of a linking face as its grid sees it: unit steps, mesh nodes and (u,v) along each
// loop.
#pragma once

#include <vector>

#include "sweepmesh/intervals/grid_region.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/surface/linking_edges.h"

namespace sweepmesh {

struct SubmapBoundary {
  std::vector<GridLoop> loops;
  int period = 0;                          ///< steps around a tube without a seam, else 0
  std::vector<std::vector<NodeId>> nodes;  ///< per loop and step: the mesh node where it starts
  /// Parameters of those nodes on the face, continuous along each loop (not wrapped at a seam).
  std::vector<std::vector<Point2>> uv;
};

/// The rims of a tube without a seam are turned so that nodes of equal i lie close together (`mesh`
/// holds the nodes of `edges`). Requires a face without poles.
SubmapBoundary submap_boundary(const Model& model, const Scheme& scheme, const Intervals& intervals,
                               const EdgeMesh& edges, const SurfaceMesh& mesh, FaceId face);

}  // namespace sweepmesh
