#include "sweepmesh/scheme/wall_sections.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sweepmesh/base/element_quality.h"

namespace sweepmesh {
namespace {

const std::vector<Point3>& middle(const WallRing& ring) {
  return ring.layers[ring.layers.size() / 2];
}

/// Twice the flux of the ring's steps to the next layer through its area: positive where it runs
/// counterclockwise seen from above.
double rise(const WallRing& ring) {
  const std::size_t m = ring.layers.size() / 2;
  const std::size_t next = std::min(m + 1, ring.layers.size() - 1), last = next - 1;
  const Point3 step = centre_of(ring.layers[next]) - centre_of(ring.layers[last]);
  return area_of(ring.layers[last]).dot(step);
}

/// Whether a polygon winds around the line through `p` along `normal`.
bool contains(const std::vector<Point3>& ring, const Point3& normal, const Point3& p) {
  double angle = 0.0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Point3 along = normal.normalized();
    const auto flat = [&](const Point3& q) -> Point3 { return q - p - along * along.dot(q - p); };
    const Point3 a = flat(ring[j]), b = flat(ring[(j + 1) % ring.size()]);
    angle += std::atan2(a.cross(b).dot(along), a.dot(b));
  }
  return std::abs(angle) > std::numbers::pi;
}

}  // namespace

Point3 centre_of(const std::vector<Point3>& ring) {
  Point3 sum = Point3::Zero();
  for (const Point3& p : ring) sum += p;
  return sum / static_cast<double>(ring.size());
}

Point3 area_of(const std::vector<Point3>& ring) {
  return area_vector(ring.data(), static_cast<int>(ring.size()));
}

std::vector<WallSection> joined_to_sections(int k_low, int k_high, std::vector<WallRing> rings) {
  std::vector<WallSection> out;
  std::vector<WallRing> holes;
  for (WallRing& ring : rings)
    if (rise(ring) > 0.0)
      out.push_back({k_low, k_high, std::move(ring), {}});
    else
      holes.push_back(std::move(ring));
  for (WallRing& hole : holes) {
    WallSection* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (WallSection& section : out) {
      const auto& ring = middle(section.outer);
      const Point3 area = area_of(ring);
      if (area.norm() >= least || !contains(ring, area, middle(hole).front())) continue;
      least = area.norm();
      best = &section;
    }
    if (best) best->holes.push_back(std::move(hole));
  }
  return out;
}

}  // namespace sweepmesh
