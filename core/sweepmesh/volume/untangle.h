// Unfolds inverted elements of an extrusion, and improves poor ones, by moving free nodes near
// them.
//
// Elements at or below a threshold, and rings of neighbours around them, form patches; in each the
// regularised elliptic energy (foldover_energy.h) is minimised over the free nodes, all others
// held. The ideal element comes from the intrinsic idealised model: lengths of the base mesh
// between those of the run's two ends, heights of the layers, right (or regular) angles. What stays
// inverted is tried again with twice the rings.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/foldover_energy.h"

namespace sweepmesh {

/// A fixed node that may be moved within the plane through it with this unit normal: one inside a
/// planar cap, say.
struct SlidingNode {
  long node = -1;
  Point3 normal = Point3::Zero();
};

/// The entry of a node in an ascending list, or null.
const SlidingNode* find_sliding(const std::vector<SlidingNode>& sliding, long node);

/// `fixed` without the nodes that may slide.
std::vector<char> without_sliding(std::vector<char> fixed, const std::vector<SlidingNode>& sliding);

struct UntangleOptions {
  double threshold = 0.0;  ///< elements with a scaled Jacobian up to this are to be mended
  int first_rings = 2;     ///< rings of elements around them that may move, >= 1
  int max_attempts = 5;    ///< each with twice the rings of the one before, >= 1
  /// Ideal corners have the lengths that their edges have now, at right (or regular) angles: for
  /// valid elements, whose scaled Jacobian knows angles only. Otherwise the lengths of the
  /// idealised model.
  bool keeps_lengths = false;
  std::vector<SlidingNode> sliding;  ///< ascending by node
  UnfoldOptions energy;
};

struct UntangleReport {
  int n_attempts = 0;
  long n_moved = 0;             ///< nodes that were free to move in the last attempt
  std::vector<long> remaining;  ///< elements that stay at or below the threshold
};

/// Moves free nodes of `points` until none of `elements` (those at or below the threshold, as
/// check_elements lists them) is left, or attempts run out, or one leaves more than a tenth of all
/// elements, or a later one mends less than a tenth of what is left. A patch is only taken over
/// when it is better than before: fewer elements at or below the threshold, or as many and a
/// greater least scaled Jacobian; a positive least value never falls. The result does not depend on
/// the number of threads. Throws Cancelled.
UntangleReport untangle(const Extrusion& extrusion, const BaseMetric& metric,
                        const std::vector<char>& fixed, Points& points,
                        const UntangleOptions& options, const std::vector<long>& elements,
                        ThreadTeam& team, const Context& context);

/// The most that an element's scaled Jacobian can be, wherever its free nodes are: at corners whose
/// node and two or three neighbours are fixed, the sine of the angle between these sides, or the
/// corner's own value. `fixed` as above.
double bound_by_boundary(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const Points& points, SweptElement element);

/// Elements that no position of the free nodes can make valid: a corner with all its nodes fixed is
/// inverted or flat. Of those in `elements`.
std::vector<long> hopeless_elements(const Extrusion& extrusion, const std::vector<char>& fixed,
                                    const Points& points, const std::vector<long>& elements);

}  // namespace sweepmesh
