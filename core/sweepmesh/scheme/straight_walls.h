// Sweeps whose walls are made of straight columns: nothing winds there.
#pragma once

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Whether all axial edges are straight and the linking faces, where they are curved, have the same
/// normal at both ends of each (planes, cylinders, cones, drafts along them): two such columns wind
/// around each other by less than half a turn, as the line between them moves linearly. False where
/// a linking face has no axial edge. A few evaluations an edge.
bool has_straight_walls(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
