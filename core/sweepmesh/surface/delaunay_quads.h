// Quads of a plane domain without an outside mesher.
//
// Points of a triangular grid are laid inside, the domain is triangulated, and triangles are paired
// to quads, the pair with the best shape first; what is left over is paired over the quads between
// (quad_cleanup.h).
#pragma once

#include <optional>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// A mesh of quads with inside edges of about `size`, or of the boundary's mean edge where that is
/// shorter. Empty where triangles are left over. Cells may be poor or inverted: clean and smooth
/// afterwards. The loops bound a domain (is_domain). Cost: that of the points times the nodes of
/// the boundary.
std::optional<PlanarMesh> delaunay_quads(const PlanarLoops& loops, double size);

}  // namespace sweepmesh
