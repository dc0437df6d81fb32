// Which levels of a column are taken by the CAD edges and linking faces that pass over a point of
// R.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"

namespace sweepmesh {

/// Two things may share a column of R only where they take different levels, or belong together: a
/// linking face and the edges at its two ends. Whatever else is brought together would close a gap
/// or a thin piece of the solid.
class Occupancy {
 public:
  Occupancy(const Model& model, const Walls& walls, const Reference& reference);

  /// A CAD edge at a place of R that lies on it (or near it: it may have been moved).
  struct Place {
    EdgeId edge;
    Point2 point;
  };

  /// A linking face that goes on from the end of a column, up (or down) to `level` and the edges
  /// there.
  struct Reach {
    FaceId face;
    int level;
    std::vector<EdgeId> edges;
  };
  /// CAD vertices and axial edges over each other in the levels low..high, and what goes on from
  /// there.
  struct Column {
    int low, high;
    std::vector<Reach> up, down;
  };

  /// The column of vertices at which the edges `ends` end, each given at a place near its end.
  Column column(const std::vector<VertexId>& vertices, const std::vector<Place>& ends) const;

  /// Whether the edges or columns, brought to one place, would collide. Edges do not where their
  /// linking faces meet in the vertices `there`, which are of one column.
  bool collide(const Place& a, const Place& b, const std::vector<VertexId>& there = {}) const;
  bool collide(const Column& a, const Column& b) const;
  bool collide(const Column& a, const Place& b) const;

  /// Levels taken by an edge and the linking faces above and below it, and the edges where these
  /// begin and end.
  struct Span {
    int low, high;
    std::vector<EdgeId> bottoms, tops;
  };
  Span span(const Place& place) const;

 private:
  std::optional<Reach> reach(const Place& place, bool upwards) const;
  bool meet_in(const std::vector<VertexId>& there, const Span& a, const Span& b) const;

  const Model& model_;
  const Walls& walls_;
  std::vector<const Polyline*> curve_;
  double coincidence_;
};

}  // namespace sweepmesh
