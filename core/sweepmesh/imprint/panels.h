// Linking faces as panels: pieces with one curve below and one above.
#pragma once

#include <map>
#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// `bottom[i]` and `top[i]` are the ends of one column, seen along the sweep; the solid is on the
/// left of both lines.
struct Panel {
  FaceId face;
  int low, high;  ///< levels
  Polyline bottom, top;

  /// The curve between, at `share` of the height.
  Polyline at(double share) const {
    Polyline out = bottom;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += share * (top[i] - bottom[i]);
    return out;
  }
};

/// Mean heights of the levels along a direction, by level; made to grow with the levels. In units
/// of R and on its lattice.
using Heights = std::map<int, double>;
Heights level_heights(const Model& model, const Walls& walls, const Point3& direction,
                      const Reference& seen);

/// Of all linking faces; `seen` are the edges' curves as seen along the sweep. A face whose lower
/// and upper edges lie over each other may have any profile; it is cut where its edges begin and
/// end. In another face columns join the places where the same part of both lengths has passed:
/// of the chain of edges below and the one above, or, where its outline has steps, from level to
/// level (stepped_panels.h). Throws ImprintError (unreachable) naming a face that is none of these.
std::vector<Panel> find_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                               const Reference& seen, const Heights& height);

/// The panel between two lines, both along +i, in which columns join equal parts of the lengths.
Panel ruled_panel(FaceId face, int low, int high, const Polyline& bottom, const Polyline& top);

}  // namespace sweepmesh
