// A closed curve around the middle of a ball-like surface, on a source and on its target.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Points of a closed curve, the first not repeated. Seen from outside the solid at the source,
/// what lies on the side of `normal` is on its left.
struct Girdle {
  Point3 normal = Point3::Zero();       ///< of its plane
  Point3 high_centre = Point3::Zero();  ///< about which the source lies
  std::vector<Point2> high, low;        ///< parameters on the source and on the target
};

/// The girdle in the plane through the centres of both surfaces that stays farthest from the
/// faces' boundaries and poles. Empty where a surface is not seen whole from its centre, or
/// boundaries are in the way everywhere.
std::optional<Girdle> find_girdle(const Model& model, FaceId source, FaceId target);

}  // namespace sweepmesh
