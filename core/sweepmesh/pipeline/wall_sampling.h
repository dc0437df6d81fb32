// The structured coordinates of all linking faces, sampled: the columns and layers that a sweep of
// the given element size would have, without a mesh of any cap or volume.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/scheme/wall_sections.h"

namespace sweepmesh {

/// By slab, from below; empty for shells, which have no walls to speak of. Throws what the interval
/// and surface stages throw of linking faces. Linear in their nodes.
std::vector<WallSection> wall_sections(const Model& model, const Scheme& scheme,
                                       const Layout& layout, const SweepOptions& options,
                                       double size, Context& context);

}  // namespace sweepmesh
