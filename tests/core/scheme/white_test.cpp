#include "sweepmesh/scheme/white.h"

#include <gtest/gtest.h>

#include "scheme_solids.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {
namespace {

WhiteConditions conditions(const Model& model, const std::vector<FaceId>& caps) {
  Context context;
  return white_conditions(sweep_problem(model, context), caps);
}

std::vector<FaceId> caps_of(const Scheme& scheme) {
  std::vector<FaceId> out = scheme.faces_with(FaceRole::source);
  for (FaceId f : scheme.faces_with(FaceRole::target)) out.push_back(f);
  return out;
}

TEST(White, HoldsForThePlainSweepsThatAreFound) {
  Context context;
  int n_held = 0;
  for (const auto& solids : {test::prisms(), test::many_to_one()})
    for (const auto& [name, model] : solids) {
      const Scheme best = assess(model, {}, context).schemes.front();
      EXPECT_TRUE(conditions(model, caps_of(best)).hold()) << name;
      ++n_held;
    }
  EXPECT_GT(n_held, 8);
}

TEST(White, FailsOneConditionAtATime) {
  const Model box = test::box(1, 1, 1);
  const FaceId first = box.faces().front();
  const FaceId beside = box.partner(box.loops(first)[0][0]).face;
  EXPECT_FALSE(conditions(box, {}).hold());  // chains cannot close around all three axes
  EXPECT_FALSE(conditions(box, {}).entities.empty());
  EXPECT_FALSE(conditions(box, {first}).agrees_over_equal_edges &&
               conditions(box, {first}).has_chains);
  EXPECT_FALSE(conditions(box, {first, beside}).hold());
}

TEST(White, DiscThatLinksCannotBeMapped) {
  const auto prisms = test::prisms();
  const Model& disc = std::ranges::find(prisms, "disc", &test::NamedModel::name)->model;
  FaceId wall;
  for (FaceId f : disc.faces())
    if (!disc.is_planar(f)) wall = f;
  const WhiteConditions found = conditions(disc, {wall});
  EXPECT_FALSE(found.has_chains);
  EXPECT_EQ(found.entities.size(), 2u);
}

/// Radial: sweepable, but there is no chain.
TEST(White, RefusesARadialSweepWrongly) {
  Context context;
  const Model model = test::hollow_ball(1);
  EXPECT_TRUE(assess(model, {}, context).is_sweepable());
  EXPECT_FALSE(conditions(model, model.faces()).hold());
}

/// A closed void touches no chain: the conditions hold, yet no layers go around it (as in
/// figure 2.12).
TEST(White, AcceptsAVoidWrongly) {
  Context context;
  const Model model = test::box_with_ball_void();
  std::vector<FaceId> caps;
  for (FaceId f : model.faces()) {
    const auto [low, high] = model.uv_bounds(f);
    if (!model.is_planar(f) || std::abs(model.normal(f, 0.5 * (low + high)).z()) > 0.9)
      caps.push_back(f);
  }
  ASSERT_EQ(caps.size(), 3u);
  EXPECT_TRUE(conditions(model, caps).hold());
  std::vector<FaceRole> roles(model.n_faces(), FaceRole::linking);
  for (FaceId f : caps) roles[f.index] = FaceRole::source;
  for (FaceId f : caps)
    if (model.is_planar(f)) {
      roles[f.index] = FaceRole::target;
      break;
    }
  EXPECT_TRUE(std::holds_alternative<std::vector<Reason>>(solve_scheme(model, roles, context)));
}

}  // namespace
}  // namespace sweepmesh
