// Cuts that make patches of caps which close on themselves.
#pragma once

#include <vector>

#include "sweepmesh/imprint/shell.h"

namespace sweepmesh {

/// Adds the cuts that patch `patch` of a shell needs, and replaces it by its parts. What it needs
/// is seen on its source, or on its target (`by_target`), whose boundary must be CAD edges:
///  - a band without poles is cut from rim to rim where nothing is in the way, along the line
///    between two vertices that leans least;
///  - a cap with a pole that is more than about a hemisphere is cut by a girdle around its middle,
///    the one that stays farthest from holes and poles on both sides;
///  - a torus is cut along both circles.
/// Other patches are left as they are. The line of a band's cut on the other side is left empty,
/// that is straight. Throws ImprintError (unreachable) for a closed surface of
/// another kind.
void cut_patch(const Model& model, bool by_target, int patch, Shell& shell);

}  // namespace sweepmesh
