// The path of a sweep that turns: a pipe's bend between its flanges, a hook with a collar.
//
// Its sections are not seen along one direction, but along one path. The path is the longest chain
// of axial edges, continued straight on at both ends, with a frame that turns no more than the path
// does (parallel transport; Bishop 1975). A point is *straightened* by what its section's plane
// shows: its coordinates across the path, in the frame where the plane normal to the path meets it,
// and the path's length up to there. A profile that is moved along the path becomes a straight
// prism, whatever its distance from the chain.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

class SweepPath {
 public:
  /// A place on the path: where, which way, one axis of the frame, and how far.
  struct Station {
    Point3 point, tangent, axis;
    double length;
  };

  /// `points` and unit `tangents` along the path, two or more of each; where two points are one,
  /// the path has a corner.
  SweepPath(const std::vector<Point3>& points, const std::vector<Point3>& tangents);

  /// Across the path, across it, along it. Where several planes normal to the path meet `p`, the
  /// one that is nearest to it counts. Cost: linear in the number of stations.
  Point3 straightened(const Point3& p) const;

  /// The largest angle between the path's first direction and another.
  double turning() const;

 private:
  Station between(std::size_t i, const Point3& p) const;

  std::vector<Station> stations_;
};

/// Of the axial edges of a scheme; nothing where these hardly turn (30 degrees), or lead around in
/// a circle. Cost: linear in their number.
std::optional<SweepPath> sweep_path(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
