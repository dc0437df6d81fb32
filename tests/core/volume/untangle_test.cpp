#include "sweepmesh/volume/untangle.h"

#include <gtest/gtest.h>

#include <random>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/place.h"

namespace sweepmesh {
namespace {

using namespace testing;

TEST(FoldoverEnergy, GradientIsThatOfDifferences) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  UnfoldProblem problem;
  problem.n_free = 6;
  Points x(8, 3);
  for (long i = 0; i < x.size(); ++i) x.data()[i] = normal(random);
  for (int c = 0; c < 12; ++c) {
    CornerTet corner;
    std::array<int, 8> order = {0, 1, 2, 3, 4, 5, 6, 7};
    std::shuffle(order.begin(), order.end(), random);
    std::copy(order.begin(), order.begin() + 4, corner.node.begin());
    for (long i = 0; i < 9; ++i) corner.ideal.data()[i] = normal(random);
    problem.corners.push_back(corner);
  }
  for (const double eps : {1.0, 0.3}) {
    Points gradient, up = x, down = x;
    foldover_energy(problem, x, eps, 0.1, &gradient);
    const double h = 1e-6;
    for (int i = 0; i < problem.n_free; ++i)
      for (int d = 0; d < 3; ++d) {
        up(i, d) += h;
        down(i, d) -= h;
        const double slope = (foldover_energy(problem, up, eps, 0.1, nullptr) -
                              foldover_energy(problem, down, eps, 0.1, nullptr)) / (2 * h);
        EXPECT_NEAR(gradient(i, d), slope, 1e-5 * (1 + std::abs(slope)));
        up(i, d) = down(i, d) = x(i, d);
      }
  }
}

TEST(FoldoverEnergy, IdealElementHasTheLeastEnergy) {
  UnfoldProblem problem;
  problem.n_free = 0;
  problem.corners.push_back({{0, 1, 2, 3}, Eigen::Matrix3d::Identity()});
  Points x(4, 3);
  x << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  EXPECT_NEAR(foldover_energy(problem, x, 1e-9, 0.5, nullptr), 1.5, 1e-12);
  x(3, 2) = 1.2;
  EXPECT_GT(foldover_energy(problem, x, 1e-9, 0.5, nullptr), 1.5);
}

TEST(Untangle, UnfoldsScrambledInteriors) {
  const Base holed = make_square_with_hole(8, 2);
  for (const Base& base : {make_grid(6, 6), holed, with_triangles(holed), make_hexagons(4)}) {
    const Solid solid = make_solid(base, 6, [](double x, double y, double w) { return Point3(x, y, 5 * w); });
    const BaseMetric metric = make_base_metric(solid.extrusion, solid.fixed, solid.exact);
    std::mt19937 random(2);
    std::normal_distribution<double> normal(0.0, 1.0);
    Points points = solid.exact;
    for (long n = 0; n < points.rows(); ++n)
      if (!solid.fixed[n])
        for (int d = 0; d < 3; ++d) points(n, d) += normal(random);
    ThreadTeam team;
    const ElementCheck before = check_elements(solid.extrusion, points, 0.0, team);
    EXPECT_GT(before.bad.size(), 20u);
    const UntangleReport report =
        untangle(solid.extrusion, metric, solid.fixed, points, {}, before.bad, team, Context());
    EXPECT_TRUE(report.remaining.empty());
    EXPECT_GT(measure_quality(solid.extrusion, points, {}, Context()).scaled_jacobian.min, 0.5);
    std::printf("%ld %d %g\n", before.bad.size(), report.n_attempts, measure_quality(solid.extrusion, points, {}, Context()).scaled_jacobian.min);
  }
}

}  // namespace
}  // namespace sweepmesh
