// The exact arrangement of pieces: where they meet, and what CAD edges its edges stand for.
#pragma once

#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/pieces.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/numerics/cgal/arrangement.h"

namespace sweepmesh {

struct ArrangedPieces {
  PlaneArrangement arrangement;
  std::vector<int> piece;  ///< by polyline of the arrangement
  std::vector<int> node;   ///< by vertex of the arrangement; -1 where there is no node yet
};

/// Of all pieces that are alive. Throws ImprintError (collision) where two nodes lie on one point.
ArrangedPieces arrange_pieces(const PieceGraph& graph);

/// By edge of the arrangement: the parts of CAD edges that lie over it, ascending levels. Throws
/// ImprintError (collision) where two pieces lie over each other.
std::vector<std::vector<Trace>> traces_of(const ArrangedPieces& arranged, const PieceGraph& graph,
                                          const Walls& walls);

}  // namespace sweepmesh
