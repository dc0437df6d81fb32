#include "sweepmesh/volume/raise_least.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "solids.h"
#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/place.h"

namespace sweepmesh {
namespace {

using namespace testing;

Points scrambled(const Solid& solid, double amount) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  Points points = solid.exact;
  for (long n = 0; n < points.rows(); ++n)
    if (!solid.fixed[n])
      for (int d = 0; d < 3; ++d) points(n, d) += uniform(random);
  return points;
}

Point3 upright(double x, double y, double w) {
  return {x, y, 5 * w};
}

std::vector<Solid> right_prisms() {
  return {make_solid(make_square_with_hole(10, 2), 5, upright),
          make_solid(with_triangles(make_grid(6, 6)), 5, upright),
          make_solid(make_hexagons(5), 5, upright)};
}

/// Raises what is below `threshold`, round after round; the least value then.
double raised(const Solid& solid, double threshold, Points& points, int n_threads = 0) {
  constexpr int rounds = 10;
  const Points start = points;
  RaiseOptions options;
  options.lengths_of = &start;
  ThreadTeam team(n_threads);
  double least = check_elements(solid.extrusion, points, 0.0, team).min_scaled_jacobian;
  for (int round = 0; round < rounds; ++round) {
    const ElementCheck check = check_elements(solid.extrusion, points, threshold, team);
    raise_least(solid.extrusion, solid.fixed, points, options, check.bad, team, Context());
    const double now = check_elements(solid.extrusion, points, 0.0, team).min_scaled_jacobian;
    EXPECT_GE(now, least);
    least = now;
  }
  return least;
}

TEST(SoftLeast, IsBelowTheLeastAndTendsToIt) {
  const std::vector<double> values = {0.3, 0.31, 0.9, -0.2, -0.1};
  double last = -1e300;
  for (const double sharpness : {1.0, 10.0, 100.0, 1000.0}) {
    std::vector<double> weights = values;
    const double soft = soft_least(weights, sharpness);
    EXPECT_LE(soft, -0.2);
    EXPECT_GT(soft, last);
    last = soft;
    double sum = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      sum += weights[i], mean += weights[i] * values[i];
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LE(mean, 0.24 * 1.01);
  }
  EXPECT_NEAR(last, -0.2, 1e-6);
}

/// The highest point under three planes and a bowl: where they meet, no gradient is zero.
TEST(SoftLeast, FindsWhereValuesMeet) {
  const Eigen::Vector2d best(0.3, -0.2);
  const auto values = [&](const Eigen::VectorXd& x) {
    const double u = x[0] - best[0], v = x[1] - best[1];
    return std::vector<double>{u + v, -u + v, -2 * v, 1 - u * u};
  };
  const SoftLeast value = [&](const Eigen::VectorXd& x, double sharpness, Eigen::VectorXd* g) {
    std::vector<double> w = values(x);
    const double soft = soft_least(w, sharpness);
    if (g) *g = Eigen::Vector2d(w[0] - w[1] - 2 * (x[0] - best[0]) * w[3], w[0] + w[1] - 2 * w[2]);
    return soft;
  };
  Eigen::VectorXd x = Eigen::Vector2d(2.0, 1.5);
  Context context;
  LeastAscentOptions options;
  options.sharpness = {10.0, 100.0, 1000.0};
  EXPECT_GT(ascend_least(value, options, x, context, "place"), 5);
  EXPECT_LT((x - best).norm(), 0.01);
  context.cancel();
  EXPECT_THROW(ascend_least(value, options, x, context, "place"), Cancelled);
}

TEST(RaiseLeast, ScrambledPrismsBecomeRightAgain) {
  for (const Solid& solid : right_prisms()) {
    Points points = scrambled(solid, 0.3);
    ThreadTeam team;
    EXPECT_LT(check_elements(solid.extrusion, points, 0.0, team).min_scaled_jacobian, 0.6);
    EXPECT_GT(raised(solid, 0.95, points), 0.8);
    for (long n = 0; n < points.rows(); ++n)
      if (solid.fixed[n]) EXPECT_EQ(Point3(points.row(n)), Point3(solid.exact.row(n)));
  }
}

double shortest_edge(const Extrusion& x, const Points& points) {
  double shortest = std::numeric_limits<double>::infinity();
  const auto add = [&](long a, long b) {
    shortest = std::min(shortest, (points.row(a) - points.row(b)).norm());
  };
  for (int c = 0; c < x.n_cells(); ++c) {
    const int n = x.cell_size(c);
    const int* columns = x.cell_columns.data() + x.cell_offset[c];
    for (int k = x.cell_k_low[c]; k <= x.cell_k_high[c]; ++k)
      for (int i = 0; i < n; ++i) {
        const long node = x.node(columns[i], k);
        add(node, x.node(columns[(i + 1) % n], k));
        if (k > x.cell_k_low[c]) add(node, node - 1);
      }
  }
  return shortest;
}

/// Scaled Jacobians alone would let an element shrink to nothing, with good angles all the while.
TEST(RaiseLeast, EdgesKeepAFairLength) {
  for (const double amount : {0.3, 0.5})
    for (const Base& mesh : {make_square_with_hole(10, 2), make_hexagons(5), make_grid(8, 8)}) {
      const Solid solid = make_solid(mesh, 5, [&](double x, double y, double w) {
        return Point3(x + 4 * w * w, y + std::sin(x) * w, 5 * w);
      });
      Points points = scrambled(solid, amount);
      raised(solid, 0.95, points);
      EXPECT_GT(shortest_edge(solid.extrusion, points),
                0.15 * shortest_edge(solid.extrusion, solid.exact))
          << amount;
    }
}

TEST(RaiseLeast, HasTheSameBitsForAnyNumberOfThreads) {
  for (const Solid& solid : right_prisms()) {
    Points one = scrambled(solid, 0.35), four = one;
    raised(solid, 0.5, one, 1);
    raised(solid, 0.5, four, 4);
    EXPECT_EQ(one, four);
  }
}

TEST(RaiseLeast, SlidingNodesStayInTheirPlane) {
  const Solid solid = make_solid(make_grid(8, 8), 4, upright);
  RaiseOptions options;
  for (int c = 0; c < solid.extrusion.n_columns(); ++c) {
    const long node = solid.extrusion.node(c, 4);
    if (!solid.fixed[node - 1]) options.sliding.push_back({node, Point3(0, 0, 1)});
  }
  Points points = solid.exact;
  const long moved = options.sliding[24].node;
  points.row(moved) += Eigen::RowVector3d(0.4, 0.3, 0.0);
  ThreadTeam team;
  const ElementCheck before = check_elements(solid.extrusion, points, 0.9, team);
  raise_least(solid.extrusion, solid.fixed, points, options, before.bad, team, Context());
  EXPECT_GT(check_elements(solid.extrusion, points, 0.0, team).min_scaled_jacobian, 0.95);
  for (const SlidingNode& s : options.sliding) EXPECT_NEAR(points(s.node, 2), 5.0, 1e-12);
}

TEST(RaiseLeast, NodesOfCurvedFacesStayOnThem) {
  constexpr double radius = 8.0;
  const Solid solid = make_solid(make_grid(8, 4), 4, [](double x, double y, double w) {
    const double r = radius + y - 2.0, angle = -0.12 * x;
    return Point3(r * std::cos(angle), r * std::sin(angle), 4 * w);
  });
  RaiseOptions options;
  options.curved.onto = [=](long, const Point3& p) -> CurvedNodes::Place {
    const Point3 normal = Point3(p.x(), p.y(), 0.0).normalized();
    return {radius * normal + Point3(0, 0, p.z()), normal};
  };
  for (long n = 0; n < solid.exact.rows(); ++n) {
    const Point3 p = solid.exact.row(n);
    if (std::abs(p.head<2>().norm() - radius) < 1e-9 && std::abs(std::atan2(p.y(), p.x())) < 0.4 &&
        p.z() > 0.5 && p.z() < 3.5)
      options.curved.nodes.push_back(n);
  }
  ASSERT_EQ(options.curved.nodes.size(), 21u);
  Points points = solid.exact;
  const long moved = options.curved.nodes[10];
  const Point3 pushed = Point3(points.row(moved)) + Point3(0.0, 0.5, 0.4);
  points.row(moved) = options.curved.onto(moved, pushed).point;
  ThreadTeam team;
  const ElementCheck before = check_elements(solid.extrusion, points, 0.9, team);
  raise_least(solid.extrusion, solid.fixed, points, options, before.bad, team, Context());
  const ElementCheck after = check_elements(solid.extrusion, points, 0.9, team);
  EXPECT_LT(before.min_scaled_jacobian, 0.8);
  EXPECT_GT(after.min_scaled_jacobian, 0.9);
  for (const long node : options.curved.nodes)
    EXPECT_NEAR(points.row(node).head<2>().norm(), radius, 1e-12);
}

/// Angles alone would let nodes fall into one.
TEST(RaiseLeast, EdgesKeepTwoFifthsOfTheirLength) {
  for (const Solid& solid : right_prisms()) {
    const Points start = scrambled(solid, 0.35);
    Points points = start;
    ThreadTeam team;
    RaiseOptions options;
    options.rings = 2;
    options.lengths_of = &start;
    for (int round = 0; round < 5; ++round)
      raise_least(solid.extrusion, solid.fixed, points, options,
                  check_elements(solid.extrusion, points, 0.9, team).bad, team, Context());
    const Extrusion& x = solid.extrusion;
    for (int c = 0; c < x.n_columns(); ++c)
      for (int k = x.k_low[c]; k < x.k_high[c]; ++k) {
        const long a = x.node(c, k);
        EXPECT_GT((points.row(a + 1) - points.row(a)).norm(),
                  0.4 * (start.row(a + 1) - start.row(a)).norm());
      }
  }
}

double least_bound(const Solid& solid, const Points& points) {
  const ElementIndex index(solid.extrusion);
  double bound = PlacementOptions{}.improve.lift_below;
  for (long e = 0; e < solid.extrusion.n_elements(); ++e)
    bound =
        std::min(bound, bound_by_boundary(solid.extrusion, solid.fixed, points, index.element(e)));
  return bound;
}

/// A block whose sides wind, so that inner nodes and not the caps make the worst elements.
Solid winding(double amount) {
  return make_solid(make_square_with_hole(12, 4), 16, [=](double x, double y, double w) {
    const double r = std::max(std::abs(x), std::abs(y));
    const double turn = amount * std::sin(2 * M_PI * w) * std::clamp((6.0 - r) / 4.0, 0.0, 1.0);
    return Point3(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y,
                  16 * w);
  });
}

TEST(PlaceInterior, LeastValueComesNearWhatTheBoundaryAllows) {
  for (const double amount : {0.5, 0.6, 0.7}) {
    const Solid solid = winding(amount);
    Points points = solid.input();
    PlacementOptions options;
    Context context;
    const double least =
        place_interior(solid.extrusion, solid.fixed, points, options, context).min_scaled_jacobian;
    points = solid.input();
    options.improve.up_to = options.improve.lift_below = 0.0;
    const double without =
        place_interior(solid.extrusion, solid.fixed, points, options, context).min_scaled_jacobian;
    std::printf("%g: %.3f without, %.3f with, bound %.3f\n", amount, without, least,
                least_bound(solid, points));
    EXPECT_GT(least, without + 0.2) << amount;
    EXPECT_GT(least, least_bound(solid, points) - 0.01) << amount;
  }
}

}  // namespace
}  // namespace sweepmesh
