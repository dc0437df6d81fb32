// The boundary of a cap, or of a patch of a cap, as the nodes of its mesh.
#pragma once

#include <vector>

#include "sweepmesh/base/ids.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

struct CapNode {
  NodeId node;  ///< in the surface mesh that the cap belongs to
  Point3 point;
  Point2 uv;  ///< on the face; any of its periods will do
};

/// Closed rows of nodes with the domain on their left, seen from outside the solid. Which one is
/// the outer loop is of no importance: on a closed-around face there may be none.
using CapLoops = std::vector<std::vector<CapNode>>;

/// The coedges that bound a face, loop by loop: seams and poles are passed over, as they bound
/// nothing. None for a closed surface.
std::vector<Loop> bounding_loops(const Model& model, FaceId face);

/// The loops of a whole CAD face, from the nodes of its edges: `edge_nodes[e]` and `edge_t[e]` are
/// the nodes of edge e with their curve parameters, from the edge's start to its end, both
/// included. Seams and poles bound nothing and are passed over: a cap's mesh may cross its own
/// seam.
CapLoops cap_loops(const Model& model, FaceId face,
                   const std::vector<std::vector<NodeId>>& edge_nodes,
                   const std::vector<std::vector<double>>& edge_t);

}  // namespace sweepmesh
