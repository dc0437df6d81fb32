// The mesh of one face: taken from a surface mesh, seen from behind, and found again in another.
#include "sweepmesh/surface/face_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sweepmesh {
namespace {

/// m x n unit squares.
FaceMesh grid(int m, int n) {
  FaceMesh out;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) out.points.emplace_back(i, j, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const int a = j * (m + 1) + i;
      for (const int node : {a, a + 1, a + m + 2, a + m + 1}) out.cell_nodes.push_back(node);
      out.cell_offset.push_back(static_cast<int>(out.cell_nodes.size()));
    }
  return out;
}

/// The same mesh with its nodes and cells in another order; `to` tells where nodes went.
FaceMesh shuffled(const FaceMesh& mesh, std::vector<int>& to) {
  std::mt19937 random(7);
  to.resize(mesh.points.size());
  for (std::size_t n = 0; n < to.size(); ++n) to[n] = static_cast<int>(n);
  std::shuffle(to.begin(), to.end(), random);
  FaceMesh out;
  out.points.resize(to.size());
  for (std::size_t n = 0; n < to.size(); ++n) out.points[to[n]] = mesh.points[n];
  for (int c = mesh.n_cells() - 1; c >= 0; --c) {
    const auto cell = mesh.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i)
      out.cell_nodes.push_back(to[cell[(i + c) % cell.size()]]);
    out.cell_offset.push_back(static_cast<int>(out.cell_nodes.size()));
  }
  return out;
}

std::vector<int> known_on_boundary(const FaceMesh& mesh, int m, int n, const std::vector<int>& to) {
  std::vector<int> known(mesh.points.size(), -1);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const Point3& p = mesh.points[i];
    if (p.x() == 0 || p.x() == m || p.y() == 0 || p.y() == n) known[i] = to[i];
  }
  return known;
}

TEST(FaceMesh, is_found_again_from_its_boundary) {
  for (const int m : {1, 2, 5}) {
    const FaceMesh mesh = grid(m, 4);
    std::vector<int> to;
    const FaceMesh other = shuffled(mesh, to);
    const auto found = matched(mesh, other, known_on_boundary(mesh, m, 4, to));
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, to);
  }
}

TEST(FaceMesh, seen_from_behind_is_another_mesh) {
  const FaceMesh mesh = grid(3, 3);
  std::vector<int> to;
  const FaceMesh other = shuffled(mesh, to);
  EXPECT_FALSE(matched(mesh, seen_from_behind(other), known_on_boundary(mesh, 3, 3, to)));
  EXPECT_TRUE(
      matched(seen_from_behind(mesh), seen_from_behind(other), known_on_boundary(mesh, 3, 3, to)));
}

TEST(FaceMesh, other_cells_within_the_same_boundary_are_no_match) {
  const FaceMesh mesh = grid(3, 3);
  FaceMesh other = mesh;  // the inner node (1, 1) is cut off its neighbours: cells meet elsewhere
  for (int& node : other.cell_nodes)
    if (node == 5)
      node = 6;
    else if (node == 6)
      node = 5;
  std::vector<int> same(mesh.points.size());
  for (std::size_t n = 0; n < same.size(); ++n) same[n] = static_cast<int>(n);
  EXPECT_TRUE(matched(mesh, mesh, known_on_boundary(mesh, 3, 3, same)));
  auto known = same;
  EXPECT_FALSE(matched(mesh, other, known));
  EXPECT_FALSE(matched(mesh, grid(3, 2), known_on_boundary(mesh, 3, 3, same)));
}

TEST(FaceMesh, of_a_surface_mesh_has_the_cells_of_that_face) {
  SurfaceMesh surface;
  std::vector<NodeId> n;
  for (int i = 0; i < 6; ++i) n.push_back(surface.add_node(Point3(i % 3, i / 3, 0), {}));
  surface.add_cell({n[0], n[1], n[4], n[3]}, FaceId{0});
  surface.add_cell({n[1], n[2], n[5], n[4]}, FaceId{1});
  std::vector<NodeId> nodes;
  const FaceMesh mesh = mesh_of_face(surface, FaceId{1}, &nodes);
  EXPECT_EQ(mesh.n_cells(), 1);
  EXPECT_EQ(nodes, (std::vector<NodeId>{n[1], n[2], n[5], n[4]}));
  EXPECT_EQ(mesh.points[2], surface.points[5]);
}

}  // namespace
}  // namespace sweepmesh
