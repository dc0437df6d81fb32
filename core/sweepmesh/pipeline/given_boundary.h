// What a solid's boundary mesh must take over from solids that it touches.
#pragma once

#include <map>
#include <vector>

#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/surface/cap_mesh.h"
#include "sweepmesh/surface/face_mesh.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

struct GivenBoundary {
  std::vector<std::vector<double>> edge_t;  ///< by EdgeId, as EdgeNodes; empty where it is free
  std::map<FaceId, FaceMesh> faces;         ///< seen from outside this solid
  double tolerance = 0.0;                   ///< nodes closer than this are the same
};

void take_edges(const GivenBoundary& given, EdgeNodes& nodes);

/// Puts the nodes inside linking faces where they are given. Throws InvalidMeshError naming a face
/// whose grid is another one.
void take_linking_faces(const Scheme& scheme, const GivenBoundary& given, SurfaceMesh& mesh);

/// The cells of `cap` on the face at its other end, where `boundary` are their boundary nodes and
/// `mesh` is given. Throws InvalidMeshError naming both faces where `mesh` has other cells.
CapMesh same_mesh_on(const Model& model, const CapMesh& cap, FaceId face,
                     const std::vector<CapNode>& boundary, const FaceMesh& mesh, double tolerance);

}  // namespace sweepmesh
