// The order of the levels: which caps and transverse edges lie above which.
#pragma once

#include <vector>

#include "sweepmesh/imprint/sweep_path.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A rank for every vertex of a transverse edge or a cap, by VertexId; -1 for others. The same
/// along transverse edges and all over a cap, growing along +k of every axial edge; where that
/// leaves a choice, in the order of the mean heights along the mean direction of the axial edges,
/// or along `path` if there is one,
/// equal heights sharing a rank. Layers (Intervals::k) come later: they follow this order wherever
/// one thing lies over another, but need not do so elsewhere. Throws Error("imprint") where axial
/// edges lead around in a circle.
std::vector<int> sweep_levels(const Model& model, const Scheme& scheme,
                              const SweepPath* path = nullptr);

}  // namespace sweepmesh
