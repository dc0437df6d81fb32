// Scaled Jacobian of all elements of an extrusion, fast: which are bad, and the least value.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

struct ElementCheck {
  std::vector<long> bad;  ///< ascending; numbered cell by cell, from the lowest layer up
  double min_scaled_jacobian = 1.0;
  double mean_scaled_jacobian = 1.0;
};

double scaled_jacobian_of(const Extrusion& extrusion, const Points& points, SweptElement element);

/// A scaled Jacobian up to this is none: rounding decides its sign.
inline constexpr double kDegenerate = 1e-6;

/// Elements whose scaled Jacobian is not above `threshold`.
ElementCheck check_elements(const Extrusion& extrusion, const Points& points, double threshold,
                            ThreadTeam& team);

}  // namespace sweepmesh
