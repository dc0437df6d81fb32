#include "sweepmesh/surface/linking_quality.h"

#include <algorithm>

namespace sweepmesh {

double scaled_jacobian(const std::array<Point3, 4>& corner, const std::array<Point3, 4>& normal) {
  const Point3 mean = (corner[2] - corner[0]).cross(corner[3] - corner[1]).normalized();
  double least = 1.0;
  for (int c = 0; c < 4; ++c) {
    const Point3 a = corner[(c + 1) % 4] - corner[c], b = corner[(c + 3) % 4] - corner[c];
    const double size = a.norm() * b.norm();
    const Point3& up = normal[c].isZero() ? mean : normal[c];
    least = std::min(least, size > 0.0 ? a.cross(b).dot(up) / size : 0.0);
  }
  return least;
}

}  // namespace sweepmesh
