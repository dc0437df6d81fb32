// Linking faces as panels: strips of columns, with a curve wherever one of their sides has a level.
#pragma once

#include <map>
#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A strip of a linking face, from an edge below to an edge above. Point i of every line is where
/// one and the same column passes, seen along the sweep; the solid is on the left of the lines.
struct Panel {
  FaceId face;
  int low, high;               ///< levels
  std::vector<double> share;   ///< of the height, ascending from 0 to 1
  std::vector<Polyline> line;  ///< by share

  /// The curve between, at `share` of the height.
  Polyline at(double share) const;
};

/// Heights of the levels along the sweep.
using LevelHeights = std::map<int, double>;

/// Of all linking faces; `seen` are the edges' curves as seen along the sweep. A face whose lower
/// and upper edges lie over each other may have any profile; it is cut where its edges begin and
/// end. Other faces: leaning_face.h, and where that refuses, stepped_panels.h. Throws ImprintError
/// (unreachable) naming a face that is neither.
std::vector<Panel> find_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                               const Reference& seen, const LevelHeights& height);

}  // namespace sweepmesh
