// Which layers of a column are taken by the CAD edges and linking faces that pass over a point of R.
#pragma once

#include <vector>

#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"

namespace sweepmesh {

/// Two things may share a column of R only where they take different layers, or belong together: a
/// linking face and the edges at its two ends, edges that meet in a vertex. Whatever else is brought
/// together would close a gap or a thin piece of the solid.
class Occupancy {
 public:
  Occupancy(const Model& model, const Walls& walls, const Reference& reference);

  /// A CAD edge at a place of R that lies on it (or near it: it may have been moved).
  struct Place {
    EdgeId edge;
    Point2 point;
  };

  /// Whether the edges, brought to one place, would collide. `shared` are the CAD vertices that lie
  /// there, ascending: edges that end in one of them may touch.
  bool collide(const Place& a, const Place& b, const std::vector<VertexId>& shared = {}) const;

  /// Layers taken by an edge and the linking faces above and below it, and the edges where these
  /// begin and end.
  struct Span {
    int low, high;
    std::vector<EdgeId> bottoms, tops;
  };
  Span span(const Place& place) const;

 private:
  bool touch_rightly(const std::vector<EdgeId>& lower, const std::vector<EdgeId>& upper,
                     const std::vector<VertexId>& shared) const;

  const Model& model_;
  const Walls& walls_;
  std::vector<const Polyline*> curve_;
  double coincidence_;
};

}  // namespace sweepmesh
