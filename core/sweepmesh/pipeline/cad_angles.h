// Where poor elements are the CAD model's own doing.
//
// No mesh opens a corner of a face, or an edge between two faces, wider than it is: at a cusp,
// where a line runs into an arc that it touches, or at a knife's edge, elements have that angle or
// less. Nor does one bend what is flat: where a cap is tangent to the linking face beside it, an
// element has to reach around the edge.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// A vertex or an edge with an angle that a sweep can only fill with poor elements.
struct PoorAngle {
  Owner entity;
  double degrees = 0.0;
};

/// Of the entities at which elements have a scaled Jacobian below `poor`, those that are themselves
/// too sharp or, between a cap and a linking face, too flat; in the order of their numbers.
/// `scheme` may be that of a divided solid told in the solid's numbers (divided_sweep.h). Cost:
/// linear in the elements.
std::vector<PoorAngle> poor_cad_angles(const Model& model, const Scheme& scheme,
                                       const VolumeMesh& mesh, double poor, const Context& context);

/// One sentence that names them, the sharpest first; empty for none.
std::string warning_of(std::vector<PoorAngle> angles);

}  // namespace sweepmesh
