// A smooth map of the plane that is known on the boundary of a domain.
#pragma once

#include <vector>

#include "sweepmesh/imprint/polyline.h"

namespace sweepmesh {

/// Mean value interpolation (Hormann, Floater, Mean value coordinates for arbitrary planar
/// polygons, ACM Trans. Graph. 25, 2006): inside and outside the domain, exact on its boundary, and
/// exact everywhere where the boundary's map is affine. It needs the boundary's segments only, with
/// the domain on their left, in any order.
class MeanValueField {
 public:
  /// Points nearer to the boundary than `tolerance` move with the boundary's nearest point.
  explicit MeanValueField(double tolerance) : tolerance_(tolerance) {}

  /// Adds a part of the boundary: `from[i]` goes to `to[i]`.
  void add(const Polyline& from, const Polyline& to);

  /// Without any boundary: the identity. Linear in the number of segments.
  Point2 operator()(const Point2& p) const;

  /// Distance of a point from the boundary.
  double distance(const Point2& p) const;

  /// Twice the area of the domain, negative for the outside of one.
  double double_area() const;

 private:
  struct Segment {
    Point2 from[2], to[2];
  };
  struct Nearest {
    const Segment* segment = nullptr;
    double share = 0.0;  ///< of the segment, from its start
    double distance = 0.0;
  };
  Nearest nearest(const Point2& p) const;

  double tolerance_;
  std::vector<Segment> segments_;
};

}  // namespace sweepmesh
