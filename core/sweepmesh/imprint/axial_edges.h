// Edges along the sweep, from their lower to their upper end.
#pragma once

#include <vector>

#include "sweepmesh/base/ids.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct AxialEdge {
  EdgeId edge;
  VertexId low, high;
};

/// Of the linking faces, each as often as a face uses it.
std::vector<AxialEdge> axial_edges(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
