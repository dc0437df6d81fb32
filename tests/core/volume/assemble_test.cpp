// Assembly of a one-cell tower and of a stepped one: numbering, fixed nodes, boundary, refusals.
#include "sweepmesh/volume/assemble.h"

#include <gtest/gtest.h>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

const std::array<Point2, 4> square = {Point2(0, 0), Point2(1, 0), Point2(1, 1), Point2(0, 1)};

/// A square tower of n layers with all nodes on its walls.
struct Tower {
  SurfaceMesh surface;
  std::vector<ColumnNodes> columns;

  explicit Tower(int n) {
    for (const Point2& p : square) {
      ColumnNodes column;
      for (int k = 0; k <= n; ++k)
        column.nodes.push_back(
            surface.add_node({p.x(), p.y(), double(k)}, {EntityKind::edge, 0}, k));
      columns.push_back(column);
    }
    add_cells(n);
  }

  void add_cells(int n) {
    const auto at = [&](int c, int k) { return columns[c % 4].nodes[k]; };
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < n; ++k)
        surface.add_cell({at(c, k), at(c + 1, k), at(c + 1, k + 1), at(c, k + 1)}, FaceId{c});
    surface.add_cell({at(0, n), at(1, n), at(2, n), at(3, n)}, FaceId{4});
    surface.add_cell({at(3, 0), at(2, 0), at(1, 0), at(0, 0)}, FaceId{5});
  }
};

std::vector<ColumnId> ids(std::initializer_list<int> indices) {
  std::vector<ColumnId> out;
  for (const int i : indices) out.emplace_back(i);
  return out;
}

TEST(Assemble, tower_has_all_nodes_fixed_in_their_places) {
  const Tower tower(3);
  const Assembly a = assemble(tower.surface, tower.columns, {{ids({0, 1, 2, 3}), 0, 3}});
  EXPECT_EQ(a.extrusion.n_nodes(), 16);
  EXPECT_EQ(a.extrusion.n_elements(), 3);
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k <= 3; ++k) {
      const long n = a.extrusion.node(c, k);
      EXPECT_TRUE(a.fixed[n]);
      EXPECT_EQ(a.points.row(n).transpose(), Point3(square[c].x(), square[c].y(), k));
    }
}

TEST(Assemble, nodes_inside_stay_free) {
  Tower tower(3);
  ColumnNodes inner{0,
                    {tower.surface.add_node({.5, .5, 0}, {EntityKind::face, 5}), NodeId{}, NodeId{},
                     tower.surface.add_node({.5, .5, 3}, {EntityKind::face, 4})}};
  tower.columns.push_back(inner);
  const Assembly a = assemble(tower.surface, tower.columns, {{ids({0, 1, 4}), 0, 3}});
  EXPECT_TRUE(a.fixed[a.extrusion.node(4, 0)]);
  EXPECT_FALSE(a.fixed[a.extrusion.node(4, 1)]);
  EXPECT_FALSE(a.fixed[a.extrusion.node(4, 2)]);
}

TEST(Assemble, boundary_keeps_faces_and_owners) {
  const Tower tower(2);
  const Assembly a = assemble(tower.surface, tower.columns, {{ids({0, 1, 2, 3}), 0, 2}});
  VolumeMesh mesh;
  add_boundary(tower.surface, a, mesh);
  ASSERT_EQ(mesh.boundary_face.size(), 10u);
  EXPECT_EQ(mesh.boundary_face.back(), FaceId{5});
  EXPECT_EQ(mesh.boundary_nodes.size(), 40u);
  for (const Owner& owner : mesh.owner) EXPECT_EQ(owner.kind, EntityKind::edge);
}

TEST(Assemble, runs_that_lie_over_each_other_are_found) {
  // Columns 0 to 3 around a square, 4 and 5 beyond its right side, 6 inside it.
  const CellRun square_run{ids({0, 1, 2, 3}), 0, 4};
  const CellRun beside{ids({1, 4, 5, 2}), 0, 4}, above{ids({0, 1, 2, 3}), 4, 6};
  EXPECT_TRUE(overlapping_runs({square_run, beside, above}).empty());
  const CellRun folded{ids({1, 2, 6}), 2, 3};
  EXPECT_EQ(overlapping_runs({above, square_run, beside, folded}), (std::vector<int>{1, 3}));
  EXPECT_EQ(overlapping_runs({square_run, {ids({0, 1, 2, 3}), 3, 6}}), (std::vector<int>{0, 1}));
}

TEST(Assemble, broken_input_is_refused) {
  Tower tower(2);
  const std::vector<CellRun> run = {{ids({0, 1, 2, 3}), 0, 2}};
  EXPECT_THROW(assemble(tower.surface, tower.columns, {{ids({0, 1, 2, 3}), 0, 3}}), Error);
  auto twice = tower.columns;
  twice[1].nodes[0] = twice[0].nodes[0];
  EXPECT_THROW(assemble(tower.surface, twice, run), Error);
  tower.surface.add_node({9, 9, 9}, {EntityKind::face, 0});
  EXPECT_THROW(assemble(tower.surface, tower.columns, run), Error);
}

}  // namespace
}  // namespace sweepmesh
