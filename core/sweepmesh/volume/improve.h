// Better elements where few are poor, by moving free nodes near them.
//
// Poor elements, and those near the least value, first follow an energy (untangle.h), which also
// makes their neighbours better; then the least value itself is raised (raise_least.h), with more
// and more neighbours, until it reaches what the boundary allows or nothing is gained.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/raise_least.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

struct ImproveOptions {
  /// Elements with a scaled Jacobian up to this are improved; in 0..1.
  double up_to = 0.2;
  /// While the least value is below the first number, elements within the second of it are improved
  /// too, for as long as that helps; 0 and 0 switch it off.
  double lift_below = 0.7, lift_within = 0.03;
  /// At most this number of elements and this part of all at a time, the worst ones: else the time
  /// would no longer be linear. Elements that the boundary alone makes poor do not count.
  long at_most = 1000;
  double at_most_part = 1e-4;
  std::vector<SlidingNode> sliding;  ///< ascending by node
  CurvedNodes curved;
};

/// All elements must be positive, `least` is the least of their scaled Jacobians; returns what it
/// is then, never less. The result does not depend on the number of threads. Throws Cancelled.
double improve_elements(const Extrusion& extrusion, const std::vector<char>& fixed,
                        const BaseMetric& metric, const ImproveOptions& options, double least,
                        Points& points, ThreadTeam& team, const Context& context);

}  // namespace sweepmesh
