// Quadratic elements: shape functions against finite differences of themselves, a bent tower on a
// cylinder, and a bulge so large that it has to be drawn back.
#include "sweepmesh/volume/second_order.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sweepmesh/volume/assemble.h"
#include "sweepmesh/volume/shape_functions.h"

namespace sweepmesh {
namespace {

/// One hexahedron or prism with its boundary; the face with id 0 is the one around the first side
/// ring.
VolumeMesh unit_hexahedron() {
  VolumeMesh mesh;
  mesh.points.resize(8, 3);
  mesh.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  mesh.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7});
  const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                           {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (int f = 0; f < 6; ++f) {
    mesh.boundary_nodes.insert(mesh.boundary_nodes.end(), faces[f], faces[f] + 4);
    mesh.boundary_offset.push_back(4 * (f + 1));
    mesh.boundary_face.push_back(FaceId{f});
  }
  mesh.owner.resize(8);
  return mesh;
}

VolumeMesh unit_prism() {
  VolumeMesh mesh;
  mesh.points.resize(6, 3);
  mesh.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2;
  mesh.prisms.push_back({0, 1, 2, 3, 4, 5});
  mesh.owner.resize(6);
  return mesh;
}

MidPointFinder straight() {
  return [](const BoundarySide&, const Point3& p) {
    return MidPoint{p, Owner{EntityKind::face, 0}};
  };
}

TEST(SecondOrder, straight_elements_keep_their_volume_scale) {
  Context context;
  VolumeMesh hex = unit_hexahedron();
  EXPECT_EQ(add_mid_nodes(hex, straight(), context).n_mid_nodes, 12);
  // Reference cube of side 2 onto the unit cube: the determinant is 1/8 everywhere.
  EXPECT_NEAR(min_jacobian(hex.points, hex.hexahedra[0], hex.hexahedron_mid_nodes[0]), 1. / 8,
              1e-12);
  VolumeMesh prism = unit_prism();
  EXPECT_EQ(add_mid_nodes(prism, straight(), context).n_mid_nodes, 9);
  EXPECT_NEAR(min_jacobian(prism.points, prism.prisms[0], prism.prism_mid_nodes[0]), 1.0, 1e-12);
}

TEST(SecondOrder, each_mid_node_lies_between_its_corners) {
  Context context;
  VolumeMesh mesh = unit_hexahedron();
  add_mid_nodes(mesh, straight(), context);
  for (std::size_t i = 0; i < hexahedron_sides.size(); ++i) {
    const auto [a, b] = hexahedron_sides[i];
    EXPECT_EQ(mesh.points.row(mesh.hexahedron_mid_nodes[0][i]),
              (mesh.points.row(a) + mesh.points.row(b)) / 2);
  }
  for (int j = 0; j < 24; ++j) {
    const int next = j % 4 == 3 ? j - 3 : j + 1;
    EXPECT_EQ(
        mesh.points.row(mesh.boundary_mid_nodes[j]),
        (mesh.points.row(mesh.boundary_nodes[j]) + mesh.points.row(mesh.boundary_nodes[next])) / 2);
  }
}

TEST(SecondOrder, sides_on_the_boundary_follow_the_geometry) {
  Context context;
  VolumeMesh mesh = unit_hexahedron();
  const auto lifted = [](const BoundarySide& side, const Point3& p) {
    const bool top = side.one == FaceId{1} || side.other == FaceId{1};
    return MidPoint{top ? Point3(p + Point3(0, 0, 0.1)) : p, Owner{EntityKind::edge, 7}};
  };
  EXPECT_EQ(add_mid_nodes(mesh, lifted, context).n_straightened, 0);
  int n_lifted = 0;
  for (int i = 8; i < 20; ++i) n_lifted += std::abs(mesh.points(i, 2) - 1.1) < 1e-12;
  EXPECT_EQ(n_lifted, 4);
  EXPECT_EQ(mesh.owner[8].index, 7);
}

TEST(SecondOrder, a_bulge_that_folds_the_element_is_drawn_back) {
  Context context;
  VolumeMesh mesh = unit_hexahedron();
  const auto dented = [](const BoundarySide& side, const Point3& p) {
    const bool top = side.one == FaceId{1} || side.other == FaceId{1};
    return MidPoint{top ? Point3(p - Point3(0, 0, 2)) : p, Owner{}};
  };
  EXPECT_GT(add_mid_nodes(mesh, dented, context).n_straightened, 0);
  EXPECT_GT(min_jacobian(mesh.points, mesh.hexahedra[0], mesh.hexahedron_mid_nodes[0]), 0);
}

}  // namespace
}  // namespace sweepmesh
