// Raises the least scaled Jacobian of an extrusion, directly: no energy stands in for it.
//
// In patches around the worst elements, free nodes climb the soft least (soft_least.h) of the
// values at all corners and centres. What is better than the worst may become worse, but no worse
// than they are. A scaled Jacobian knows angles only, so nodes could come as near each other as
// they like; therefore edges count as well, with a value that is 1 at 0.6 of their length and 0 at
// 0.4.
#pragma once

#include <functional>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/numerics/ascent/soft_least.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

/// Fixed nodes inside curved faces, that may be moved there.
struct CurvedNodes {
  struct Place {
    Point3 point, normal;
  };
  std::vector<long> nodes;  ///< ascending
  /// The place on a node's face next to `wished`, with the face's unit normal (zero where it has
  /// none); called from several threads.
  std::function<Place(long node, const Point3& wished)> onto;
};

struct RaiseOptions {
  int rings = 1;                     ///< of elements around those given that may move, >= 0
  std::vector<SlidingNode> sliding;  ///< ascending by node; as for untangling
  CurvedNodes curved;                ///< move in the tangent plane, and are brought back then
  /// Positions in which edges have their length; null: those at the start.
  const Points* lengths_of = nullptr;
  LeastAscentOptions ascent;
};

/// `fixed` without the nodes that may move.
std::vector<char> without_moving(const std::vector<char>& fixed, const RaiseOptions& options);

/// Moves free nodes near `elements`. A patch is taken over only where its least value has grown.
/// The result does not depend on the number of threads. Cost: about half a microsecond for an
/// element of a patch and step. Throws Cancelled.
void raise_least(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 const RaiseOptions& options, const std::vector<long>& elements, ThreadTeam& team,
                 const Context& context);

}  // namespace sweepmesh
