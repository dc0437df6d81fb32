// The imprint as shapes for people to see and to keep: the caps cut along the imprinted curves.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/model/divided_faces.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A cap with the curves of the imprint that run inside it, and what lies on either side of each:
/// numbers of pairs. A pair is a run: a part of a target and the part of a source above it.
struct CapDivision {
  struct Sides {
    int left, right;  ///< seen from outside the solid
  };
  FaceDivision division;
  std::vector<Sides> sides;  ///< by curve
  int whole = -1;            ///< the pair of a cap without curves
};

/// Divisions of all caps, by face. Curves run on the cap itself: those of R (imprint.h) carried
/// there by a map of the cap's part of R without folds, its boundary going to the cap's edges as
/// the mesh will. Pairs count from 0, patch by patch, runs from below. Throws InvalidMeshError
/// naming the cap where no such map is found, and what Chart throws. Cost: some thousand nodes a
/// cap.
std::vector<CapDivision> divide_caps(const Model& model, const Scheme& scheme,
                                     const Imprint& imprint, const Context& context);

}  // namespace sweepmesh
