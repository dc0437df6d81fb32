#include "sweepmesh/volume/cap_transition.h"

#include <gtest/gtest.h>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/node_ascent.h"
#include "sweepmesh/volume/place.h"
#include "sweepmesh/volume/residual.h"

namespace sweepmesh::testing {
namespace {

struct Placed {
  bool has_changed = false;
  Points points;
  ElementCheck before, after;
};

/// Predictions, then the transitions alone.
Placed pass(const Solid& solid, const TransitionOptions& options, int n_threads) {
  ThreadTeam team(n_threads);
  Placed out;
  out.points = solid.input();
  const BaseMetric metric = make_base_metric(solid.extrusion, solid.fixed, out.points, team);
  const LayerMotion motion =
      make_layer_motion(solid.extrusion, solid.fixed, out.points, metric, team);
  set_predictions(solid.extrusion, motion, solid.fixed, out.points, team);
  out.before = check_elements(solid.extrusion, out.points, 0.0, team);
  out.has_changed = choose_transitions(solid.extrusion, solid.fixed, metric, motion, options,
                                       out.points, team, Context());
  out.after = check_elements(solid.extrusion, out.points, 0.0, team);
  return out;
}

/// A prism, its top (or, upside down, its bottom) a dome with a flat rim.
Solid dome(const Base& base, double height, bool is_above) {
  return make_solid(base, 8, [=](double x, double y, double w) {
    const double rise = height * (1 - x * x / 16) * (1 - y * y / 16);
    return Point3(x, y, 8 * w + (is_above ? w * rise : -(1 - w) * rise));
  });
}

const TransitionOptions exact = {.negligible = 1e-9};

TEST(CapTransition, KeepsTheBetterCapThroughOneHalf) {
  for (const Base& base : {make_grid(8, 8), with_triangles(make_grid(8, 8))})
    for (const bool is_above : {true, false}) {
      const Placed placed = pass(dome(base, 4.0, is_above), exact, 0);
      EXPECT_TRUE(placed.has_changed);
      EXPECT_GT(placed.after.mean_scaled_jacobian, placed.before.mean_scaled_jacobian + 0.01);
      EXPECT_GT(placed.after.min_scaled_jacobian, placed.before.min_scaled_jacobian - 0.01);
      // The half next to the flat cap is flat.
      const Solid solid = dome(base, 4.0, is_above);
      for (int c = 0; c < solid.extrusion.n_columns(); ++c) {
        const int k = is_above ? 3 : 5;
        EXPECT_NEAR(placed.points(solid.extrusion.node(c, k), 2), k, 1e-5);
      }
    }
}

TEST(CapTransition, LeavesCapsAloneThatMatch) {
  const auto turning = [](double x, double y, double w) {
    return Point3(std::cos(w) * x - std::sin(w) * y, std::sin(w) * x + std::cos(w) * y,
                  5 * w + 0.05 * x * y);
  };
  const Placed placed = pass(make_solid(make_square_with_hole(8, 2), 6, turning), exact, 0);
  EXPECT_FALSE(placed.has_changed);
  EXPECT_EQ(placed.after.mean_scaled_jacobian, placed.before.mean_scaled_jacobian);
}

TEST(CapTransition, DoesNotDependOnTheNumberOfThreads) {
  const Solid solid = dome(make_grid(8, 8), 4.0, true);
  EXPECT_EQ(pass(solid, exact, 1).points, pass(solid, exact, 3).points);
}

TEST(NodeAscent, RaisesTheMeanAndNeverLowersTheLeast) {
  for (const Base& base : {make_grid(6, 6), with_triangles(make_grid(6, 6)), make_hexagons(4)}) {
    const Solid solid = make_solid(base, 6, [](double x, double y, double w) {
      return Point3(x + 0.3 * std::sin(3 * y + 5 * w), y + 0.3 * std::sin(2 * x + 7 * w), 6 * w);
    });
    std::vector<Points> results;
    for (const int n_threads : {1, 3}) {
      ThreadTeam team(n_threads);
      Points points = solid.exact;
      const ElementCheck before = check_elements(solid.extrusion, points, 0.0, team);
      ascend_nodes(solid.extrusion, solid.fixed, {}, points, team, Context());
      const ElementCheck after = check_elements(solid.extrusion, points, 0.0, team);
      EXPECT_GT(after.mean_scaled_jacobian, before.mean_scaled_jacobian + 0.01);
      EXPECT_GE(after.min_scaled_jacobian, before.min_scaled_jacobian);
      for (long n = 0; n < points.rows(); ++n)
        EXPECT_TRUE(!solid.fixed[n] || points.row(n) == solid.exact.row(n));
      results.push_back(points);
    }
    EXPECT_EQ(results[0], results[1]);
  }
}

TEST(NodeAscent, HearsACancel) {
  const Solid solid =
      make_solid(make_grid(4, 4), 4, [](double x, double y, double w) { return Point3(x, y, w); });
  Context context;
  context.cancel();
  ThreadTeam team;
  Points points = solid.exact;
  EXPECT_THROW(ascend_nodes(solid.extrusion, solid.fixed, {}, points, team, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh::testing
