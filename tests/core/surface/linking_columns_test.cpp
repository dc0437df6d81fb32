#include "sweepmesh/surface/linking_columns.h"

#include <gtest/gtest.h>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

/// A wall of w x h quads; `first_k` is the layer of its lowest nodes.
SurfaceMesh wall(int w, int h, int first_k) {
  SurfaceMesh mesh;
  for (int k = 0; k <= h; ++k)
    for (int i = 0; i <= w; ++i) mesh.add_node({double(i), 0, double(k)}, {}, first_k + k);
  const auto at = [&](int i, int k) { return NodeId{k * (w + 1) + i}; };
  for (int k = 0; k < h; ++k)
    for (int i = 0; i < w; ++i)
      mesh.add_cell({at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}, FaceId{4});
  return mesh;
}

TEST(Columns, OneAChainOfRisingLayers) {
  const SurfaceMesh mesh = wall(3, 5, 2);
  const ColumnChains columns = columns_from(mesh);
  ASSERT_EQ(columns.chains.size(), 4u);
  for (const auto& chain : columns.chains) {
    ASSERT_EQ(chain.size(), 6u);
    for (int j = 0; j < 6; ++j) EXPECT_EQ(mesh.k[chain[j].index], 2 + j);
    for (const NodeId n : chain)
      EXPECT_EQ(mesh.points[n.index].x(), mesh.points[chain[0].index].x());
  }
}

TEST(Columns, CellsOfCapsArePassedOver) {
  SurfaceMesh mesh = wall(1, 2, 0);
  const NodeId a = mesh.add_node({0, 1, 0}, {}, 0), b = mesh.add_node({1, 1, 0}, {}, -1);
  mesh.add_cell({NodeId{0}, a, b, NodeId{1}}, FaceId{0});
  EXPECT_EQ(columns_from(mesh).chains.size(), 2u);
}

TEST(Columns, ForkIsAnError) {
  SurfaceMesh mesh = wall(1, 2, 0);
  const NodeId a = mesh.add_node({2, 0, 1}, {}, 1), b = mesh.add_node({2, 0, 0}, {}, 0);
  const NodeId other_above = mesh.add_node({1, 0.5, 1}, {}, 1);
  mesh.add_cell({NodeId{1}, b, a, other_above}, FaceId{6});
  try {
    columns_from(mesh);
    FAIL() << "nothing was thrown";
  } catch (const InvalidMeshError& e) {
    EXPECT_EQ(e.entities(), std::vector<std::string>{"Face7"});
    EXPECT_EQ(e.elements(), std::vector<long>{2});
  }
}

}  // namespace
}  // namespace sweepmesh
