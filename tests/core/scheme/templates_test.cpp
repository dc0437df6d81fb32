#include "sweepmesh/scheme/templates.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scheme_solids.h"

namespace sweepmesh {
namespace {

using enum VertexType;

int sum_of_nearest(const std::vector<FaceCorner>& loop) {
  int sum = 0;
  for (const FaceCorner& corner : loop) sum += static_cast<int>(nearest_type(corner.angle));
  return sum;
}

long count_virtual(const std::vector<FaceCorner>& loop) {
  return std::ranges::count_if(loop, [](const FaceCorner& c) { return !c.vertex.is_valid(); });
}

/// The flat faces of a solid.
std::vector<FaceId> planes(const Model& model) {
  std::vector<FaceId> out;
  std::ranges::copy_if(model.faces(), std::back_inserter(out),
                       [&](FaceId f) { return model.is_planar(f); });
  return out;
}

TEST(Templates, LeaveFacesWithoutRoundsAlone) {
  const Model model = test::box(3, 4, 5);
  for (FaceId f : model.faces()) {
    const FaceCorners plain = face_corners(model, f), with = face_corners_with_templates(model, f);
    ASSERT_EQ(plain.size(), with.size());
    ASSERT_EQ(plain[0].size(), with[0].size());
    for (std::size_t c = 0; c < plain[0].size(); ++c) {
      EXPECT_EQ(plain[0][c].vertex, with[0][c].vertex);
      EXPECT_NEAR(plain[0][c].angle, with[0][c].angle, 1e-9);
    }
  }
}

TEST(Templates, FullCirclesGetFourVirtualCorners) {
  for (const auto& [name, model] : test::prisms()) {
    if (name != "disc" && name != "ring" && name != "drilled plate") continue;
    for (FaceId f : planes(model)) {
      const FaceCorners corners = face_corners_with_templates(model, f);
      for (std::size_t l = 0; l < corners.size(); ++l) {
        EXPECT_EQ(sum_of_nearest(corners[l]), l == 0 ? 4 : -4) << name << " " << name_of(f);
        const bool is_circle = model.loops(f)[l].size() == 1;
        EXPECT_EQ(count_virtual(corners[l]), is_circle ? 4 : 0) << name << " " << name_of(f);
      }
    }
  }
}

TEST(Templates, VirtualCornersLieAtEvenPlacesOnTheirEdge) {
  const auto solids = test::prisms();
  const Model& disc = std::ranges::find(solids, "disc", &test::NamedModel::name)->model;
  const FaceCorners corners = face_corners_with_templates(disc, planes(disc).front());
  std::vector<double> at;
  for (const FaceCorner& corner : corners[0])
    if (!corner.vertex.is_valid()) at.push_back(corner.at);
  ASSERT_EQ(at.size(), 4u);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(at[j], (j + 0.5) / 4, 1e-9);
}

TEST(Templates, EachRoundAndChamferTakesItsType) {
  const Model model = test::rounded_plate();
  for (FaceId f : planes(model)) {
    if (model.loops(f).size() < 2) continue;  // the walls
    const FaceCorners corners = face_corners_with_templates(model, f);
    Context context;
    const auto solved = solve_vertex_types(corners, {}, context);
    ASSERT_TRUE(std::holds_alternative<VertexTypes>(solved));
    const VertexTypes& types = std::get<VertexTypes>(solved);
    EXPECT_EQ(types.n_changed, 0);
    // One for the chamfer, 1 + 2 + 3 for the quarter, half and three-quarter round, one CORNER for
    // the fillet; the hole has four.
    std::vector<int> n_of = {0, 0};
    for (std::size_t c = 0; c < corners[0].size(); ++c)
      if (!corners[0][c].vertex.is_valid()) ++n_of[types.type[0][c] == corner];
    EXPECT_EQ(n_of, (std::vector{7, 1}));
    EXPECT_EQ(count_virtual(corners[1]), 4);
    EXPECT_TRUE(std::ranges::all_of(corners[1], [&](const FaceCorner& c) {
      return c.vertex.is_valid() || nearest_type(c.angle) == corner;
    }));
  }
}

}  // namespace
}  // namespace sweepmesh
