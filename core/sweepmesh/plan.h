// What a sweep would do with a solid, without making a mesh: for people to look at beforehand.
#pragma once

#include <vector>

#include "sweepmesh/sweep.h"

namespace sweepmesh {

/// How the boundary of a linking face turns at one of its vertices.
struct CornerType {
  FaceId face;
  VertexId vertex;
  VertexType type;
};

struct SweepPlan {
  Assessment assessment;            ///< not sweepable: all else is empty
  double size = 0.0;                ///< the element size that would be used
  Intervals intervals;              ///< of the best scheme
  std::vector<CornerType> corners;  ///< by face, then along its loops
  std::vector<Points>
      edge_nodes;  ///< by EdgeId, from its start to its end; empty for others' edges
};

/// The same verdict, scheme and intervals as sweep() comes to; throws what it throws up to there.
/// Cost: that of the search for a scheme and of one integer program.
SweepPlan plan_sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                     Context& context);

}  // namespace sweepmesh
