// Schemes that sweep through a wall, guessed from its rims.
#pragma once

#include <vector>

#include "sweepmesh/scheme/role_search.h"

namespace sweepmesh {

/// A wall has a rim where its outside ends and its inside begins: a face between two closed lines,
/// with convex edges only, such as the end of a pipe. Plane faces of this kind are taken as rims,
/// and others (holes drilled through the wall) that meet none of these. Where all else falls apart
/// into two sides, so that each rim lies between the one and the other, the sweep from side to side
/// is kept if states exist for it. Like prismatic_divisions a source of second choices: the search
/// looks for few caps, and a wall's sides may have many. At most one.
std::vector<Division> walled_divisions(const Network& network, Context& context);

}  // namespace sweepmesh
