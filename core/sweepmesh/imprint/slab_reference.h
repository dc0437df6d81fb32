// The reference domain of a sweep whose linking faces lean, twist or change their outline.
//
// All curves are seen along one direction. R is the section halfway up the base slab, the one with
// the largest section. From slab to slab, upwards and downwards, linking faces carry R along their
// columns (panels.h); what else lies on the next level (the edges of a hole's floor, of a step,
// between two caps) is carried by a map of the slab's section without folds (section_map.h), or
// outside of it by mean value interpolation of its outline.
#pragma once

#include "sweepmesh/imprint/panels.h"

namespace sweepmesh {

/// `direction` as in projected_reference, `seen` the curves seen along it, in element sizes.
/// Throws ImprintError (unreachable) where a linking face has no columns to follow, or a section no
/// map without folds.
Reference slab_reference(const Model& model, const Scheme& scheme, const Walls& walls,
                         const Point3& direction, const Reference& seen, const Context& context);

}  // namespace sweepmesh
