// The result: nodes, elements by kind, groups, and where each node came from.
//
// clang-format off
//   hexahedron       7------6     prism      5     The first ring is counterclockwise seen from the second,
//                   /|     /|               /|\    which lies above it: VTK's and Abaqus' order for hexahedra,
//                  4------5 |              3---4   Abaqus' for prisms. Other orders (VTK's prisms, FreeCAD's
//                  | 3----|-2              | 2 |   own) are in Mod/sweepmesh/engine/numbering.py.
//                  |/     |/               |/ \|
//                  0------1                0---1
// clang-format on
// A polyhedron here is a prism over a polygon of five corners or more: its rings lie as those of
// the others do.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

struct VolumeMesh {
  Points points;
  std::vector<std::array<int, 8>> hexahedra;
  std::vector<std::array<int, 6>> prisms;
  /// Compressed rows, the first ring and then the second of each, of equal length.
  std::vector<int> polyhedron_offset = {0};
  std::vector<int> polyhedron_nodes;

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

  int n_polyhedra() const { return static_cast<int>(polyhedron_offset.size()) - 1; }
  long n_elements() const {
    return static_cast<long>(hexahedra.size() + prisms.size()) + n_polyhedra();
  }
  /// Both rings of a polyhedron.
  std::span<const int> polyhedron(int i) const {
    return {polyhedron_nodes.data() + polyhedron_offset[i],
            polyhedron_nodes.data() + polyhedron_offset[i + 1]};
  }
  /// Both rings of an element; hexahedra are numbered first, then prisms, then polyhedra.
  std::span<const int> element(long e) const {
    const auto n_hexahedra = static_cast<long>(hexahedra.size());
    if (e < n_hexahedra) return hexahedra[e];
    e -= n_hexahedra;
    const auto n_prisms = static_cast<long>(prisms.size());
    if (e < n_prisms) return prisms[e];
    return polyhedron(static_cast<int>(e - n_prisms));
  }
};

}  // namespace sweepmesh
