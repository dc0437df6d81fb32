// Sweeps with many sources and targets, from model to mesh: near-coincident curves, crossings,
// slots, random terraces.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "sweepmesh/pipeline/sweep.h"
#include "terraces.h"

namespace sweepmesh {
namespace {

using test::rectangle;

SweepResult swept(const Model& model, double size, const test::Placement& placement = {}) {
  const Scheme scheme = test::upright_scheme(model, placement);
  Picks picks;
  picks.sources = scheme.faces_with(FaceRole::source);
  picks.targets = scheme.faces_with(FaceRole::target);
  SweepOptions options;
  options.size = size;
  Context context;
  return sweep(model, picks, options, context);
}

/// Quads with two hexahedra, or one and a boundary cell.
void expect_conforming(const VolumeMesh& mesh) {
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::array<int, 4>, int> count;
  const auto add = [&](std::array<int, 4> quad) {
    std::sort(quad.begin(), quad.end());
    ++count[quad];
  };
  for (const auto& hex : mesh.hexahedra)
    for (const auto& f : faces) add({hex[f[0]], hex[f[1]], hex[f[2]], hex[f[3]]});
  for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
    const int* n = &mesh.boundary_nodes[mesh.boundary_offset[c]];
    add({n[0], n[1], n[2], n[3]});
  }
  for (const auto& [quad, n] : count) ASSERT_EQ(n, 2);
}

/// All terraces have plane faces, so the volumes must be the same.
void expect_valid(const Model& model, const SweepResult& result) {
  ASSERT_FALSE(result.mesh.hexahedra.empty());
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_NEAR(result.quality.total_volume / model.volume(), 1.0, 1e-9);
  expect_conforming(result.mesh);
}

TEST(ManyCaps, StepsFromZeroToOneSizeApart) {
  constexpr double size = 5.0;
  for (int i = 0; i <= 20; ++i) {
    SCOPED_TRACE(i);
    const Model model = test::terraced({{rectangle(0, 0, 40, 30), 0, 20},
                                        {rectangle(0, 0, 20, 30), 10, 32},
                                        {rectangle(0, 0, 20 + size * i / 20, 30), -12, 10}});
    expect_valid(model, swept(model, size));
  }
}

TEST(ManyCaps, CrossingsAtEveryAngle) {
  for (const double degrees : {1.0, 3.0, 7.0, 15.0, 30.0, 60.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const double t = std::tan(degrees * std::numbers::pi / 180 / 2) * 50;
    const Model model = test::terraced({{rectangle(-75, -50, 75, 50), 0, 20},
                                        {{{-75, -50}, {-t, -50}, {t, 50}, {-75, 50}}, 10, 32},
                                        {{{-75, -50}, {t, -50}, {-t, 50}, {-75, 50}}, -12, 10}});
    expect_valid(model, swept(model, 8.0));
  }
}

TEST(ManyCaps, SlotsRibsAndWindows) {
  const Model slotted = test::terraced({{rectangle(0, 0, 10, 30), 0, 30},
                                        {rectangle(0, 0, 40, 30), 0, 10},
                                        {rectangle(0, 0, 40, 30), 20, 30}});
  expect_valid(slotted, swept(slotted, 4.0));
  const Model window =
      test::terraced({{rectangle(0, 0, 40, 30), 0, 30}}, {{rectangle(15, -1, 25, 31), 10, 20}});
  expect_valid(window, swept(window, 4.0));
  const Model rib =
      test::terraced({{rectangle(0, 0, 40, 30), 0, 20}, {rectangle(20, 0, 21, 30), 10, 32}});
  expect_valid(rib, swept(rib, 4.0));
}

TEST(ManyCaps, TwistedAndTaperedPockets) {
  for (const double twist : {0.3, 1.0})
    for (const double growth : {0.7, 1.4}) {
      SCOPED_TRACE(twist * growth);
      const Model model = test::pocketed(twist, growth);
      const SweepResult result = swept(model, 5.0);
      EXPECT_EQ(result.quality.n_inverted, 0);
      EXPECT_GT(result.quality.scaled_jacobian.min, 0.15);
      EXPECT_NEAR(result.quality.total_volume / model.volume(), 1.0, 0.01);
      expect_conforming(result.mesh);
    }
}

TEST(ManyCaps, PrismsAreSweptOverTheSamePatches) {
  const Model model = test::terraced({{rectangle(0, 0, 40, 30), 0, 20},
                                      {rectangle(0, 0, 20, 30), 10, 32},
                                      {rectangle(0, 0, 40, 12), -12, 10}});
  const Scheme scheme = test::upright_scheme(model);
  Picks picks;
  picks.sources = scheme.faces_with(FaceRole::source);
  picks.targets = scheme.faces_with(FaceRole::target);
  SweepOptions options;
  options.size = 5.0;
  options.element = ElementKind::prism;
  Context context;
  const SweepResult result = sweep(model, picks, options, context);
  EXPECT_FALSE(result.mesh.prisms.empty());
  EXPECT_TRUE(result.mesh.hexahedra.empty());
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_NEAR(result.quality.total_volume / model.volume(), 1.0, 1e-9);
}

/// Random solids mesh at a rate of at least nine in ten; whatever fails is a typed error that names
/// entities, and no invalid mesh is handed out.
TEST(ManyCaps, RandomTerraces) {
  int n_meshed = 0;
  constexpr int n = 12;
  for (unsigned seed = 100; seed < 100 + n; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = test::terraced(test::random_terraces(seed));
    try {
      expect_valid(model, swept(model, 5.0));
      ++n_meshed;
    } catch (const Error& e) {
      EXPECT_FALSE(e.entities().empty()) << e.what();
    }
  }
  RecordProperty("meshed", n_meshed);
  EXPECT_GE(n_meshed, n * 9 / 10);
}

TEST(ManyCaps, TurnedAndScaledSolidsHaveTheSameCounts) {
  const auto terraces = test::random_terraces(3);
  const std::size_t n = swept(test::terraced(terraces), 5.0).mesh.hexahedra.size();
  for (const double scale : {1e-3, 1e3}) {
    const test::Placement placement{Point3(1, 2, -0.5).normalized(), 1.1, scale};
    const Model model = test::terraced(terraces, {}, placement);
    EXPECT_EQ(swept(model, 5.0 * scale, placement).mesh.hexahedra.size(), n) << scale;
  }
}

}  // namespace
}  // namespace sweepmesh
