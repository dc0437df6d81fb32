#include "sweepmesh/imprint/mean_value_field.h"

#include <algorithm>
#include <limits>

namespace sweepmesh {

void MeanValueField::add(const Polyline& from, const Polyline& to) {
  for (std::size_t i = 0; i + 1 < from.size(); ++i)
    if (from[i] != from[i + 1]) segments_.push_back({{from[i], from[i + 1]}, {to[i], to[i + 1]}});
}

Point2 MeanValueField::operator()(const Point2& p) const {
  if (segments_.empty()) return p;
  double least = std::numeric_limits<double>::infinity(), weight = 0.0;
  Point2 at_nearest = p, sum = Point2::Zero();
  for (const Segment& s : segments_) {
    const PolylinePoint foot = nearest({s.from[0], s.from[1]}, p);
    if (foot.distance < least) {
      least = foot.distance;
      at_nearest = s.to[0] + foot.position * (s.to[1] - s.to[0]) + (p - foot.point);
    }
    const Point2 a = s.from[0] - p, b = s.from[1] - p;
    const double ra = a.norm(), rb = b.norm(), below = ra * rb + a.dot(b);
    if (!(ra > 0.0) || !(rb > 0.0) || !(below > 0.0)) continue;  // on the segment: `least` is zero
    const double tangent = cross2(a, b) / below;
    weight += tangent / ra + tangent / rb;
    sum += tangent / ra * s.to[0] + tangent / rb * s.to[1];
  }
  return least < tolerance_ || weight == 0.0 ? at_nearest : Point2(sum / weight);
}

double MeanValueField::distance(const Point2& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments_)
    least = std::min(least, nearest({s.from[0], s.from[1]}, p).distance);
  return least;
}

double MeanValueField::double_area() const {
  double area = 0.0;
  for (const Segment& s : segments_) area += cross2(s.from[0], s.from[1]);
  return area;
}

}  // namespace sweepmesh
