#include "sweepmesh/volume/placement_method.h"

#include <gtest/gtest.h>

#include <set>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/volume/place.h"

namespace sweepmesh {
namespace {

using namespace testing;

Points placed(const Solid& solid, PlacementMethod method, int n_threads = 0) {
  PlacementOptions options;
  options.method = method;
  Points points = solid.input();
  Context context(n_threads);
  place_interior(solid.extrusion, solid.fixed, points, options, context);
  return points;
}

double largest_error(const Solid& solid, PlacementMethod method) {
  const Points points = placed(solid, method);
  EXPECT_TRUE(points.allFinite()) << name_of(method);
  return (points - solid.exact).rowwise().norm().maxCoeff();
}

/// Cells of the grid, or the accuracy of its relaxation: what the grid method may be wrong by.
double tolerance(const Solid& solid, PlacementMethod method) {
  return method == PlacementMethod::harmonic_grid ? solid.size() / 64 : 1e-9 * solid.size();
}

Point3 rotated(const Point3& p) {
  return Eigen::AngleAxisd(0.8, Point3(1, 2, -1).normalized()) * p + Point3(3, -2, 7);
}

TEST(PlacementMethods, EachReproducesATranslatedPrism) {
  for (const Base& base : {make_square_with_hole(8, 2), with_triangles(make_grid(5, 6))})
    for (const PlacementMethod method : all_placement_methods()) {
      const Solid solid = make_solid(base, 5, [](double x, double y, double w) {
        return rotated({x, y, 6 * w});
      });
      EXPECT_LT(largest_error(solid, method), tolerance(solid, method)) << name_of(method);
    }
}

TEST(PlacementMethods, LayerWiseOnesReproduceAffineLayers) {
  using enum PlacementMethod;
  const auto twist = [](double x, double y, double w) {
    const double a = 1.5 * w, g = 1 + 0.4 * w;
    return Point3(g * (std::cos(a) * x - std::sin(a) * y), g * (std::sin(a) * x + std::cos(a) * y),
                  9 * w);
  };
  const Solid solid = make_solid(make_square_with_hole(8, 2), 6, twist);
  for (const PlacementMethod method : {layer_affine, knupp_affine, least_squares_f, least_squares_g,
                                       least_squares_h, bm_sweep, boundary_error})
    EXPECT_LT(largest_error(solid, method), 1e-9 * solid.size()) << name_of(method);
}

TEST(PlacementMethods, CageBasedOnesReproduceWhatTheirCoordinatesDo) {
  using enum PlacementMethod;
  // An affine image of the prism: coordinates with linear precision reproduce it, Green's only
  // conformal ones.
  const Solid sheared = make_solid(
      make_square_with_hole(8, 2), 4,
      [](double x, double y, double w) { return Point3(1.3 * x + 0.2 * y, y - 0.3 * x, 6 * w); });
  Solid oblique = sheared;
  for (long n = 0; n < oblique.exact.rows(); ++n) oblique.exact(n, 0) += 0.4 * oblique.exact(n, 2);
  for (const PlacementMethod method : {mean_value, triharmonic_rbf})
    EXPECT_LT(largest_error(oblique, method), 1e-8 * oblique.size()) << name_of(method);
  EXPECT_LT(largest_error(oblique, harmonic_grid), oblique.size() / 32);
  EXPECT_GT(largest_error(oblique, green), 1e-3 * oblique.size());
}

/// A dome over a flat rim above, flat below: thesis figure 2.1.
Solid dome() {
  return make_solid(make_grid(8, 8), 4, [](double x, double y, double w) {
    return Point3(x, y, 8 * w + 2.0 * w * (1 - x * x / 16) * (1 - y * y / 16));
  });
}

TEST(PlacementMethods, FunctionalFFlattensADomeAndHDoesNot) {
  using enum PlacementMethod;
  const Solid solid = dome();
  const int middle = 40;  // the column in the middle of 9 x 9
  const auto bulge = [&](PlacementMethod method, int k) {
    return placed(solid, method)(solid.extrusion.node(middle, k), 2) -
           solid.exact(solid.extrusion.node(0, k), 2);
  };
  for (const int k : {1, 2, 3}) {
    EXPECT_NEAR(bulge(least_squares_f, k), 0.0, 1e-9);
    for (const PlacementMethod method : {least_squares_h, boundary_error, bm_sweep})
      EXPECT_NEAR(bulge(method, k), 0.5 * k, 1e-6) << name_of(method);
  }
  EXPECT_GT(bulge(harmonic_residual, 3), 0.5);
}

/// A hole that shifts and turns half way up and is back at the top.
Solid wandering_hole(double shift, double turn) {
  return make_solid(make_square_with_hole(16, 4), 12, [=](double x, double y, double w) {
    const double f =
        std::clamp((8.0 - std::max(std::abs(x), std::abs(y))) / 6.0, 0.0, 1.0) * std::sin(M_PI * w);
    const double a = turn * f;
    return Point3(std::cos(a) * x - std::sin(a) * y + shift * f, std::sin(a) * x + std::cos(a) * y,
                  16 * w);
  });
}

TEST(PlacementMethods, OlderOnesFoldWhereAHoleWandersAndOursDoesNot) {
  using enum PlacementMethod;
  const auto folds = [](const Solid& solid, PlacementMethod method) {
    PlacementOptions options;
    options.method = method;
    Points points = solid.input();
    Context context;
    return !place_interior(solid.extrusion, solid.fixed, points, options, context).inverted.empty();
  };
  const Solid shifted = wandering_hole(4.0, 0.0), turned = wandering_hole(0.0, 1.2);
  EXPECT_FALSE(folds(shifted, harmonic_residual));
  EXPECT_FALSE(folds(turned, harmonic_residual));
  for (const PlacementMethod method :
       {layer_affine, knupp_affine, least_squares_f, least_squares_h})
    EXPECT_TRUE(folds(shifted, method)) << name_of(method);
  for (const PlacementMethod method : {layer_affine, knupp_affine, least_squares_h, bm_sweep})
    EXPECT_TRUE(folds(turned, method)) << name_of(method);
}

TEST(PlacementMethods, DoNotDependOnTheNumberOfThreads) {
  const Solid solid = make_solid(make_grid(5, 4), 3, [](double x, double y, double w) {
    return Point3(x * (1 + w * w), y + std::sin(3 * w), 4 * w + 0.1 * x * x * w);
  });
  for (const PlacementMethod method : all_placement_methods())
    EXPECT_EQ(placed(solid, method, 1), placed(solid, method, 3)) << name_of(method);
}

TEST(PlacementMethods, MostServeManyToOneSweepsToo) {
  const Map oblique = [](double x, double y, double w) {
    return Point3(1.2 * x + 0.3 * y + w, y, 9 * w);
  };
  const auto from_one_level = [](const Point2& p) { return std::pair(0, p.x() > 0 ? 9 : 4); };
  const auto to_one_level = [](const Point2& p) { return std::pair(p.x() > 0 ? 0 : 5, 9); };
  const Solid up = make_steps(make_grid(6, 6), from_one_level, 9, oblique);
  const Solid down = make_steps(make_grid(6, 6), to_one_level, 9, oblique);
  using enum PlacementMethod;
  for (const Solid& solid : {up, down}) {
    for (const PlacementMethod method : {layer_affine, knupp_affine, least_squares_f,
                                         least_squares_h, mean_value, triharmonic_rbf})
      EXPECT_LT(largest_error(solid, method), 1e-8 * solid.size()) << name_of(method);
    for (const PlacementMethod method : {green, harmonic_grid})
      EXPECT_LT(largest_error(solid, method), 0.1 * solid.size()) << name_of(method);
    for (const PlacementMethod method : {bm_sweep, boundary_error})
      EXPECT_THROW(placed(solid, method), InputError) << name_of(method);
  }
}

TEST(PlacementMethods, RefuseWhatTheyAreNotMadeFor) {
  const Map prism = [](double x, double y, double w) { return Point3(x, y, 9 * w); };
  const auto two_levels = [](const Point2& p) {
    return p.x() > 0 ? std::pair(0, 5) : std::pair(3, 9);
  };
  const Solid steps = make_steps(make_grid(6, 6), two_levels, 9, prism);
  Solid bound = make_solid(make_grid(6, 6), 4, prism);
  bound.fixed[bound.extrusion.node(24, 2)] = 1;
  using enum PlacementMethod;
  for (const PlacementMethod method :
       {bm_sweep, boundary_error, mean_value, green, triharmonic_rbf, harmonic_grid}) {
    EXPECT_THROW(placed(steps, method), InputError) << name_of(method);
    EXPECT_THROW(placed(bound, method), InputError) << name_of(method);
  }
  const Solid large = make_solid(make_grid(45, 45), 3, prism);
  EXPECT_THROW(placed(large, PlacementMethod::triharmonic_rbf), InputError);
}

TEST(PlacementMethods, NamesAreDistinct) {
  std::set<std::string> names;
  for (const PlacementMethod method : all_placement_methods())
    EXPECT_TRUE(names.insert(name_of(method)).second);
  EXPECT_EQ(names.size(), 12u);
}

}  // namespace
}  // namespace sweepmesh
