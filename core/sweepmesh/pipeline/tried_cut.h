// A suggested cut whose pieces have been meshed.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/scheme/suggested_cut.h"

namespace sweepmesh {

/// As suggest_cut with `options`, where a piece can be meshed if sweep() gives a mesh of it at its
/// default size. Cost: that of a few meshes of 3000 elements. Throws Cancelled.
std::optional<SuggestedCut> suggest_tried_cut(const Model& model,
                                              const std::vector<Reason>& reasons,
                                              CutOptions options, Context& context);

}  // namespace sweepmesh
