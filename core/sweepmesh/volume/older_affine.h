// The older layer-wise affine methods: Knupp's, and Roca's functionals F, G and H.
//
// On any set of runs: each connected part of the section between two levels is fitted by itself,
// and the maps of a run are chained over the levels that it passes, as a decomposition into
// one-to-one sweeps would do it. Nodes of several runs get the mean of what these say.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/layer_motion.h"
#include "sweepmesh/volume/one_to_one.h"

namespace sweepmesh {

/// From loop to next loop, from the highest level down (thesis A.1); free nodes are set. A layer
/// without loops keeps the shape of the one above.
void place_knupp(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 ThreadTeam& team);

/// From both ends of every run (thesis 2.3 to 2.5); free nodes are set. Without loops a run is
/// linear.
void place_least_squares(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const BaseMetric& metric, Functional functional, Points& points,
                         ThreadTeam& team);

}  // namespace sweepmesh
