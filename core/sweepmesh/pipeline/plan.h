// What a sweep would do with a solid, without making a mesh: for people to look at beforehand.
#pragma once

#include <vector>

#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

/// How the boundary of a linking face turns at one of its vertices.
struct CornerType {
  FaceId face;
  VertexId vertex;  ///< invalid for a virtual one, which divides a rounded edge
  VertexType type;
  Point3 point;
  EdgeId edge = {};  ///< of a virtual one: that edge
};

/// Where a side of a linking face runs in the face's grid (Direction): along its edge from `from`
/// to `to`, as the face's loop does. A divided edge has one for each piece.
struct EdgeDirection {
  FaceId face;
  EdgeId edge;  ///< invalid for a cut across the face (divided_sweep.h)
  Direction direction;
  bool reversed = false;  ///< the loop runs against the edge's own direction
  Point3 from, to;
  int n_intervals = 0;
};

struct SweepPlan {
  Assessment assessment;                  ///< not sweepable: all else is empty
  double size = 0.0;                      ///< the element size that would be used
  Intervals intervals;                    ///< of the best scheme
  std::vector<CornerType> corners;        ///< by face, then along its loops
  std::vector<EdgeDirection> directions;  ///< likewise
  std::vector<Points>
      edge_nodes;  ///< by EdgeId, from its start to its end; empty for others' edges
};

/// The same verdict, scheme and intervals as sweep() comes to; throws what it throws up to there.
/// Cost: that of the search for a scheme and of one integer program.
SweepPlan plan_sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                     Context& context);

}  // namespace sweepmesh
