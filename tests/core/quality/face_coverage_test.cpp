// Areas of a mesh's boundary against those of the CAD faces.
#include "sweepmesh/quality/face_coverage.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace sweepmesh {
namespace {

/// One polygon a face: its outer loop's vertices.
SurfaceMesh one_cell_a_face(const Model& model) {
  SurfaceMesh mesh;
  std::vector<NodeId> node(model.n_vertices());
  for (const VertexId v : model.vertices())
    node[v.index] = mesh.add_node(model.point(v), {EntityKind::vertex, v.index});
  for (const FaceId f : model.faces()) {
    std::vector<NodeId> corners;
    for (const Coedge& c : model.loops(f).front()) corners.push_back(node[c.start.index]);
    mesh.add_cell(corners, f);
  }
  return mesh;
}

std::vector<FaceCoverage> coverage_of(const Model& model, const SurfaceMesh& mesh) {
  return face_coverage(model, face_areas(model), mesh);
}

TEST(FaceCoverage, flat_faces_are_covered_exactly) {
  const Model model = test::box(2, 3, 5);
  const auto all = coverage_of(model, one_cell_a_face(model));
  ASSERT_EQ(all.size(), 6u);
  double sum = 0.0;
  for (const FaceCoverage& f : all) {
    EXPECT_NEAR(f.deviation(), 0.0, 1e-12);
    sum += f.covered;
  }
  EXPECT_NEAR(sum, 62.0, 1e-9);
  EXPECT_LT(worst_deviation(all), 1e-12);
  EXPECT_TRUE(coverage_warnings(all).empty());
}

TEST(FaceCoverage, a_volume_mesh_has_the_areas_of_its_surface) {
  const Model model = test::box(2, 3, 5);
  const SurfaceMesh surface = one_cell_a_face(model);
  VolumeMesh mesh;
  mesh.points.resize(surface.n_nodes(), 3);
  for (int n = 0; n < surface.n_nodes(); ++n) mesh.points.row(n) = surface.points[n].transpose();
  mesh.boundary_offset = surface.cell_offset;
  mesh.boundary_nodes = surface.cell_nodes;
  mesh.boundary_face = surface.cell_face;
  EXPECT_LT(worst_deviation(face_coverage(model, face_areas(model), mesh)), 1e-12);
}

TEST(FaceCoverage, what_lies_twice_or_not_at_all_is_named) {
  const Model model = test::box(2, 3, 5);
  SurfaceMesh mesh = one_cell_a_face(model);
  const FaceId twice = mesh.cell_face[1], lost = mesh.cell_face[0];
  mesh.cell_face[0] = twice;  // a cell of another face counts for this one
  const auto all = coverage_of(model, mesh);
  for (const FaceCoverage& f : all)
    EXPECT_EQ(is_covered(f), f.face != twice && f.face != lost) << name_of(f.face);
  EXPECT_DOUBLE_EQ(all[lost.index].deviation(), -1.0);
  EXPECT_GT(all[twice.index].deviation(), kMostAreaDeviation);
  const auto warnings = coverage_warnings(all);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[lost.index].find(name_of(lost) + " has 100 % less"), std::string::npos);
  EXPECT_NE(warnings[twice.index].find(name_of(twice) + " has 100 % more"), std::string::npos);
}

TEST(FaceCoverage, areas_of_turned_off_solids_are_left_out) {
  const Model model = test::box_and_ball();
  EXPECT_EQ(face_areas(model).size(), static_cast<std::size_t>(model.n_faces()));
  EXPECT_EQ(coverage_of(model, SurfaceMesh{}).size(), model.faces().size());
}

}  // namespace
}  // namespace sweepmesh
