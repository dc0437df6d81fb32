// A leaning linking face whose outline has steps, cut into panels from level to level.
//
//          +---------+   k = 2        Between two neighbouring levels of the face's own vertices
//          its
//         /  panel 2  \               axial edges, sorted along i, are the left and right sides of
//     +--+.............+    1         strips. Where a side passes a level between its ends, it is
//    /       panel 1    \             taken there in proportion to the heights; what of a strip's
//   +--------------------+  0         end is no edge is a straight line in the face's parameters.
#pragma once

#include <vector>

#include "sweepmesh/imprint/panels.h"

namespace sweepmesh {

/// The strips of a face, each a ruled_panel. Empty where the sides do not pair off (an outline
/// that turns back in i). Sides are compared by the parameters of the face, so a face that bends by
/// more than a quarter turn in them along i is not understood.
std::vector<Panel> stepped_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                                  const Reference& seen, const Heights& height, FaceId face);

}  // namespace sweepmesh
