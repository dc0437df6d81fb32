// From a scheme to the imprint.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct ImprintOptions {
  double size = 1.0;  ///< wished length of a mesh edge, > 0
  /// Curves nearer than this part of the size are brought together, 0..1; 0 keeps all that are
  /// apart in the CAD model.
  double merge_fraction = 0.25;
};

/// What imprints of all distances of merging have in common, and most of their cost where curves
/// have to be carried from level to level.
struct ImprintBasis {
  Walls walls;
  Reference reference;  ///< its unit is the element size
};

/// `size` > 0: wished length of a mesh edge. Throws ImprintError (unreachable) and InputError.
ImprintBasis imprint_basis(const Model& model, const Scheme& scheme, double size,
                           const Context& context);

/// Divides the caps into patches; `merge_fraction` as in ImprintOptions.
/// Throws ImprintError, InputError and SolverError. See docs/imprinting.md.
Imprint imprint_on(const ImprintBasis& basis, const Model& model, const Scheme& scheme,
                   double merge_fraction, const Context& context);

/// Both in one.
Imprint imprint_caps(const Model& model, const Scheme& scheme, const ImprintOptions& options,
                     const Context& context);

}  // namespace sweepmesh
