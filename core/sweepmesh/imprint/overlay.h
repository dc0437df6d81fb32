// The CAD edges of all levels laid over each other in R, near ones brought together.
//
// Curves become *pieces* between *nodes*. Nodes are brought onto near pieces, pieces that run near
// each other become one, crossings become nodes, until an exact arrangement of the pieces meets
// nothing but their ends.
//
//   near curves:  A .--------.          curves that cross at \           \                      .
//                 B .-------------.     a small angle run as      \ \    ->    \  .
//             ->    o========o----o     one while they are near     \ \          \\.
//
// What would collide (occupancy.h) is never brought together, so no gap and no thin piece of the
// solid is lost; two curves that cross still cross, though over a stretch that they share.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/occupancy.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct Overlay {
  PlaneArrangement arrangement;
  std::vector<std::vector<VertexId>> cad;  ///< by vertex of the arrangement, ascending
  std::vector<std::vector<Trace>> traces;  ///< by edge of the arrangement, ascending levels
  std::vector<Merge> merges;
};

/// `merge_distance` at least the reference's coincidence. CAD vertices joined by axial edges are
/// one column. Throws ImprintError (collision) where curves of the same levels lie over each other.
/// Cost: quadratic in the number of edges for their boxes, n log n else.
Overlay overlay(const Model& model, const Scheme& scheme, const Walls& walls,
                const Reference& reference, double merge_distance, const Context& context);

}  // namespace sweepmesh
