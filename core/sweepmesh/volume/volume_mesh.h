// The result: nodes, elements by kind, groups, and where each node came from.
//
//   hexahedron       7------6     prism      5        Node order is VTK's and Abaqus': the first
//   ring
//                   /|     /|               /|\       counterclockwise seen from the second, which
//                   lies
//                  4------5 |              3---4      above it. (FreeCAD's own order is the mirror
//                  image; | 3----|-2              | 2 |      see io/ and Mod/sweepmesh/app.)
//                  |/     |/               |/ \|
//                  0------1                0---1
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

struct VolumeMesh {
  Points points;
  std::vector<std::array<int, 8>> hexahedra;
  std::vector<std::array<int, 6>> prisms;

  /// The boundary: polygons in compressed rows, outward, each with its CAD face.
  std::vector<int> boundary_offset = {0};
  std::vector<int> boundary_nodes;
  std::vector<FaceId> boundary_face;

  /// Per node: the CAD entity that it lies on; index -1 for a node inside the solid.
  std::vector<Owner> owner;

  /// Second order only (else empty): mid-side nodes in VTK's and Abaqus' order. A hexahedron's: the
  /// sides of its first ring, of its second, then those from ring to ring. A prism's likewise. A
  /// boundary polygon's: entry j lies between its nodes j and j + 1, in the rows of
  /// boundary_offset.
  std::vector<std::array<int, 12>> hexahedron_mid_nodes;
  std::vector<std::array<int, 9>> prism_mid_nodes;
  std::vector<int> boundary_mid_nodes;
};

}  // namespace sweepmesh
