// The square block of 24 x 24 x 20 quads with a square hole of 8 x 8 that twists, moves or grows:
// how many elements each stage leaves inverted. Cap and sides are planar; the target cap's interior
// starts from its own harmonic map and slides in its plane when elements are untangled.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "../core/volume/solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/volume/place.h"

namespace {

using namespace sweepmesh;
using namespace sweepmesh::testing;

constexpr int n_layers = 20;

/// Sets the free columns of a layer to the harmonic map of its boundary (uniform weights,
/// Gauss-Seidel).
void map_cap(const Base& base, const std::vector<char>& is_boundary, int k, Solid& solid) {
  std::vector<std::vector<int>> neighbours(base.points.size());
  for (const auto& cell : base.cells)
    for (std::size_t i = 0; i < cell.size(); ++i) {
      neighbours[cell[i]].push_back(cell[(i + 1) % cell.size()]);
      neighbours[cell[(i + 1) % cell.size()]].push_back(cell[i]);
    }
  for (int sweep = 0; sweep < 3000; ++sweep)
    for (std::size_t c = 0; c < base.points.size(); ++c) {
      if (is_boundary[c]) continue;
      Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
      for (const int n : neighbours[c])
        mean +=
            solid.exact.row(solid.extrusion.node(n, k)) / static_cast<double>(neighbours[c].size());
      solid.exact.row(solid.extrusion.node(static_cast<int>(c), k)) = mean;
    }
}

std::vector<SlidingNode> inside_cap(const std::vector<char>& is_boundary, const Solid& solid) {
  std::vector<SlidingNode> sliding;
  for (std::size_t c = 0; c < is_boundary.size(); ++c)
    if (!is_boundary[c])
      sliding.push_back({solid.extrusion.node(static_cast<int>(c), n_layers), Point3(0, 0, 1)});
  return sliding;
}

void run(const char* name, const std::function<Point2(Point2)>& hole) {
  const Base base = make_square_with_hole(24, 8);
  const std::vector<char> is_boundary = base.boundary();
  Solid solid = make_solid(base, n_layers, [&](double x, double y, double w) {
    Point2 p(x, y);
    if (std::max(std::abs(x), std::abs(y)) <= 4.0) p += w * (hole(p) - p);
    return Point3(p.x(), p.y(), 20 * w);
  });
  map_cap(base, is_boundary, n_layers, solid);
  PlacementOptions harmonic, whole;
  harmonic.max_attempts = 0;
  whole.sliding = inside_cap(is_boundary, solid);
  for (const auto& [stage, options] :
       {std::pair("harmonic", harmonic), std::pair("untangled", whole)}) {
    Points points = solid.input();
    const auto start = std::chrono::steady_clock::now();
    try {
      Context context;
      place_interior(solid.extrusion, solid.fixed, points, options, context);
    } catch (const InvalidMeshError& e) {
      std::printf("%s\n", e.what());
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const QualityReport q = measure_quality(solid.extrusion, points, {}, Context());
    std::printf("%-22s %-10s %8ld inverted, scaled Jacobian min %7.3f mean %6.3f, %6.2f s\n", name,
                stage, q.n_inverted, q.scaled_jacobian.min, q.scaled_jacobian.mean, seconds);
  }
}

}  // namespace

int main() {
  const Eigen::Rotation2Dd turn(M_PI / 4);
  run("twists 45 degrees", [&](Point2 p) { return Point2(turn * p); });
  run("moves by 5", [](Point2 p) { return Point2(p.x() + 5.0, p.y()); });
  run("grows 1.7 times", [](Point2 p) { return Point2(1.7 * p); });
}
