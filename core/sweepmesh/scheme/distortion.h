// How far a sweep is from an extrusion of equal caps: what its angles at vertices do not tell.
#pragma once

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// 0 for a right prism. Two terms, each at most 1/2:
///   - log^2(A_s / A_t) / 2 of the areas of all sources and of all targets (a prismatic solid has
///   equal sums,
///     however many steps it has; an L that is swept around its corner from leg to leg has not);
///   - half the mean over the axial edges, weighted by length, of the squared turn of the edge's
///   tangent from
///     end to end in quarter turns.
/// In the unit of a scheme's cost (squared quarter turns), for ranking only. Linear in faces and
/// edges.
double sweep_distortion(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
