// Makes a placed volume valid, or says that its boundary does not let it be.
//
// First the inner nodes move alone: nodes inside caps that are dragged along by inverted elements
// may leave their faces' outlines before the elements are valid, and never come back. Only what
// stays inverted so, and what the boundary's mesh itself inverts, may take the sliding nodes along.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {

/// Moves nodes near the elements `inverted` (ascending; all that are, by kDegenerate) until they
/// are valid. Fixed nodes stay, but for those `sliding`. Throws InvalidMeshError("place"), with the
/// elements, where some stay inverted: at once where the boundary alone makes them so, whatever
/// slides. Throws Cancelled. Cost: that of two calls of untangle() at most.
void unfold_inverted(const Extrusion& extrusion, const BaseMetric& metric,
                     const std::vector<char>& fixed, const std::vector<SlidingNode>& sliding,
                     int max_attempts, const std::vector<long>& inverted, Points& points,
                     ThreadTeam& team, const Context& context);

}  // namespace sweepmesh
