// Raises the least scaled Jacobian of an extrusion, directly: no energy stands in for it.
//
// In patches around the worst elements, free nodes climb the soft least (soft_least.h) of the
// values at all corners and centres, and of the lengths of edges, which keep elements from
// shrinking to nothing while their angles improve. That goes on until nothing is gained any more;
// what is better than the worst may become worse, but no worse than they are.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/numerics/ascent/soft_least.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

struct RaiseOptions {
  int rings = 1;                     ///< of elements around those given that may move, >= 0
  std::vector<SlidingNode> sliding;  ///< ascending by node; as for untangling
  LeastAscentOptions ascent;
};

/// Moves free nodes near `elements`. A patch is taken over only where its least value has grown.
/// The result does not depend on the number of threads. Cost: about half a microsecond for an
/// element of a patch and step. Throws Cancelled.
void raise_least(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 const RaiseOptions& options, const std::vector<long>& elements, ThreadTeam& team,
                 const Context& context);

}  // namespace sweepmesh
