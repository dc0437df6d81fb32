#include "sweepmesh/volume/place.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCore>
#include <random>
#include <tuple>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/volume/layer_motion.h"

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

/// The energy of thesis-like harmonic coordinates, assembled node by node from the metric alone:
/// another route to the operator that the solver never forms.
Eigen::SparseMatrix<double> assembled(const Extrusion& x, const BaseMetric& metric) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto spring = [&](long a, long b, double w) {
    for (const auto& [i, j, v] : {std::tuple(a, a, w), {b, b, w}, {a, b, -w}, {b, a, -w}})
      entries.emplace_back(i, j, v);
  };
  for (int c = 0; c < x.n_cells(); ++c) {
    const int n = x.cell_size(c), *columns = x.cell_columns.data() + x.cell_offset[c];
    for (int k = x.cell_k_low[c]; k < x.cell_k_high[c]; ++k) {
      const double h = metric.height_of(k);
      long pair = metric.pair_offset[c];
      for (int i = 0; i < n; ++i) {
        spring(x.node(columns[i], k), x.node(columns[i], k + 1),
               metric.corner_mass[x.cell_offset[c] + i] / h);
        for (int j = i + 1; j < n; ++j, ++pair)
          for (const int end : {k, k + 1})
            spring(x.node(columns[i], end), x.node(columns[j], end),
                   0.5 * h * metric.pair_weight[pair]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(x.n_nodes(), x.n_nodes());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(PlaceInterior, FreeNodesAreInHarmonicEquilibriumWithTheBoundary) {
  for (const Base& base :
       {make_square_with_hole(12, 4), with_triangles(make_square_with_hole(12, 4))}) {
    const Solid solid = make_solid(base, 9, moving_hole(0.3, 0.7, 0.1));
    Points points = solid.input();
    PlacementOptions options;
    options.reduction = 1e-6;
    options.improve.up_to = options.improve.lift_below = options.raise_mean_below = 0.0;
    Context context;
    const PlacementReport report =
        place_interior(solid.extrusion, solid.fixed, points, options, context);
    EXPECT_TRUE(report.was_solved);
    // The correction of the affine motion, not the position, is what is harmonic.
    ThreadTeam team;
    const BaseMetric metric = make_base_metric(solid.extrusion, solid.fixed, points, team);
    const LayerMotion motion =
        make_layer_motion(solid.extrusion, solid.fixed, points, metric, team);
    Points prediction(points.rows(), 3), correction = points;
    std::vector<Point3> column(10);
    for (int c = 0; c < solid.extrusion.n_columns(); ++c) {
      predict(solid.extrusion, points, motion.blocks[0], c, 0, 10, column.data());
      for (int k = 0; k < 10; ++k)
        correction.row(solid.extrusion.node(c, k)) -= column[k].transpose();
    }
    const Eigen::SparseMatrix<double> matrix = assembled(solid.extrusion, metric);
    const Points force = matrix * correction;
    double free_force = 0.0, bound_force = 0.0;
    for (long n = 0; n < points.rows(); ++n)
      (solid.fixed[n] ? bound_force : free_force) =
          std::max(solid.fixed[n] ? bound_force : free_force, force.row(n).norm());
    EXPECT_LT(free_force, 1e-5 * bound_force);
  }
}

TEST(PlaceInterior, CorrectionObeysTheMaximumPrinciple) {
  // Every harmonic value is a convex combination of the boundary's, so no node moves further than
  // those.
  const Solid solid = make_solid(make_square_with_hole(16, 4), 9, moving_hole(0.0, 3.0, 0.0));
  Points points = solid.input();
  Context context;
  PlacementOptions plain, affine;
  plain.improve.up_to = plain.improve.lift_below = 0.0;
  const PlacementReport report =
      place_interior(solid.extrusion, solid.fixed, points, plain, context);
  affine.method = PlacementMethod::layer_affine;
  Points motion = solid.input();
  place_interior(solid.extrusion, solid.fixed, motion, affine, context);
  EXPECT_GT(report.largest_residual, 0.0);
  EXPECT_LE((points - motion).rowwise().norm().maxCoeff(), report.largest_residual * (1 + 1e-6));
}

TEST(PlaceInterior, DoesNotDependOnTheNumberOfThreads) {
  for (const double turn : {0.4, 0.45}) {  // the second one has to be untangled
    const Solid solid = make_solid(make_square_with_hole(24, 8), 40, moving_hole(turn, 1.0, 0.1));
    Points one = solid.input();
    Context single(1);
    const PlacementReport report = place_interior(solid.extrusion, solid.fixed, one, {}, single);
    EXPECT_TRUE(report.was_solved);
    for (const int n : {2, 3, 5}) {
      Points many = solid.input();
      Context context(n);
      place_interior(solid.extrusion, solid.fixed, many, {}, context);
      EXPECT_EQ(one, many);
    }
  }
}

TEST(PlaceInterior, MovingHolesThroughManyRuns) {
  // Levels inside, runs that begin and end there, and a hole through all of them.
  const auto range = [](const Point2& p) {
    return std::pair(p.x() > 0 ? 0 : 7, p.y() > 1 ? 20 : 13);
  };
  for (const Base& base :
       {make_square_with_hole(24, 8), with_triangles(make_square_with_hole(24, 8))}) {
    const Solid solid = make_steps(base, range, 20, moving_hole(0.4, 1.0, 0.1));
    Points points = solid.input();
    Context context;
    const PlacementReport report =
        place_interior(solid.extrusion, solid.fixed, points, {}, context);
    EXPECT_TRUE(report.was_solved);
    const double exact =
        measure_quality(solid.extrusion, solid.exact, {}, context).scaled_jacobian.min;
    EXPECT_GT(report.min_scaled_jacobian, 0.8 * exact);
  }
}

TEST(PlaceInterior, DisjointColumnsOverOneSpotDoNotFeelEachOther) {
  // Two blocks, one over the other, in one extrusion: as if each were alone.
  const Base base = make_square_with_hole(8, 2);
  const Solid alone = make_solid(base, 6, moving_hole(0.3, 0.5, 0.1));
  Extrusion both = alone.extrusion;
  const int n = both.n_columns();
  for (int c = 0; c < n; ++c) both.add_column(6, 12);
  for (const auto& cell : base.cells) {
    std::vector<int> upper = cell;
    for (int& c : upper) c += n;
    both.add_cell(upper, 6, 12);
  }
  std::vector<char> fixed = alone.fixed;
  fixed.insert(fixed.end(), alone.fixed.begin(), alone.fixed.end());
  const Points one = alone.input();
  Points points(2 * one.rows(), 3);
  points << one, one;
  Points expected = one;
  Context context;
  PlacementOptions plain;
  plain.improve.up_to = plain.improve.lift_below = 0.0;
  place_interior(alone.extrusion, alone.fixed, expected, plain, context);
  place_interior(both, fixed, points, plain, context);
  EXPECT_LT((points.topRows(one.rows()) - expected).norm(), 1e-3);
  EXPECT_LT((points.bottomRows(one.rows()) - expected).norm(), 1e-3);
}

TEST(PlaceInterior, FixedNodesInsideStayAndAreFollowed) {
  Solid solid = make_solid(make_grid(10, 10), 8,
                           [](double x, double y, double w) { return Point3(x, y, 8 * w); });
  const long node = solid.extrusion.node(60, 4);
  solid.fixed[node] = 1;
  Points points = solid.input();
  points(node, 2) += 0.5;
  const Point3 pulled = points.row(node);
  Context context;
  const PlacementReport report = place_interior(solid.extrusion, solid.fixed, points, {}, context);
  EXPECT_TRUE(report.was_solved);
  EXPECT_EQ(Point3(points.row(node)), pulled);
  EXPECT_GT(points(node + 1, 2), solid.exact(node + 1, 2) + 0.05);
  EXPECT_LT(points(node + 1, 2), solid.exact(node + 1, 2) + 0.5);
}

TEST(PlaceInterior, HearsACancel) {
  const Solid solid = make_solid(make_square_with_hole(12, 4), 6, moving_hole(0.3, 1.0, 0.1));
  for (const PlacementMethod method :
       {PlacementMethod::harmonic_residual, PlacementMethod::mean_value,
        PlacementMethod::boundary_error}) {
    Points points = solid.input();
    PlacementOptions options;
    options.method = method;
    Context context;
    context.cancel();
    EXPECT_THROW(place_interior(solid.extrusion, solid.fixed, points, options, context), Cancelled);
  }
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
    const VolumeMesh mesh = build_volume_mesh(solid.extrusion, solid.exact);
    EXPECT_EQ(mesh.n_elements(), solid.extrusion.n_elements());
    const std::size_t corners = base.cells[0].size();
    EXPECT_EQ(mesh.prisms.empty(), corners != 3);
    EXPECT_EQ(mesh.hexahedra.empty(), corners != 4);
    EXPECT_EQ(mesh.n_polyhedra() > 0, corners > 4);
    for (int i = 0; i < mesh.n_polyhedra(); ++i) EXPECT_EQ(mesh.polyhedron(i).size(), 2 * corners);
    const QualityReport report = measure_quality(mesh, {}, Context());
    EXPECT_GT(report.scaled_jacobian.min, 0.5) << name;
  }
}

}  // namespace
}  // namespace sweepmesh
