// Which way a face looks as a whole.
#pragma once

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// The vector area of a face: normal to its mean plane, out of the solid, its length the area
/// projected there. From chords of its edges: the error falls with the square of their number.
Point3 vector_area(const Model& model, FaceId face);

}  // namespace sweepmesh
