// Which of many points lies where a given one is.
#pragma once

#include <algorithm>
#include <vector>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Finds points within a distance. Building costs n log n, asking log n: points are sorted along a
/// direction that no regular grid is perpendicular to.
class PointFinder {
 public:
  PointFinder(const std::vector<Point3>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i)
      sorted_.push_back({along(points[i]), static_cast<int>(i)});
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Indices of all points within the tolerance of `p`.
  std::vector<int> near(const Point3& p) const {
    std::vector<int> out;
    const double at = along(p);
    auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(at - tolerance_, -1));
    for (; it != sorted_.end() && it->first <= at + tolerance_; ++it)
      if ((points_[it->second] - p).norm() <= tolerance_) out.push_back(it->second);
    return out;
  }

  /// The nearest of them, -1 where there is none.
  int at(const Point3& p) const {
    int best = -1;
    for (const int i : near(p))
      if (best < 0 || (points_[i] - p).norm() < (points_[best] - p).norm()) best = i;
    return best;
  }

 private:
  static double along(const Point3& p) {
    return p.dot(Point3(0.4142135623, 0.7320508075, 0.5412308167).normalized());
  }

  std::vector<Point3> points_;
  double tolerance_;
  std::vector<std::pair<double, int>> sorted_;
};

}  // namespace sweepmesh
