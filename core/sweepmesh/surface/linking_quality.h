// Quality of quads that lie on a surface.
#pragma once

#include <array>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// The least over the corners of det(e1, e2, normal) / (|e1| |e2|): 1 for a rectangle, not positive
/// where a corner is flat or turned over. `normal` holds the surface's unit normal at each corner
/// (a zero normal is replaced by the quad's own mean). 0 where two corners coincide.
double scaled_jacobian(const std::array<Point3, 4>& corner, const std::array<Point3, 4>& normal);

}  // namespace sweepmesh
