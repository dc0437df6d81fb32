// Parameters (u,v) for the interior nodes of a structured region, from those of its boundary.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/intervals/grid_region.h"

namespace sweepmesh {

/// A region with (u,v) and positions at its nodes; those of the first n_boundary are given.
struct PlacedRegion {
  GridRegion region;
  int period = 0;  ///< as in fill_region
  std::vector<Point2> uv;
  std::vector<Point3> points;  ///< boundary nodes only: used for arc lengths
};

/// Mean length of the boundary's steps in each column (steps along i) and row (steps along k).
class GridSpacing {
 public:
  explicit GridSpacing(const PlacedRegion& placed);
  double of_column(int i) const { return mean(along_i_, i); }
  double of_row(int k) const { return mean(along_k_, k); }

 private:
  using Table = std::map<int, std::pair<double, int>>;
  double mean(const Table& table, int at) const;
  Table along_i_, along_k_;
  double overall_ = 1.0;
};

/// Whether the region is one rectangle without slits, bounded by one loop.
bool is_rectangle(const GridRegion& region);

/// Transfinite interpolation with blending by arc length: the coordinates (xi, eta) of a node are
/// where the line between the bottom's and the top's arc length fraction meets that between the
/// left's and the right's (Soni 1985). Reproduces any surface that is the sum of a function of u
/// and one of v. Requires is_rectangle. Linear in nodes.
void place_transfinite(PlacedRegion& placed);

/// Whether the region is a tube between two rims of constant k.
bool is_plain_tube(const PlacedRegion& placed);

/// On straight lines in (u,v) from rim to rim, at equal steps. Requires is_plain_tube and (u,v)
/// that close up around the tube (an annulus in the parameter plane).
void place_ruled(PlacedRegion& placed);

/// Each interior node is the mean of its four neighbours, weighted by the inverse of the mean
/// length of the boundary steps in that row or column; so the grading of the boundary goes through
/// the interior. The result is a discrete harmonic map, which may fold next to re-entrant corners.
/// One sparse factorisation (Cholesky).
void place_harmonic(PlacedRegion& placed);

}  // namespace sweepmesh
