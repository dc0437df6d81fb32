#include "sweepmesh/imprint/mean_value_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sweepmesh {
void MeanValueField::add(const Polyline& from, const Polyline& to) {
  for (std::size_t i = 0; i + 1 < from.size(); ++i)
    if (from[i] != from[i + 1]) segments_.push_back({{from[i], from[i + 1]}, {to[i], to[i + 1]}});
}

MeanValueField::Nearest MeanValueField::nearest(const Point2& p) const {
  Nearest out;
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments_) {
    const SegmentPlace place = nearest_on_segment(s.from[0], s.from[1], p);
    if (place.squared >= least) continue;
    least = place.squared;
    out.segment = &s;
    out.share = place.share;
  }
  out.distance = std::sqrt(least);
  return out;
}

Point2 MeanValueField::operator()(const Point2& p) const {
  if (segments_.empty()) return p;
  const Nearest foot = nearest(p);
  const auto with_nearest = [&] {
    const auto& [from, to] = *foot.segment;
    return Point2(to[0] + foot.share * (to[1] - to[0]) +
                  (p - (from[0] + foot.share * (from[1] - from[0]))));
  };
  if (foot.distance < tolerance_) return with_nearest();
  double weight = 0.0;
  Point2 sum = Point2::Zero();
  for (const Segment& s : segments_) {
    const Point2 a = s.from[0] - p, b = s.from[1] - p;
    const double ra = a.norm(), rb = b.norm(), below = ra * rb + a.dot(b);
    if (!(ra > 0.0) || !(rb > 0.0) || !(below > 0.0)) continue;  // on the segment
    const double tangent = cross2(a, b) / below;
    weight += tangent / ra + tangent / rb;
    sum += tangent / ra * s.to[0] + tangent / rb * s.to[1];
  }
  return weight == 0.0 ? with_nearest() : Point2(sum / weight);
}

double MeanValueField::distance(const Point2& p) const {
  return nearest(p).distance;
}

double MeanValueField::double_area() const {
  double area = 0.0;
  for (const Segment& s : segments_) area += cross2(s.from[0], s.from[1]);
  return area;
}

}  // namespace sweepmesh
