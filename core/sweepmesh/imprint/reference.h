// The plane on which all columns of a sweep stand, and the CAD edges as curves there.
//
// Solids whose columns end over each other (every linking face's lower and upper edges are one curve
// when seen along one direction, whatever the face does between them): R is the projection along
// that direction. The direction need not be an axis, and caps may be inclined or curved.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/imprint/walls.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A transverse edge, or one between two caps, from its start to its end.
struct ReferenceCurve {
  EdgeId edge;
  Polyline points;
  std::vector<double> t;  ///< parameters on the edge, ascending
};

struct Reference {
  std::vector<ReferenceCurve> curves;
  std::vector<Point2> vertex;  ///< by VertexId; zero where no curve ends and no column passes
  double coincidence = 0.0;    ///< curves nearer than this are the same one in the CAD model
};

/// The direction in which all axial edges run from their lower to their upper end, if there is one
/// to within `tolerance` at their ends. Empty without axial edges.
std::optional<Point3> common_direction(const Model& model, const Scheme& scheme,
                                       const std::vector<int>& level, double tolerance);

/// R by projection along `direction` (seen against it, so that a source's normal points to the
/// viewer). Empty where a linking face's lower and upper edges do not lie over each other.
/// `coincidence` > 0 also bounds the chord error of the curves (a quarter of it).
std::optional<Reference> projected_reference(const Model& model, const Walls& walls,
                                             const Point3& direction, double coincidence,
                                             const Context& context);

}  // namespace sweepmesh
