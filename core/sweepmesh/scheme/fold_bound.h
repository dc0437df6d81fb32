// How far holes wind within a sweep: a bound on folding that needs no mesh.
//
// Seen from the outer ring of its section, a hole may turn around itself from layer to layer, and
// two holes around each other. Let W be that angle from the lowest layer to the highest, whole
// turns counted. Every layer of a swept mesh is an image of one base mesh, and all layers together
// are a way from the image on the lower cap to that on the upper one, along which the rims follow
// the walls. But the caps' meshes are made from their rims alone, and a rim that has turned by W
// looks as one that has turned by W less whole turns: the caps' map takes the short way
// (docs/cap_mapping.md). Where that is another way than the walls', the two differ by a twist of
// the whole section around the hole. No way through maps without folds joins them, as none can undo
// a whole turn between two rims: wherever inner nodes are put, elements stay inverted, at every
// element size.
//
// So |W| above half a turn cannot be meshed, and below it nothing is proved: shear spread over the
// gap between hole and wall costs quality, and placement decides. At half a turn itself either way
// is as short as the other. The limits are calibrated (docs/assessment.md).
#pragma once

#include <numbers>
#include <vector>

#include "sweepmesh/scheme/wall_sections.h"

namespace sweepmesh {

/// Above this no mesh was ever found, nor can it be.
inline constexpr double kMostWinding = 200.0 * std::numbers::pi / 180.0;
/// Up to this every one could be meshed; between the two the mesh decides.
inline constexpr double kSafeWinding = 140.0 * std::numbers::pi / 180.0;

/// A hole that turns around itself, or two that turn around each other.
struct Winding {
  double angle = 0.0;         ///< |W|, radians
  bool is_of_two = false;     ///< two holes, around each other
  std::vector<FaceId> faces;  ///< linking faces of the hole, or of both, ascending
};

/// The largest winding of all holes, and pairs of holes, of `sections` (ascending levels). Holes
/// are followed from slab to slab by the columns that they share. Nothing is said (0) of what
/// cannot be told safely: a hole that lies over by more than 120 degrees, rings that turn by more
/// than 60 degrees from one layer to the next, an outer ring that changes its shape so much that it
/// has no frame. Linear in the points of the rings, and in pairs of holes times layers.
Winding largest_winding(const std::vector<WallSection>& sections);

}  // namespace sweepmesh
