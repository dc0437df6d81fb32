// The number of mesh edges on every shell edge, and with them on every CAD edge.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/piece_counts.h"
#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Solves the interval problem of interval_demands.h, in which the two CAD edges of a shell edge
/// have the same count, cuts have counts of their own, the sum around every patch is even (quads),
/// and a patch's source lies at least a layer above its target. Throws SolverError where demands
/// contradict each other, naming them.
PieceCounts count_shell(const Model& model, const Scheme& scheme, const Shell& shell,
                        const IntervalOptions& options, Context& context);

/// n + 1 parameters on a face, evenly spaced in length along a polyline in its parameter plane; the
/// ends are the polyline's.
std::vector<Point2> even_on_face(const Model& model, FaceId face, const std::vector<Point2>& uv,
                                 int n);

}  // namespace sweepmesh
