// Linking faces that lean and have nothing else beside them where they begin: where their edges go.
#pragma once

#include <set>
#include <vector>

#include "sweepmesh/imprint/panels.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Leaning linking faces (of which `is_upright`, by FaceId, is not true) that begin at a level,
/// going upwards or downwards, with nothing else beside them there: no face ends at their edges,
/// and whatever meets these is of such a face too.
std::set<FaceId> free_leaning_faces(const Model& model, const Walls& walls,
                                    const std::vector<ReferenceCurve>& curves,
                                    const std::vector<Panel>& panels,
                                    const std::vector<char>& is_upright, int level, bool upwards);

/// Moves an edge of a linking face that begins at a level to where the face is halfway to its other
/// end, so that what turns or grows on the way is half as far away.
void lean_halfway(FaceId face, const std::vector<Panel>& panels, int level, bool upwards,
                  ReferenceCurve& curve);

}  // namespace sweepmesh
