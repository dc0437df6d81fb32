// Where the nodes of each edge lie: the same for all faces that use it.
#pragma once

#include <vector>

#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// By edge id: curve parameters from the edge's start to its end, both included, ascending; empty
/// for edges of other solids.
struct EdgeNodes {
  std::vector<std::vector<double>> t;
};

/// n + 1 fractions 0..1 whose steps grow by the bias; even without one.
std::vector<double> biased_fractions(int n, const Bias& bias);

/// Equal steps of arc length, or steps that grow geometrically on edges with a bias (their own, or
/// that of the sweep where `intervals.k` differs between their ends).
EdgeNodes place_edge_nodes(const Model& model, const Intervals& intervals,
                           const IntervalOptions& options);

}  // namespace sweepmesh
