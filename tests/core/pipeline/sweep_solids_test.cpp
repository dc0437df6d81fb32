// Shapes of several solids: one verdict, meshes side by side, picks where they belong.
#include "sweepmesh/pipeline/sweep_solids.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace sweepmesh {
namespace {

SweepOptions of_size(double size) {
  SweepOptions options;
  options.size = size;
  return options;
}

SweepResult swept(const Model& shape, const Picks& picks = {}) {
  Context context;
  return sweep_solids(solids_of(shape), picks, of_size(2.5), context);
}

TEST(SweepSolids, meshes_are_put_side_by_side) {
  const Model shape = test::two_boxes(5);
  const SweepResult both = swept(shape);
  Context context;
  long n_hexahedra = 0, n_nodes = 0;
  for (const Model& solid : solids_of(shape)) {
    const SweepResult one = sweep(solid, {}, of_size(2.5), context);
    n_hexahedra += static_cast<long>(one.mesh.hexahedra.size());
    n_nodes += one.mesh.points.rows();
  }
  EXPECT_EQ(static_cast<long>(both.mesh.hexahedra.size()), n_hexahedra);
  EXPECT_EQ(both.mesh.points.rows(), n_nodes);
  EXPECT_EQ(both.mesh.owner.size(), static_cast<std::size_t>(n_nodes));
  EXPECT_EQ(both.quality.n_inverted, 0);
  EXPECT_NEAR(both.quality.total_volume, 2 * 1000, 1e-6);
  EXPECT_TRUE(both.warnings.empty());
  for (const FaceRole role : both.assessment.schemes.front().face_role)
    EXPECT_NE(role, FaceRole::none);
}

TEST(SweepSolids, boundary_cells_refer_to_their_own_solid) {
  const SweepResult both = swept(test::two_boxes(5));
  for (std::size_t c = 0; c < both.mesh.boundary_face.size(); ++c) {
    const bool is_second = both.mesh.boundary_face[c].index >= 6;
    for (int j = both.mesh.boundary_offset[c]; j < both.mesh.boundary_offset[c + 1]; ++j)
      EXPECT_EQ(both.mesh.points(both.mesh.boundary_nodes[j], 0) > 12, is_second);
  }
}

TEST(SweepSolids, touching_solids_are_told_of) {
  EXPECT_EQ(swept(test::two_boxes(0)).warnings.size(), 1u);
}

TEST(SweepSolids, picks_go_to_the_solid_that_has_the_face) {
  const Model shape = test::two_boxes(5);
  Picks picks;
  picks.sources = {FaceId{6}};
  const SweepResult result = swept(shape, picks);
  EXPECT_EQ(result.assessment.schemes.front().face_role[6], FaceRole::source);
  picks.pairs = {{FaceId{0}, FaceId{7}}};
  EXPECT_THROW(swept(shape, picks), InputError);
}

TEST(SweepSolids, one_that_cannot_be_swept_decides_for_all) {
  const SweepResult result = swept(test::box_and_ball());
  EXPECT_FALSE(result.assessment.is_sweepable());
  ASSERT_FALSE(result.assessment.reasons.empty());
  EXPECT_EQ(result.assessment.reasons.front().text.rfind("Solid 2: ", 0), 0u);
  EXPECT_EQ(result.mesh.points.rows(), 0);
  Context context;
  EXPECT_FALSE(assess_solids(solids_of(test::box_and_ball()), {}, context).is_sweepable());
}

}  // namespace
}  // namespace sweepmesh
