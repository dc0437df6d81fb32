// Where a solid is divided so that a boundary that turns without a vertex can turn in a sweep.
//
// The templates (templates.h) put virtual vertices on rounded edges. In a sweep the two pieces of
// such an edge have different directions, so the face on its other side has to be divided there,
// too: the wall of a hole across the sweep becomes a floor, a ceiling and two sides.
#pragma once

#include <vector>

#include "sweepmesh/model/divided_model.h"
#include "sweepmesh/scheme/templates.h"

namespace sweepmesh {

/// Cuts that hang together by the edges that they divide: all of a group or none of it are made.
using CutGroup = std::vector<FaceCut>;

/// From each virtual vertex on a round of one face a cut runs through the face on the edge's other
/// side, along the line of constant u or v that leaves the edge more steeply, to the opposite edge;
/// from there through the next face, unless that edge is a round of that face: then the round takes
/// its corners there. Cuts that would end on a seam, at a pole or nowhere are left out together
/// with their group. Rounds of faces without a straight edge are divided only where a cut arrives.
/// Deterministic; linear in the number of edges but for the search of each cut's other end.
std::vector<CutGroup> round_cuts(const Model& model, const TemplateOptions& options = {});

}  // namespace sweepmesh
