// What the solid holds over each face of the overlay: layers inside, caps below and above.
#pragma once

#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/overlay.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// The imprint of an overlay: faces of the arrangement that the solid covers between some levels
/// become patches with their runs.
///  - Between two neighbouring levels, a face is inside the solid or not; that changes across an
///    edge where a linking face stands there, and the linking face says which side is in.
///  - A cap is what its boundary encloses.
///  - A run begins on exactly one target and ends at exactly one source, and every part of a cap
///    begins or ends a run. Throws ImprintError (open_run, no_room) that names what is there
///    instead.
/// Linear in faces times levels.
Imprint imprint_of(const Model& model, const Scheme& scheme, const Walls& walls, Overlay overlay);

}  // namespace sweepmesh
