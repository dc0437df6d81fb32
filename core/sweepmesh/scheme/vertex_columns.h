// Whether one column of mesh edges leaves each vertex upwards, and one downwards.
//
// Around a vertex the boundary is a ring of quads, each above or below the vertex' layer, and of
// mesh edges between them. The quads below that follow each other without one above belong to
// elements that hang together under the vertex, and all of these have one edge that goes down from
// it. Where two such edges lie on the boundary, as at the tip of a solid that two sources touch
// from either side, they would have to be the same: the section there falls apart into pieces that
// hang together at a point. The same holds above.
#pragma once

#include <optional>

#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

/// The first vertex (SweepProblem index) that two columns would leave into the same elements; empty
/// where there is none. `choices` are decided. Linear in the number of coedges.
std::optional<int> torn_vertex(const Network& network, const Choices& choices);

}  // namespace sweepmesh
