// A one-to-one sweep, as the older methods of placement see it.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

struct OneToOne {
  const Extrusion& extrusion;
  int k_low = 0, k_high = 0;
  std::vector<int> rim;                       ///< columns of the linking faces, ascending
  std::vector<int> inner;                     ///< all others
  std::vector<std::array<int, 2>> rim_edges;  ///< directed, the base on their left
  std::vector<double> fraction;               ///< of the height, per level k_low .. k_high: 0 .. 1

  Point3 at(const Points& points, int column, int k) const {
    return points.row(extrusion.node(column, k));
  }
  std::vector<Point3> rim_at(const Points& points, int k) const;
  /// Closed polylines of the rim, each in the direction of its edges.
  std::vector<std::vector<int>> loops() const;
  /// Half the sum of a x b over the rim's edges: the normal of the loops, as long as their area.
  Point3 rim_area(const Points& points, int k) const;
};

/// Throws InputError when the extrusion is no one-to-one sweep, or its boundary is not just the two
/// caps and the linking columns.
OneToOne make_one_to_one(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const BaseMetric& metric);

/// The layer-wise methods that know one-to-one sweeps only; free nodes are set. See
/// placement_method.h.
void place_boundary_error(const OneToOne& sweep, Points& points, ThreadTeam& team,
                          const Context& context);
void place_bm_sweep(const OneToOne& sweep, Points& points);

/// Roca's functionals.
enum class Functional { f, g, h };

/// Linear map y -> map y + shift of a fit between two loops.
struct LoopMap {
  Eigen::Matrix3d matrix;
  Point3 shift;
  Point3 operator()(const Point3& p) const { return matrix * p + shift; }
};

/// Fits the points x to y with one of Roca's functionals (thesis 2.3 to 2.5; Knupp's map of A.1 is
/// G's); the areas are the loops'. Directions that the data say nothing of are mapped to nothing
/// (least norm).
LoopMap fit_points(const std::vector<Point3>& x, const std::vector<Point3>& y, const Point3& area_x,
                   const Point3& area_y, Functional functional);

/// The same for the loop at level `from` and that at level `to`.
LoopMap fit_loops(const OneToOne& sweep, const Points& points, int from, int to,
                  Functional functional);

}  // namespace sweepmesh
