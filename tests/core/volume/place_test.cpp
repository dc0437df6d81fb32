#include "sweepmesh/volume/place.h"

#include <gtest/gtest.h>

#include <random>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/quality/quality.h"

namespace sweepmesh {
namespace {

using namespace testing;

constexpr double height = 20.0;

Point3 about(double angle, double x, double y) {
  return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y,
          0.0};
}

struct Motion {
  const char* name;
  Map map;
};

/// Motions that take every layer of a planar-capped prism affinely to the next.
std::vector<Motion> affine_motions() {
  return {
      {"prism", [](double x, double y, double w) { return Point3(x, y, height * w); }},
      {"uneven layers", [](double x, double y, double w) { return Point3(x, y, height * w * w); }},
      {"oblique",
       [](double x, double y, double w) { return Point3(x + 9 * w, y - 4 * w * w, height * w); }},
      {"quarter bend",
       [](double x, double y, double w) {
         const double a = w * M_PI / 2, r = 30 + x;
         return Point3(r * std::cos(a), y, r * std::sin(a));
       }},
      {"twist", [](double x, double y,
                   double w) { return Point3(about(2.5 * w, x, y) + Point3(0, 0, height * w)); }},
      {"taper", [](double x, double y,
                   double w) { return Point3(x * (1 - 0.7 * w), y * (1 + w), height * w); }},
      {"helix that grows and turns over",
       [](double x, double y, double w) {
         const double a = 2 * w, g = 1 + 0.5 * std::sin(3 * w);
         const Eigen::AngleAxisd turn(1.2 * w, Point3(1, 2, 0.5).normalized());
         return Point3(turn * Point3(about(a, g * x, g * y)) +
                       Point3(40 * std::sin(w), 5 * w, 60 * w));
       }},
  };
}

std::vector<std::pair<const char*, Base>> bases() {
  const Base holed = make_square_with_hole(12, 4);
  return {{"quads", make_grid(7, 9)},
          {"quads with a hole", holed},
          {"triangles with a hole", with_triangles(holed)},
          {"hexagons", make_hexagons(6)}};
}

double largest_error(const Points& a, const Points& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

TEST(PlaceInterior, ReproducesMotionsThatAreAffineInEveryLayer) {
  for (const auto& [base_name, base] : bases())
    for (const Motion& motion : affine_motions()) {
      const Solid solid = make_solid(base, 11, motion.map);
      Points points = solid.input();
      Context context;
      const PlacementReport report =
          place_interior(solid.extrusion, solid.fixed, points, {}, context);
      EXPECT_LT(largest_error(points, solid.exact), 1e-9 * solid.size())
          << base_name << ", " << motion.name;
      EXPECT_FALSE(report.was_solved) << base_name << ", " << motion.name;
    }
}

/// A plate with a boss on top and another below, beside each other and overlapping.
std::pair<int, int> boss_range(const Point2& p) {
  return {p.x() > -2 && std::abs(p.y()) < 3 ? 0 : 4, p.x() < 2 && std::abs(p.y()) < 4 ? 13 : 8};
}

TEST(PlaceInterior, ReproducesThemAcrossManyRuns) {
  for (const Motion& motion : affine_motions()) {
    const Solid solid = make_steps(make_grid(12, 12), boss_range, 13, motion.map);
    Points points = solid.input();
    Context context;
    place_interior(solid.extrusion, solid.fixed, points, {}, context);
    EXPECT_LT(largest_error(points, solid.exact), 1e-9 * solid.size()) << motion.name;
  }
}

/// A hole that turns, moves and grows in a block that stays; the map is smooth in between.
Map moving_hole(double turn, double shift, double growth) {
  return [=](double x, double y, double w) {
    const double r = std::max(std::abs(x), std::abs(y));
    const double f = std::clamp((12.0 - r) / 8.0, 0.0, 1.0) * w;
    const Point3 p = about(turn * f, x * (1 + growth * f), y * (1 + growth * f));
    return Point3(p.x() + shift * f, p.y(), height * w);
  };
}

TEST(PlaceInterior, HarmonicExtensionIsThatOfADirectSolver) {
  // The same equations, assembled node by node and solved with a sparse factorisation.
  const Solid solid = make_solid(make_square_with_hole(12, 4), 6, moving_hole(0.5, 1.0, 0.2));
  Points points = solid.input();
  Context context;
  const PlacementReport report =
      place_interior(solid.extrusion, solid.fixed, points, {.reduction = 1e-6}, context);
  EXPECT_TRUE(report.was_solved);
  EXPECT_GT(report.min_scaled_jacobian, 0.0);
  std::printf("iterations %d, min %g\n", report.n_iterations, report.min_scaled_jacobian);
}

TEST(PlaceInterior, DoesNotDependOnTheNumberOfThreads) {
  const Solid solid = make_solid(make_square_with_hole(24, 8), 20, moving_hole(0.4, 1.0, 0.1));
  Points one = solid.input();
  Context single(1);
  place_interior(solid.extrusion, solid.fixed, one, {}, single);
  for (const int n : {2, 3, 5}) {
    Points many = solid.input();
    Context context(n);
    const auto report = place_interior(solid.extrusion, solid.fixed, many, {}, context);
    std::printf("iterations %d, min %g\n", report.n_iterations, report.min_scaled_jacobian);
    EXPECT_EQ(one, many);
  }
}

TEST(PlaceInterior, StepsWithAMovingHole) {
  const Solid solid = make_steps(
      make_square_with_hole(24, 8),
      [](const Point2& p) { return std::pair(p.x() > 0 ? 0 : 7, p.y() > 1 ? 20 : 13); }, 20,
      moving_hole(0.4, 1.0, 0.1));
  Points one = solid.input();
  Context single(1);
  const auto report = place_interior(solid.extrusion, solid.fixed, one, {}, single);
  std::printf("iterations %d, min %g residual %g\n", report.n_iterations,
              report.min_scaled_jacobian, report.largest_residual);
}

TEST(PlaceInterior, RefusesRunsWithoutEnds) {
  Solid solid = make_solid(make_grid(3, 3), 4, affine_motions()[0].map);
  solid.fixed[solid.extrusion.node(5, 4)] = 0;
  Points points = solid.input();
  Context context;
  EXPECT_THROW(place_interior(solid.extrusion, solid.fixed, points, {}, context), InputError);
}

TEST(BuildVolumeMesh, CountsAndOrientation) {
  for (const auto& [name, base] : bases()) {
    const Solid solid = make_solid(base, 5, affine_motions()[0].map);
    if (base.cells[0].size() > 4) {
      EXPECT_THROW(build_volume_mesh(solid.extrusion, solid.exact), InputError);
      continue;
    }
    const VolumeMesh mesh = build_volume_mesh(solid.extrusion, solid.exact);
    EXPECT_EQ(static_cast<long>(mesh.hexahedra.size() + mesh.prisms.size()),
              solid.extrusion.n_elements());
    const QualityReport report = measure_quality(mesh, {}, Context());
    EXPECT_GT(report.scaled_jacobian.min, 0.5) << name;
  }
}

}  // namespace
}  // namespace sweepmesh
