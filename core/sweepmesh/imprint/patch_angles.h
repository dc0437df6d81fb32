// The angles that a patch's boundary has on its caps, and those of cells that it leaves no choice.
#pragma once

#include <optional>
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

/// The nodes of a patch's boundary, loop after loop, that lie on a cap's own boundary, with the
/// cap's normal there, turned to where the patch is seen from. The others are left to the cap's
/// mesh.
struct CapOutline {
  std::vector<std::optional<Point3>> point;
  std::vector<Point3> up;
};

/// One outline for each cap of the patch's runs.
std::vector<CapOutline> cap_outlines(const Model& model, const Imprint& imprint,
                                     const std::vector<int>& counts, const Patch& patch);

/// By boundary node: whether some cell has a corner there between two other nodes of a cap's
/// outline, and would be almost flat or folded on that cap wherever inside nodes are.
std::vector<char> tied_corners(const PlanarMesh& mesh, const std::vector<CapOutline>& outlines);

}  // namespace sweepmesh
