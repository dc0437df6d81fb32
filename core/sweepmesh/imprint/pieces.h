// Curves in R cut at nodes, while they are being brought together. Internal to the overlay.
#pragma once

#include <vector>

#include "sweepmesh/base/ids.h"
#include "sweepmesh/imprint/polyline.h"

namespace sweepmesh {

/// Where a CAD edge lies itself along a piece, in the piece's direction.
struct PieceTrace {
  EdgeId edge;
  Polyline line;
  std::vector<double> t;  ///< its parameters at the line's points
};

/// A part of one or more CAD edges between two nodes.
struct Piece {
  int start = -1, end = -1;        ///< equal for a closed piece
  Polyline points;                 ///< from node to node; its shape is that of the first trace
  std::vector<PieceTrace> traces;  ///< at least one
};

struct PieceNode {
  Point2 point;
  std::vector<VertexId> cad;   ///< ascending
  std::vector<Point2> places;  ///< where the CAD vertices lie themselves
};

/// Nodes and pieces; a piece that has been cut or merged away keeps its place with no traces.
struct PieceGraph {
  std::vector<PieceNode> nodes;
  std::vector<Piece> pieces;

  bool is_alive(int piece) const { return !pieces[piece].traces.empty(); }
  bool has_end(int piece, int node) const {
    return pieces[piece].start == node || pieces[piece].end == node;
  }
};

/// The trace of a CAD edge, cut where `fraction` of its arc has passed.
std::pair<PieceTrace, PieceTrace> cut(const PieceTrace& trace, double fraction);

/// Cuts a piece at `arc` from its start and puts `node` there: both parts are moved to end in it.
/// Traces are cut at the same part of their length, or where one of the node's CAD vertices lies on
/// them, to within `coincidence`. The first part takes the piece's place, the second comes last and
/// is returned.
int split(PieceGraph& graph, int piece, double arc, int node, double coincidence);

/// Joins pieces that follow each other at nodes where nothing else ends and no CAD vertex is, each
/// trace of the one going on in the other: such nodes are left over from bringing curves together,
/// and would each be a corner of cells.
void join_pieces(PieceGraph& graph);

/// Gives piece `kept` the traces of `gone`, which has the same end nodes.
void absorb(PieceGraph& graph, int kept, int gone);

/// Whether no point of either line is farther than `distance` from the other (at corners and a
/// sixteenth of their length apart).
bool are_within(const Polyline& a, const Polyline& b, double distance);

/// A part of line `a` that is nearer than `distance` to `b`, by arcs of `a`.
struct Stretch {
  double first = 0.0, last = 0.0;
};
std::vector<Stretch> near_stretches(const Polyline& a, const Polyline& b, double distance);

}  // namespace sweepmesh
