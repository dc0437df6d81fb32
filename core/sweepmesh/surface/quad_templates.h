// Structured quad meshes of loops that admit one: mapped, ring and O-grid patterns.
//
//   mapped: four sides, opposite ones of equal count      ring: two loops of equal count
//   O-grid: one smooth loop; a core of a x b quads inside rings of cells that follow the loop
//
//     +--+--+--+        .-------.
//     |  |  |  |       / \  |  / \        The templates place nodes by transfinite interpolation;
//     the
//     +--+--+--+      |---+-+-+---|       result may be poor or even inverted for a loop that does
//     not |  |  |  |      |   +-+-+   |       suit: smooth it, measure it, and keep it only if it
//     is good.
//     +--+--+--+       \ /  |  \ /
//                       '-------'
#pragma once

#include <vector>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// Structured candidates for the loops with their nodes as they are and inside edges of about
/// `size`: those that are possible by the counts, none, one or two. Nothing is said about quality.
std::vector<PlanarMesh> structured_candidates(const PlanarLoops& loops, double size);

}  // namespace sweepmesh
