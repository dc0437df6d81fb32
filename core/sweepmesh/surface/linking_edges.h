// The nodes on CAD vertices and edges: the frame that caps and linking faces share.
#pragma once

#include <vector>

#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

/// Where the nodes of vertices and edges are in a surface mesh.
struct EdgeMesh {
  std::vector<NodeId> vertex;             ///< by vertex id; invalid for other solids
  std::vector<std::vector<NodeId>> edge;  ///< by edge id: from its start to its end, both included
  EdgeNodes parameters;                   ///< the curve parameters of `edge`
};

/// Adds a node for every vertex and n - 1 for every edge of the solid, owned by them and with their
/// layer: that of an axial edge runs along it. Nodes of an edge follow one another in the mesh.
EdgeMesh mesh_edges(const Model& model, const Intervals& intervals, const EdgeNodes& nodes,
                    SurfaceMesh& mesh);

}  // namespace sweepmesh
