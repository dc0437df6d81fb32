// Where the mesh of one cap passes into that of the other.
//
// Carried along by the layers' motion, the low cap's mesh is not quite the high cap's: a dome
// against a disc, another map of the nodes around a hole. What differs beyond the rims' own
// difference (which is harmonic in the base: the residual deals with it) is the *mismatch* of a
// block. The prediction spreads it over all layers. Where one cap is the worse of the two, that
// spoils them all; here each block may keep the better cap's shape through one half of the height:
//
//      share of the    1 |          /       over all layers, or over the half next to either end;
//      high cap's        |      __//        no less, for elements would get too high there
//      shape           0 |____/__/
//                        low       high
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/layer_motion.h"

namespace sweepmesh {

struct TransitionOptions {
  /// Mismatches up to this length count as none, >= 0.
  double negligible = 0.0;
  /// A transition over half of the height must raise the mean scaled Jacobian by this, > 0, and
  /// may neither lower the least one nor invert an element.
  double least_gain = 0.01;
};

/// Moves the free nodes of `points` (predictions and their corrections) where a block gains by it;
/// returns whether one did. Completes the metric if it needs it. Linear; costs little where caps
/// match. Throws Cancelled.
bool choose_transitions(const Extrusion& extrusion, const std::vector<char>& fixed,
                        BaseMetric& metric, const LayerMotion& motion,
                        const TransitionOptions& options, Points& points, ThreadTeam& team,
                        const Context& context);

}  // namespace sweepmesh
