#include <algorithm>
#include <limits>

#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/volume/one_to_one.h"

namespace sweepmesh {
namespace {

/// Where a node of a cap lies in the background mesh: triangle of columns, weights, and distance
/// along the triangle's normal.
struct Spot {
  std::array<int, 3> triangle;
  Point3 weight;
  double offset = 0.0;
};

Point3 normal_of(const OneToOne& sweep, const Points& points, const std::array<int, 3>& t, int k) {
  const Point3 a = sweep.at(points, t[0], k);
  return (sweep.at(points, t[1], k) - a).cross(sweep.at(points, t[2], k) - a).normalized();
}

/// The rim in the plane of its area vector.
struct Plane {
  Point3 origin, u, v;
  Plane(const OneToOne& sweep, const Points& points, int k)
      : origin(sweep.at(points, sweep.rim.front(), k)) {
    const Point3 normal = sweep.rim_area(points, k).normalized();
    u = normal.unitOrthogonal();
    v = normal.cross(u);
  }
  Point2 operator()(const Point3& p) const { return {(p - origin).dot(u), (p - origin).dot(v)}; }
};

std::vector<std::array<int, 3>> background_mesh(const OneToOne& sweep, const Points& points,
                                                int k) {
  const Plane plane(sweep, points, k);
  std::vector<Point2> flat;
  for (const int c : sweep.rim) flat.push_back(plane(sweep.at(points, c, k)));
  std::vector<std::vector<int>> loops = sweep.loops();
  for (auto& loop : loops)
    for (int& c : loop)
      c = static_cast<int>(std::lower_bound(sweep.rim.begin(), sweep.rim.end(), c) -
                           sweep.rim.begin());
  std::vector<std::array<int, 3>> triangles = constrained_delaunay(flat, loops);
  for (auto& t : triangles)
    for (int& i : t) i = sweep.rim[i];
  return triangles;
}

Point3 weights_in(const Point2& p, const Point2& a, const Point2& b, const Point2& c) {
  const double area = cross2(b - a, c - a);
  const double wb = cross2(p - a, c - a) / area, wc = cross2(b - a, p - a) / area;
  return {1.0 - wb - wc, wb, wc};
}

/// The triangle of `triangles` in whose image at level k the point lies, or lies nearest to.
Spot locate(const OneToOne& sweep, const Points& points, const Plane& plane, int k,
            const std::vector<std::array<int, 3>>& triangles, const Point3& p) {
  Spot spot;
  double best = -std::numeric_limits<double>::infinity();
  const auto flat = [&](int column) { return plane(sweep.at(points, column, k)); };
  for (const auto& t : triangles) {
    const Point3 w = weights_in(plane(p), flat(t[0]), flat(t[1]), flat(t[2]));
    if (!(w.minCoeff() > best)) continue;
    best = w.minCoeff();
    spot.triangle = t;
    spot.weight = w;
  }
  Point3 foot = Point3::Zero();
  for (int i = 0; i < 3; ++i) foot += spot.weight[i] * sweep.at(points, spot.triangle[i], k);
  spot.offset = (p - foot).dot(normal_of(sweep, points, spot.triangle, k));
  return spot;
}

Point3 place_in(const OneToOne& sweep, const Points& points, const Spot& spot, double offset,
                int k) {
  Point3 p = offset * normal_of(sweep, points, spot.triangle, k);
  for (int i = 0; i < 3; ++i) p += spot.weight[i] * sweep.at(points, spot.triangle[i], k);
  return p;
}

}  // namespace

// The background mesh is made on the source (high) cap and carried to every layer. A node's weights
// come from the source; its offset goes linearly from that of the source to that of its image on
// the target.
void place_bm_sweep(const OneToOne& sweep, Points& points) {
  const auto triangles = background_mesh(sweep, points, sweep.k_high);
  const Plane plane(sweep, points, sweep.k_high);
  for (const int column : sweep.inner) {
    const Point3 high = sweep.at(points, column, sweep.k_high);
    const Point3 low = sweep.at(points, column, sweep.k_low);
    const Spot spot = locate(sweep, points, plane, sweep.k_high, triangles, high);
    const Point3 foot = place_in(sweep, points, spot, 0.0, sweep.k_low);
    const double low_offset =
        (low - foot).dot(normal_of(sweep, points, spot.triangle, sweep.k_low));
    for (int k = sweep.k_low + 1; k < sweep.k_high; ++k) {
      const double s = sweep.fraction[k - sweep.k_low];
      points.row(sweep.extrusion.node(column, k)) =
          place_in(sweep, points, spot, (1 - s) * low_offset + s * spot.offset, k);
    }
  }
}

}  // namespace sweepmesh
