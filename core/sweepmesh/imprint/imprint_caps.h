// From a scheme to the imprint.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct ImprintOptions {
  double size = 1.0;  ///< wished length of a mesh edge, > 0
  /// Curves nearer than this part of the size are brought together, 0..1; 0 keeps all that are
  /// apart in the CAD model.
  double merge_fraction = 0.25;
};

/// Divides the caps into patches.
/// Throws ImprintError, InputError (options) and SolverError. See docs/imprinting.md.
Imprint imprint_caps(const Model& model, const Scheme& scheme, const ImprintOptions& options,
                     const Context& context);

}  // namespace sweepmesh
