#include "sweepmesh/scheme/suggested_cut.h"

#include <gtest/gtest.h>

#include "scheme_solids.h"
#include "solids.h"

namespace sweepmesh::test {
namespace {

std::optional<SuggestedCut> suggested(const Model& model) {
  Context context;
  const Assessment found = assess(model, {}, context);
  return found.is_sweepable() ? std::nullopt : suggest_cut(model, found.reasons, {}, context);
}

double sum_of_volumes(const CutPieces& cut) {
  double sum = 0.0;
  for (const Model& piece : cut.pieces) sum += piece.volume();
  return sum;
}

TEST(PlaneCut, divides_a_box_and_keeps_its_volume) {
  const Model whole = box(3, 2, 1);
  const Point3 normal = Point3(1, 2, 3).normalized();
  const CutPieces cut = cut_by_plane(whole, {Point3(1.5, 1, 0.5), normal});
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_NEAR(sum_of_volumes(cut), whole.volume(), 1e-9);
  EXPECT_NEAR(cut.pieces[0].volume(), whole.volume() / 2, 1e-9);
}

TEST(PlaneCut, leaves_alone_what_it_misses_or_only_touches) {
  const Model whole = box(3, 2, 1);
  EXPECT_TRUE(cut_by_plane(whole, {Point3(9, 0, 0), Point3::UnitX()}).pieces.empty());
  EXPECT_TRUE(cut_by_plane(whole, {Point3(0, 0, 1), Point3::UnitZ()}).pieces.empty());
}

TEST(SuggestedCut, parts_two_voids) {
  const Model ball = hollow_ball(2);
  const auto cut = suggested(ball);
  ASSERT_TRUE(cut);
  EXPECT_NEAR(std::abs(cut->plane.normal.x()), 1.0, 1e-9);
  EXPECT_NEAR(cut->plane.point.x(), 0.0, 1e-6);
  EXPECT_EQ(cut->cut.pieces.size(), 2u);
  EXPECT_NEAR(sum_of_volumes(cut->cut), ball.volume(), 1e-6 * ball.volume());
  Context context;
  for (const Model& piece : cut->cut.pieces) EXPECT_TRUE(assess(piece, {}, context).is_sweepable());
  EXPECT_NE(sentence_of(*cut).find("each of the 2 pieces can then be swept."), std::string::npos);
}

TEST(SuggestedCut, takes_the_plane_of_the_face_that_a_handle_stands_on) {
  const Model solid = disc_with_handle();
  const auto cut = suggested(solid);
  ASSERT_TRUE(cut);
  ASSERT_TRUE(cut->face.is_valid());
  EXPECT_TRUE(solid.is_planar(cut->face));
  EXPECT_NEAR(cut->plane.point.z(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(cut->plane.normal.z()), 1.0, 1e-9);
}

TEST(SuggestedCut, is_offered_when_its_pieces_mesh_or_there_was_no_time) {
  const Model ball = hollow_ball(2);
  Context context;
  int n_asked = 0;
  CutOptions options;
  options.can_mesh = [&](const Model& piece, Context&) {
    ++n_asked;
    return piece.volume() < ball.volume();
  };
  const auto tried = suggest_cut(ball, {}, options, context);
  ASSERT_TRUE(tried);
  EXPECT_TRUE(tried->is_tried);
  EXPECT_EQ(n_asked, static_cast<int>(tried->cut.pieces.size()));
  options.trial_seconds = -1.0;
  const auto untried = suggest_cut(ball, {}, options, context);
  ASSERT_TRUE(untried);
  EXPECT_FALSE(untried->is_tried);
  options.trial_seconds = 60.0;
  options.can_mesh = [](const Model&, Context&) { return false; };
  EXPECT_FALSE(suggest_cut(ball, {}, options, context));
}

TEST(PlaneCut, turns_the_poles_of_a_ball_away_from_the_rims) {
  const CutPieces cut = cut_by_plane(hollow_ball(2), {Point3::Zero(), Point3::UnitX()});
  ASSERT_EQ(cut.pieces.size(), 2u);
  for (const Model& piece : cut.pieces)
    EXPECT_EQ(piece.n_faces(), 3);  // half a ball, the cut and the void
}

TEST(SuggestedCut, candidates_differ_from_each_other) {
  for (const Model& solid : {hollow_ball(3), dovetail(), hollow_box()}) {
    const auto all = cut_candidates(solid, {});
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Plane &a = all[i].plane, &b = all[j].plane;
        EXPECT_TRUE(a.normal.cross(b.normal).norm() > 1e-6 ||
                    std::abs((a.point - b.point).dot(a.normal)) > 1e-9);
      }
  }
}

TEST(SuggestedCut, ends_when_no_plane_helps_and_when_it_is_cancelled) {
  EXPECT_FALSE(suggested(hollow_ball(0)));
  Context context;
  context.cancel();
  EXPECT_THROW(suggest_cut(hollow_ball(2), {}, {}, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh::test
