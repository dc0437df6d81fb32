// Quadratic elements: mid-side nodes, on the CAD geometry where the side lies on it.
#pragma once

#include <functional>

#include "sweepmesh/base/context.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// A boundary side between two boundary cells: of one CAD face, or of two that meet in a CAD edge.
struct BoundarySide {
  FaceId one, other;
};

/// The point of the CAD geometry under the middle of a side, and the entity that it lies on.
struct MidPoint {
  Point3 point;
  Owner owner;
};
using MidPointFinder = std::function<MidPoint(const BoundarySide&, const Point3& middle)>;

struct SecondOrderReport {
  long n_mid_nodes = 0;
  /// Mid-side nodes that were drawn back towards their side's straight middle, off the CAD
  /// geometry, because the curved element would have folded.
  long n_straightened = 0;
};

/// Gives every element of `mesh` its mid-side nodes (20-node hexahedra, 15-node prisms; one node a
/// side, shared). `mesh` needs its boundary (add_boundary). A side inside the solid keeps its
/// middle. Where the Jacobian determinant of a curved element is not positive at its corners,
/// mid-sides and centre, its boundary mid-nodes are halved towards the straight side until it is (a
/// straight-sided element with positive corners is valid), so the mesh stays valid. O(n log n) in
/// the number of sides.
SecondOrderReport add_mid_nodes(VolumeMesh& mesh, const MidPointFinder& find, Context& context);

}  // namespace sweepmesh
