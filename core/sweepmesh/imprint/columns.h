// CAD vertices over each other, where curves of all levels end: what the overlay begins with.
#pragma once

#include <utility>
#include <vector>

#include "sweepmesh/imprint/occupancy.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// The curves that end in each CAD vertex. Keeps references to all that it is made from.
class CurveEnds {
 public:
  CurveEnds(const Model& model, const Walls& walls, const Reference& reference);

  /// The edges that end in a vertex, each a little way along it.
  std::vector<Occupancy::Place> places(VertexId v) const;

  /// The same edges with their unit directions away from the vertex.
  std::vector<std::pair<EdgeId, Point2>> directions(VertexId v) const;

  /// The least angle by which a way along an edge turns at the edge's end `v`, to go on along
  /// another edge of its level (or the same one, where it is closed).
  double turn(EdgeId e, VertexId v) const;

  /// A place on the line a little way from its start, or its end.
  static Point2 beside(const Polyline& line, bool at_start);

 private:
  struct CurveEnd {
    const ReferenceCurve* curve;
    bool at_start;
  };
  const Walls& walls_;
  std::vector<std::vector<CurveEnd>> at_;  ///< by VertexId
};

/// CAD vertices joined by axial edges.
struct CadColumn {
  std::vector<VertexId> vertices;  ///< ascending
  Point2 place;                    ///< of the first vertex, in R
  Occupancy::Column column;
};

/// Of all vertices in which curves end, in the order of their first vertices.
std::vector<CadColumn> find_columns(const Model& model, const Scheme& scheme,
                                    const Reference& reference, const Occupancy& occupancy,
                                    const CurveEnds& ends);

/// A number for each column; columns nearer than `distance` that do not collide have the same one,
/// nearest first. The numbers are those of columns.
std::vector<int> joined_columns(const std::vector<CadColumn>& columns, const Occupancy& occupancy,
                                double distance);

}  // namespace sweepmesh
