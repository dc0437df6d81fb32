// The verdict with what the shape of the linking faces says of folding.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/fold_bound.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Of a scheme, from its structured coordinates at the default element size. Zero where sections
/// have no holes or walls are straight, and where no structured coordinates can be had: the stages
/// that need them say why. Cost: imprint, intervals and the grids of the linking faces.
Winding winding_of(const Model& model, const Scheme& scheme, Context& context);

/// assess(), less the schemes whose holes wind beyond kMostWinding, those beyond kSafeWinding at
/// the end. Looks at one scheme after the other until one is safe; those after it stay as they are.
/// Where none is left the reason names the walls of the holes, and the verdict `folds`.
Assessment assess_with_shape(const Model& model, const Picks& picks, Context& context);

}  // namespace sweepmesh
