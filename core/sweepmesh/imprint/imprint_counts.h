// The number of mesh edges on every imprint edge, and with them on every CAD edge.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/piece_counts.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Solves the interval problem of interval_demands.h with the imprint's own demands:
///  - a CAD edge has the sum of the counts of the imprint edges that it is divided into;
///  - the sum around every patch is even (quads), and that takes the place of the caps' sums;
///  - what lies over one another is a layer apart: a run's source and target, the caps of a slot,
///  the
///    CAD edges of one imprint edge;
///  - the loops of a linking face lie as far apart along i as the imprint edges between them count.
/// Throws SolverError where demands contradict each other, naming them.
PieceCounts count_imprint(const Model& model, const Scheme& scheme, const Imprint& imprint,
                          const IntervalOptions& options, Context& context);

/// The problem without its solution.
PieceDemands imprint_demands(const Model& model, const Scheme& scheme, const Imprint& imprint,
                             const IntervalOptions& options);

/// Where the nodes of each edge lie: evenly within each imprint edge that it is divided into, and
/// on axial edges near the levels that they pass (axial_spacing.h).
EdgeNodes place_imprinted_nodes(const Model& model, const Scheme& scheme, const Imprint& imprint,
                                const PieceCounts& counts, const IntervalOptions& options);

}  // namespace sweepmesh
