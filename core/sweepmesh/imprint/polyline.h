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

PolylinePoint at_arc(const Polyline& line, double arc);
PolylinePoint at_position(const Polyline& line, double position);
PolylinePoint nearest(const Polyline& line, const Point2& p);

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
