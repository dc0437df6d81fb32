// Exact arrangement of polylines in the plane: where they meet, what they share, what they enclose.
//
//      1        2            Vertices are the polylines' ends and every point where two of them
//   ---+---.----+---         cross, touch, or begin or end to overlap. Edges are what lies between;
//      |  face  |            an edge that several polylines run along is there once and knows them
//   ---+---'----+---         all. Faces are the connected pieces of the plane that remain.
//
// Computed with CGAL's exact constructions, so nothing is missed, however small the angle. Only the
// points handed back are rounded.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// An edge walked from its start to its end, or back.
struct DirectedEdge {
  int edge = -1;
  bool reversed = false;
  auto operator<=>(const DirectedEdge&) const = default;
};

struct PlaneArrangement {
  /// A polyline that runs along an edge, between positions `first` and `last` on it: 2.25 is a
  /// quarter of the way from its point 2 to its point 3. first > last where it runs against it.
  struct Use {
    int polyline;
    double first, last;
  };
  struct Edge {
    int start, end;              ///< vertices; equal for a closed edge
    std::vector<Point2> points;  ///< both ends included
    std::vector<Use> uses;       ///< at least one
  };
  /// Closed walks with the face on their left.
  struct Face {
    bool is_bounded = true;
    std::vector<std::vector<DirectedEdge>> loops;  ///< the outer one first, if bounded; then holes
  };

  std::vector<Point2> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;  ///< one of them is unbounded
};

/// Arranges polylines of at least two points; repeated points within one are passed over. A
/// polyline is closed when its first and last points are the same. It may meet itself only there.
/// Throws InputError for coordinates that are not finite or a polyline without two different
/// points. Cost: n log n for n segments and crossings, some 10 microseconds each. The order of
/// vertices, edges and faces depends on the coordinates only.
PlaneArrangement arrange(const std::vector<std::vector<Point2>>& polylines);

}  // namespace sweepmesh
