// Plane polylines measured by arc length.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/lattice.h"

namespace sweepmesh {

using Polyline = std::vector<Point2>;

/// Arc length from the first point to each point; the last is the whole length.
std::vector<double> arc_lengths(const Polyline& line);
double length(const Polyline& line);

/// A place on a polyline: `arc` from its start, `position` as index and fraction of the segment.
struct PolylinePoint {
  Point2 point;
  double arc = 0.0;
  double position = 0.0;
  double distance = 0.0;  ///< from the point asked for, where there was one
};

/// The place on a segment that is nearest to a point.
struct SegmentPlace {
  double share = 0.0;    ///< of the segment, from its start
  double squared = 0.0;  ///< distance from the point
};
inline SegmentPlace nearest_on_segment(const Point2& start, const Point2& end, const Point2& p) {
  const Point2 d = end - start, off = p - start;
  const double whole = d.squaredNorm(), along = off.dot(d);
  const double share = along <= 0.0 ? 0.0 : along >= whole ? 1.0 : along / whole;
  return {share, (off - share * d).squaredNorm()};
}

PolylinePoint at_arc(const Polyline& line, double arc);
PolylinePoint at_position(const Polyline& line, double position);
PolylinePoint nearest(const Polyline& line, const Point2& p);
/// at_position without the arc: as quick for long lines as for short ones.
Point2 point_at(const Polyline& line, double position);

/// Points at most `spacing` of arc apart, both ends and all corners included, with their arcs.
std::vector<PolylinePoint> resampled(const Polyline& line, double spacing);

/// The part between two places; first before last.
Polyline part(const Polyline& line, double first_position, double last_position);

/// The line with its ends moved to `first` and `last`, and all points between by amounts that
/// change linearly with the arc; so a straight line stays straight.
Polyline with_ends(const Polyline& line, const Point2& first, const Point2& last);

/// The same, but no other point moves.
Polyline with_ends_only(const Polyline& line, const Point2& first, const Point2& last);

/// Without the points that are nearer to one of its ends than that.
Polyline apart_from_ends(const Polyline& line, double distance);

struct Box2 {
  Point2 low, high;
  bool is_near(const Box2& other, double distance) const {
    return (low.array() <= other.high.array() + distance).all() &&
           (other.low.array() <= high.array() + distance).all();
  }
};
Box2 box_of(const Polyline& line);

}  // namespace sweepmesh
