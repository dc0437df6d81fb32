// The plane on which all columns of a sweep stand, and the CAD edges as curves there.
//
// Solids whose columns end over each other (every linking face's lower and upper edges are one
// curve when seen along one direction, whatever the face does between them): R is the projection
// along that direction. The direction need not be an axis, and caps may be inclined or curved.
//
// R is the same, bit for bit, for a solid that is turned, moved or scaled, though the coordinates
// of that differ by rounding: its frame is tied to an edge, its unit is the element size, and what
// is seen lies on a lattice of a power of two, far below the coincidence and far above the
// rounding.
#pragma once

#include <memory>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/imprint/sweep_path.h"
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
  /// The view: coordinates across the direction, in units of the element size; of a sweep along a
  /// path that turns, of the straightened solid, whose direction is the third axis.
  Point3 origin = Point3::Zero();
  Eigen::Matrix<double, 2, 3> axes = Eigen::Matrix<double, 2, 3>::Zero();
  double unit = 1.0;                      ///< the element size
  double lattice = 0.0;                   ///< coordinates are multiples of it
  std::shared_ptr<const SweepPath> path;  ///< straightens the solid before it is seen; may be none
  Point3 straightened(const Point3& p) const { return path ? path->straightened(p) : p; }
  Point2 project(const Point3& p) const {
    return on_lattice(axes * (straightened(p) - origin) / unit, lattice);
  }

  std::vector<ReferenceCurve> curves;
  std::vector<Point2> vertex;  ///< by VertexId; zero where no curve ends and no column passes
  double coincidence = 0.0;    ///< curves nearer than this are the same one in the CAD model
};

/// Directions along which every axial edge rises from its lower to its upper end: their mean, and
/// those of single edges, no two nearly parallel, at most ten.
std::vector<Point3> common_directions(const Model& model, const Scheme& scheme,
                                      const std::vector<int>& level);

/// All curves by projection along `direction` (seen against it, so that a source's normal points to
/// the viewer). `unit` > 0 is a length of the model; `coincidence` > 0, in units, also bounds the
/// chord error of the curves (a quarter of it).
Reference projected_reference(const Model& model, const Walls& walls, const Point3& direction,
                              double unit, double coincidence, const Context& context);
/// The same of the solid that `path` straightens.
Reference straightened_reference(const Model& model, const Walls& walls, const SweepPath& path,
                                 double unit, double coincidence, const Context& context);

/// Whether a linking face's lower and upper edges lie over each other, and the ends of its axial
/// ones, or those of all linking faces do: then the projection is R.
bool is_upright(const Walls& walls, const Reference& seen, FaceId face);
bool is_upright(const Walls& walls, const Reference& seen);

}  // namespace sweepmesh
