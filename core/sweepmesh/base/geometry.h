// Points and small helpers shared by all stages. Lengths are in the unit of the CAD file (mm).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace sweepmesh {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

/// n x 3 coordinates, row-major as numpy keeps them: row i is node i.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// z component of the cross product of two plane vectors.
inline double cross2(const Point2& a, const Point2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace sweepmesh
