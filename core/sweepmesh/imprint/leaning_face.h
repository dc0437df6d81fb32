// Panels of a linking face that leans, whose lower and upper edges do not lie over each other.
//
// Its columns follow from lengths: the face is laid out over i, where every lower edge runs along
// +i and every upper one along -i, each as long as it is seen if the outline closes with these
// lengths, or else with the least change of them in proportion (least squares), and an axial edge
// has one i. Vertices that nearly share their i and lie over each other share it. Between two
// neighbouring i of vertices, columns run from the lower edge to the first edge above it; where a
// side of such a strip has a vertex on a level between, the strip passes through that vertex.
#pragma once

#include "sweepmesh/imprint/panels.h"

namespace sweepmesh {

/// Throws ImprintError (unreachable) naming the face when it has more than one loop, or when an
/// edge would have to run backwards or has no edge above it. Cost: the cube of the face's number of
/// vertices.
std::vector<Panel> leaning_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                                  const Reference& seen, const LevelHeights& height, FaceId face);

}  // namespace sweepmesh
