// Maps of plane meshes to other boundaries: exactness, untangling, shared distortion, rates at
// random.
#include "sweepmesh/surface/cap_map.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "cap_shapes.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/mean_value_2d.h"
#include "sweepmesh/surface/planar_pair.h"
#include "sweepmesh/surface/widened.h"

namespace sweepmesh {
namespace {

using namespace test;

PlanarMesh meshed(const PlanarLoops& loops, double size) {
  Context context;
  PlanarMeshOptions options;
  options.size = size;
  return mesh_planar(loops, options, context);
}

/// Every third: patterns, unstructured ones and several loops are among them.
std::vector<Outline> some_outlines() {
  std::vector<Outline> out;
  const auto all = outlines();
  for (std::size_t i = 0; i < all.size(); i += 3) out.push_back(all[i]);
  return out;
}

PlanarLoops block_with_hole(double size) {
  return {rectangle({0, 0}, {60, 60}, size), as_hole(rectangle({22, 22}, {38, 38}, size))};
}

std::vector<Point2> boundary_of(const PlanarMesh& mesh) {
  return {mesh.points.begin(), mesh.points.begin() + mesh.n_boundary};
}

TEST(CapMap, affine_motions_are_reproduced) {
  const Context context;
  for (const Outline& outline : some_outlines()) {
    const PlanarMesh mesh = meshed(outline.loops, outline.size);
    Eigen::Matrix2d a;
    a << 1.4, 0.3, -0.5, 0.9;
    const auto image = [&](const Point2& p) -> Point2 { return a * p + Point2(7, -3); };
    std::vector<Point2> boundary = boundary_of(mesh);
    std::transform(boundary.begin(), boundary.end(), boundary.begin(), image);
    MapOptions options;
    options.poor = -1.0;
    const PlanarMap map = map_planar(mesh, boundary, options, context);
    for (int i = 0; i < mesh.n_nodes(); ++i)
      EXPECT_LT((map.points[i] - image(mesh.points[i])).norm(), 1e-9 * 60) << outline.name;
  }
}

TEST(CapMap, harmonic_values_lie_between_those_of_the_boundary) {
  for (const Outline& outline : some_outlines()) {
    const PlanarMesh mesh = meshed(outline.loops, outline.size);
    std::vector<Point2> values(mesh.n_boundary);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (Point2& v : values) v = Point2(unit(random), unit(random));
    for (const Point2& v : harmonic_extension(mesh, values)) {
      EXPECT_GE(v.minCoeff(), -1e-12);
      EXPECT_LE(v.maxCoeff(), 1.0 + 1e-12);
    }
  }
}

struct Motion {
  std::string name;
  double angle, factor;
  Point2 shift;
};

PlanarLoops with_hole_moved(PlanarLoops loops, const Motion& m) {
  loops[1] = moved(loops[1], {30, 30}, m.angle, m.factor, m.shift);
  return loops;
}

class CapMotions : public testing::TestWithParam<Motion> {};

TEST_P(CapMotions, a_hole_may_move_where_harmonic_maps_fold) {
  const Context context;
  const Motion& m = GetParam();
  const PlanarLoops source = block_with_hole(3.0), target = with_hole_moved(source, m);
  const PlanarMesh mesh = meshed(source, 3.0);
  const PlanarMap map = map_planar(mesh, flattened(target), {}, context);
  EXPECT_EQ(map.final.n_inverted, 0);
  EXPECT_GT(map.final.min, 0.15);
  EXPECT_GE(map.final.min, map.harmonic.min);
  PlanarMeshOptions options;
  options.size = 3.0;
  const PlanarPair pair = mesh_planar_pair(source, target, options, {}, context);
  EXPECT_GT(pair.first_quality.min, 0.35);
  EXPECT_GT(pair.second_quality.min, 0.35);
  EXPECT_EQ(boundary_of(pair.first), flattened(source));
  EXPECT_TRUE(std::equal(pair.second.begin(), pair.second.begin() + pair.first.n_boundary,
                         flattened(target).begin()));
}

INSTANTIATE_TEST_SUITE_P(Holes, CapMotions,
                         testing::Values(Motion{"turns_45", pi / 4, 1.0, {0, 0}},
                                         Motion{"turns_70", 70 * pi / 180, 1.0, {0, 0}},
                                         Motion{"turns_90", pi / 2, 1.0, {0, 0}},
                                         Motion{"moves", 0.0, 1.0, {14, 14}},
                                         Motion{"grows", 0.0, 1.9, {0, 0}},
                                         Motion{"shrinks", 0.0, 0.4, {0, 0}},
                                         Motion{"does_all", pi / 4, 1.3, {10, 8}}),
                         [](const auto& info) { return info.param.name; });

/// The shortest side with an end inside, over what it should be.
double least_share(const PlanarMesh& mesh, const std::vector<Point2>& points,
                   const SideLengths& wished) {
  double least = 1.0;
  for (int c = 0; c < mesh.n_cells(); ++c)
    for (int i = 0, n = static_cast<int>(mesh.cell(c).size()); i < n; ++i) {
      const int a = mesh.cell(c)[i], b = mesh.cell(c)[(i + 1) % n];
      if (std::max(a, b) >= mesh.n_boundary)
        least = std::min(least, (points[b] - points[a]).norm() / wished[mesh.cell_offset[c] + i]);
    }
  return least;
}

TEST_P(CapMotions, squeezed_cells_are_widened_and_lose_no_angle) {
  const Context context;
  const Motion& m = GetParam();
  const PlanarLoops source = block_with_hole(3.0), target = with_hole_moved(source, m);
  const PlanarMesh mesh = meshed(source, 3.0);
  MapOptions as_before;
  as_before.squeezed = 0.0;
  const PlanarMap before = map_planar(mesh, flattened(target), as_before, context);
  const SideLengths wished = lengths_like(mesh, {}, before.points, {});
  const double was = least_share(mesh, before.points, wished);
  const PlanarMap now = map_planar(mesh, flattened(target), {}, context);
  if (was >= MapOptions{}.squeezed) {
    EXPECT_EQ(now.points, before.points);
    return;
  }
  EXPECT_GT(least_share(mesh, now.points, wished), std::min(1.2 * was, MapOptions{}.squeezed));
  EXPECT_GE(now.final.min, std::min(before.final.min, WidenOptions{}.good_enough));
  EXPECT_GE(now.final.mean, before.final.mean - 0.01);
}

TEST(CapMap, bands_narrower_than_they_should_be_become_wider) {
  const Context context;
  PlanarMesh mesh = meshed({rectangle({0, 0}, {10, 10}, 1.0)}, 1.0);
  const SideLengths wished = lengths_of_regular(mesh, {});
  std::vector<Point2> points = mesh.points;
  for (int i = mesh.n_boundary; i < mesh.n_nodes(); ++i)  // rows nearer to one side
    points[i].y() *= points[i].y() / 10.0;
  const double was = least_share(mesh, points, wished);
  ASSERT_LT(was, 0.15);
  const auto now = widened(mesh, points, wished, {}, {}, context);
  EXPECT_GT(least_share(mesh, now, wished), 1.5 * was);
  EXPECT_GE(quality(now, mesh).min, std::min(0.7, quality(points, mesh).min));
  EXPECT_EQ(widened(mesh, mesh.points, wished, {}, {}, context), mesh.points);
  std::swap(points[mesh.n_boundary], points.back());
  EXPECT_EQ(widened(mesh, points, wished, {}, {}, context), points) << "inverted: left alone";
}

/// Of the worse end, whatever the other one pays for it.
double evenness_of(const PlanarMesh& mesh, const std::vector<Point2>& second) {
  PlanarMesh there = mesh;
  there.points = second;
  return std::min(evenness(mesh, mesh.points, lengths_of_regular(mesh, {}), {}),
                  evenness(there, second, lengths_of_regular(there, {}), {}));
}

TEST(CapMap, a_pair_shares_between_its_ends_what_squeezes_cells) {
  const Context context;
  PlanarMeshOptions options;
  for (const double shift : {8.0, 10.0, 12.0, 14.0})
    for (const double size : {3.8, 3.0, 2.6, 2.2}) {
      const int n = 2 * static_cast<int>(std::lround(9.0 * pi / size));
      const auto with_hole = [&](double at) {
        return PlanarLoops{rectangle({0, 0}, {60, 60}, size), as_hole(circle(n, 9.0, {at, at}))};
      };
      options.size = size;
      const PlanarPair pair =
          mesh_planar_pair(with_hole(30.0 - shift), with_hole(30.0 + shift), options, {}, context);
      EXPECT_GT(evenness_of(pair.first, pair.second), shift < 14.0 ? 0.78 : 0.5)
          << size << " " << shift;
      EXPECT_GT(std::min(pair.first_quality.min, pair.second_quality.min), 0.4)
          << size << " " << shift;
    }
}

TEST(CapMap, a_valid_map_is_left_alone_where_it_is_good) {
  const Context context;
  const PlanarLoops source = block_with_hole(3.0);
  PlanarLoops target = source;
  target[1] = moved(target[1], {30, 30}, 0.25, 1.0, {0, 0});
  const PlanarMesh mesh = meshed(source, 3.0);
  MapOptions none, some;
  none.poor = -1.0;
  some.poor = 0.05;
  const PlanarMap harmonic = map_planar(mesh, flattened(target), none, context);
  ASSERT_EQ(harmonic.final.n_inverted, 0);
  ASSERT_GT(harmonic.final.min, some.poor);
  EXPECT_EQ(map_planar(mesh, flattened(target), some, context).points, harmonic.points);
}

TEST(CapMap, what_cannot_be_mapped_is_told) {
  const Context context;
  const PlanarLoops source = block_with_hole(3.0);
  const PlanarMesh mesh = meshed(source, 3.0);
  PlanarLoops outside = source;
  outside[1] = moved(outside[1], {30, 30}, 0.0, 1.0, {40, 0});
  try {
    map_planar(mesh, flattened(outside), {}, context);
    FAIL();
  } catch (const InvalidMeshError& e) {
    EXPECT_FALSE(e.elements().empty());
    EXPECT_EQ(e.stage(), "surface");
  }
  EXPECT_THROW(map_planar(mesh, {{0, 0}}, {}, context), InputError);
  PlanarMeshOptions options;
  options.size = 3.0;
  EXPECT_THROW(mesh_planar_pair(source, outside, options, {}, context), Error);
  EXPECT_THROW(mesh_planar_pair(source, {source[0]}, options, {}, context), InputError);
}

TEST(CapMap, half_way_is_half_of_each_motion) {
  const PlanarLoops source = block_with_hole(3.0);
  PlanarLoops target = source;
  target[1] = moved(target[1], {30, 30}, pi / 2, 4.0, {8, -6});
  for (auto& loop : target) loop = moved(loop, {0, 0}, 0.7, 3.0, {100, 50});
  const PlanarLoops between = half_way(source, target);
  const auto expected = moved(source[1], {30, 30}, pi / 4, 2.0, {4, -3});
  for (std::size_t i = 0; i < source[0].size(); ++i)
    EXPECT_LT((between[0][i] - source[0][i]).norm(), 1e-9);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LT((between[1][i] - expected[i]).norm(), 1e-9);
}

/// A random plate with up to four holes, and the same with its holes moved, turned and grown.
struct RandomCase {
  PlanarLoops source, target;
};

RandomCase random_case(int seed, double strength) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  RandomCase out;
  out.source = {rectangle({0, 0}, {60, 60}, 3)};
  out.target = out.source;
  const std::vector<Point2> places = {{16, 16}, {44, 16}, {16, 44}, {44, 44}};
  const int n_holes = 1 + seed % 4;
  for (int h = 0; h < n_holes; ++h) {
    const Point2 centre = n_holes == 1 ? Point2(30, 30) : places[h];
    const bool is_round = (seed / 4 + h) % 2 == 0;
    const auto hole =
        as_hole(is_round ? circle(12, 5.0, centre)
                         : rectangle(centre - Point2(4.5, 3.0), centre + Point2(4.5, 3.0), 3));
    out.source.push_back(hole);
    out.target.push_back(moved(hole, centre, strength * unit(random) * pi / 2,
                               std::exp(0.4 * strength * unit(random)),
                               strength * 6.0 * Point2(unit(random), unit(random))));
  }
  return out;
}

TEST(CapMap, at_random_nothing_is_inverted_while_the_target_is_a_domain) {
  const Context context;
  for (const double strength : {0.5, 1.0, 1.5}) {
    int n_cases = 0, n_valid = 0, n_harmonic_valid = 0, n_alone_valid = 0;
    double worst = 1.0, sum = 0.0;
    for (int seed = 0; seed < 4; ++seed) {
      const RandomCase c = random_case(seed, strength);
      if (!is_domain(c.target)) continue;
      ++n_cases;
      PlanarMeshOptions options;
      options.size = 3.0;
      const PlanarMesh alone = mesh_planar(c.source, options, context);
      MapOptions harmonic;
      try {
        const PlanarMap map = map_planar(alone, flattened(c.target), harmonic, context);
        n_harmonic_valid += map.harmonic.n_inverted == 0;
        ++n_alone_valid;
      } catch (const InvalidMeshError&) {
      }
      try {
        const PlanarPair pair = mesh_planar_pair(c.source, c.target, options, {}, context);
        EXPECT_EQ(pair.first_quality.n_inverted + pair.second_quality.n_inverted, 0);
        const double least = std::min(pair.first_quality.min, pair.second_quality.min);
        worst = std::min(worst, least);
        sum += least;
        ++n_valid;
      } catch (const InvalidMeshError& e) {
        EXPECT_FALSE(e.elements().empty());
      }
    }
    std::printf(
        "strength %.1f: %d cases; valid: harmonic %d, with energy %d, as a pair %d; "
        "least scaled Jacobian: worst %.3f, mean %.3f\n",
        strength, n_cases, n_harmonic_valid, n_alone_valid, n_valid, worst, sum / n_valid);
    EXPECT_EQ(n_valid, n_cases);
  }
}

TEST(CapFoldover, a_tangled_mesh_is_untangled_and_a_valid_one_stays_valid) {
  const Context context;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const Outline& outline : some_outlines()) {
    const PlanarMesh mesh = meshed(outline.loops, outline.size);
    PlanarMesh tangled = mesh;
    for (int i = mesh.n_boundary; i < mesh.n_nodes(); ++i)
      tangled.points[i] += outline.size * Point2(normal(random), normal(random));
    std::vector<char> fixed(mesh.n_nodes(), 0);
    std::fill_n(fixed.begin(), mesh.n_boundary, 1);
    const auto wishes = corners_like(mesh, mesh.points);
    FoldoverOptions options;
    options.max_iterations = 200;
    const auto result = minimise_foldover(tangled.points, fixed, wishes, {}, options, context);
    EXPECT_TRUE(result.is_valid) << outline.name;
    EXPECT_EQ(quality(result.points, mesh).n_inverted, 0) << outline.name;
    options.max_iterations = 2;
    EXPECT_TRUE(minimise_foldover(mesh.points, fixed, wishes, {}, options, context).is_valid);
  }
}

TEST(CapFoldover, without_a_free_node_nothing_moves) {
  const Context context;
  const PlanarMesh mesh = meshed({rectangle({0, 0}, {4, 4}, 1)}, 1);
  const std::vector<char> fixed(mesh.n_nodes(), 1);
  const auto result =
      minimise_foldover(mesh.points, fixed, corners_like(mesh, mesh.points), {}, {}, context);
  EXPECT_EQ(result.points, mesh.points);
  EXPECT_TRUE(result.is_valid);
}

}  // namespace
}  // namespace sweepmesh
