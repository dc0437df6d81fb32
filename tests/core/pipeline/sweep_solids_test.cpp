// Shapes of several solids: one verdict, meshes side by side, picks where they belong.
#include "sweepmesh/pipeline/sweep_solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

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

/// How many hexahedra have each quad, told by its sorted corners.
std::map<std::vector<int>, int> uses_of_quads(const VolumeMesh& mesh) {
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::vector<int>, int> uses;
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& face : faces) {
      std::vector<int> corners;
      for (const int c : face) corners.push_back(hexahedron[c]);
      std::sort(corners.begin(), corners.end());
      ++uses[corners];
    }
  return uses;
}

TEST(SweepSolids, coincident_faces_get_one_mesh_under_both_names) {
  const SweepResult both = swept(test::two_boxes(0));
  EXPECT_TRUE(both.warnings.empty());
  EXPECT_NEAR(both.quality.total_volume, 2 * 1000, 1e-6);
  const auto uses = uses_of_quads(both.mesh);
  std::map<int, int> n_common;  // polygons between two hexahedra, by face
  for (std::size_t c = 0; c < both.mesh.boundary_face.size(); ++c) {
    std::vector<int> corners(both.mesh.boundary_nodes.begin() + both.mesh.boundary_offset[c],
                             both.mesh.boundary_nodes.begin() + both.mesh.boundary_offset[c + 1]);
    std::sort(corners.begin(), corners.end());
    if (uses.at(corners) == 2) ++n_common[both.mesh.boundary_face[c].index];
  }
  ASSERT_EQ(n_common.size(), 2u);  // one face of each box, all 16 of its polygons
  for (const auto& [face, n] : n_common) EXPECT_EQ(n, 16) << name_of(FaceId{face});
}

TEST(SweepSolids, faces_that_overlap_in_part_are_told_of) {
  const SweepResult both = swept(test::boxes_touching_in_part());
  ASSERT_EQ(both.warnings.size(), 1u);
  EXPECT_NE(both.warnings.front().find("BooleanFragments"), std::string::npos);
  EXPECT_NE(both.warnings.front().find("of solid 1 and Face"), std::string::npos);
}

/// A count for all edges of a solid that run along y.
void count_along_y(const Model& solid, int count, SweepOptions& options) {
  for (const EdgeId edge : solid.edges())
    if (std::abs(solid.tangent(edge, 0.0).y()) > 0.9) options.edge_count[edge] = count;
}

TEST(SweepSolids, counts_of_one_solid_reach_the_other) {
  const auto solids = solids_of(test::two_boxes(0));
  SweepOptions options = of_size(2.5);
  count_along_y(solids[1], 7, options);
  Context context;
  const SweepResult both = sweep_solids(solids, {}, options, context);
  EXPECT_TRUE(both.warnings.empty());
  EXPECT_EQ(both.mesh.hexahedra.size(), 2u * 4 * 4 * 7);
}

TEST(SweepSolids, counts_that_contradict_each_other_leave_the_contact_open) {
  const auto solids = solids_of(test::two_boxes(0));
  SweepOptions options = of_size(2.5);
  count_along_y(solids[0], 6, options);
  count_along_y(solids[1], 8, options);
  Context context;
  const SweepResult both = sweep_solids(solids, {}, options, context);
  EXPECT_EQ(both.mesh.hexahedra.size(), 4u * 4 * 6 + 4 * 4 * 8);
  ASSERT_EQ(both.warnings.size(), 1u);
  EXPECT_NE(both.warnings.front().find("share no nodes there"), std::string::npos);
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
