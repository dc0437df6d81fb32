// The angles that a patch's boundary has on its caps.
#pragma once

#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {

/// One row for R (`plane`, the patch's nodes loop after loop), and one for each cap of the patch's
/// runs. Where both mesh edges at a node lie on the cap's own boundary the row has the angle
/// between them there: no mesh of the cap can change it. Elsewhere it has R's. R's
/// own row gives way to the first such cap's: the base mesh may move where its caps do not.
BoundaryAngles patch_angles(const Model& model, const Imprint& imprint,
                            const std::vector<int>& counts, const Patch& patch,
                            const PlanarLoops& plane);

}  // namespace sweepmesh
