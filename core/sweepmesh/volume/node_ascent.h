// Raises the mean scaled Jacobian of an extrusion node by node.
//
// A free node goes a step along the gradient of the sum of the scaled Jacobians around it, if that
// sum then rises and the least of them does not fall below the least of the whole mesh (or below
// what it was, where that is less), and no edge at it becomes shorter than 0.3 of the mean one
// there (or than it was). Steps grow while they succeed and shrink while they fail. Nodes
// of one colour of columns and one parity of levels share no element, so they move at the same
// time, and the result does not depend on the number of threads.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

struct AscentOptions {
  int n_sweeps = 4;                  ///< over all free nodes, >= 0
  double first_step = 0.2;           ///< in shortest edges at the node, > 0
  double longest_step = 0.5;         ///< likewise
  std::vector<SlidingNode> sliding;  ///< ascending by node; fixed ones that move in a plane
};

/// Linear: about 100 scaled Jacobians a free node and sweep. Throws Cancelled.
void ascend_nodes(const Extrusion& extrusion, const std::vector<char>& fixed,
                  const AscentOptions& options, Points& points, ThreadTeam& team,
                  const Context& context);

}  // namespace sweepmesh
