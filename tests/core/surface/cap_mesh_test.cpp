// Charts and meshes of CAD faces: everything lies where it should, over faces of every kind.
#include "sweepmesh/surface/cap_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "cap_solids.h"
#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/chart.h"

namespace sweepmesh {
namespace {

using namespace test;

class CapFaces : public testing::TestWithParam<const char*> {
 protected:
  const Model& model() const { return solid_.model; }
  double size() const { return solid_.size; }
  CapLoops loops(FaceId face) const {
    const EdgeRows rows = edge_rows(model(), size());
    return cap_loops(model(), face, rows.nodes, rows.t);
  }

 private:
  CurvedSolid solid_ = curved_solid(GetParam());
};

TEST_P(CapFaces, loops_close_and_skip_seams) {
  for (const FaceId face : model().faces())
    for (const auto& loop : loops(face)) {
      ASSERT_GE(loop.size(), 2u);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        EXPECT_NE(loop[i].node, loop[(i + 1) % loop.size()].node);
        EXPECT_LT((model().point(face, loop[i].uv) - loop[i].point).norm(), 1e-5);
        EXPECT_LT((loop[i].point - loop[(i + 1) % loop.size()].point).norm(), 2.5 * size());
      }
    }
}

TEST_P(CapFaces, a_chart_leads_to_the_surface_and_keeps_areas) {
  const Context context;
  for (const FaceId face : model().faces()) {
    const CapLoops boundary = loops(face);
    const Chart chart(model(), face, boundary, 0.5 * size(), context);
    double in_chart = 0.0;
    for (std::size_t l = 0; l < boundary.size(); ++l) {
      in_chart += signed_area(chart.loops()[l]);
      const auto& given = boundary[chart.order()[l]];
      for (std::size_t i = 0; i < given.size(); ++i)
        EXPECT_LT((chart.point(chart.loops()[l][i]) - given[i].point).norm(), 1e-5 * size())
            << name_of(face);
    }
    EXPECT_TRUE(is_domain(chart.loops()));
    // The chart is no isometry, but on the mean areas are kept; facets cut the curved boundary off.
    EXPECT_NEAR(in_chart, model().area(face), 0.12 * model().area(face)) << name_of(face);
  }
}

TEST_P(CapFaces, a_cap_mesh_is_valid_and_lies_on_its_face) {
  const Context context;
  for (const CellKind kind : {CellKind::quad, CellKind::triangle, CellKind::polygon})
    for (const FaceId face : model().faces()) {
      const CapLoops boundary = loops(face);
      const CapMesh cap = mesh_cap(model(), face, boundary, size(), kind, context);
      const PlanarQuality q = quality_in_space(model(), cap);
      EXPECT_EQ(q.n_inverted, 0) << name_of(face);
      EXPECT_GT(q.min, kind == CellKind::quad ? 0.2 : 0.05) << name_of(face);
      std::size_t n_boundary = 0;
      for (const auto& loop : boundary) n_boundary += loop.size();
      EXPECT_EQ(cap.boundary.size(), n_boundary);
      ASSERT_EQ(cap.points.size(), static_cast<std::size_t>(cap.plane.n_nodes()));
      for (std::size_t i = 0; i < cap.points.size(); ++i) {
        EXPECT_LT(model().distance(face, cap.points[i]), 1e-6) << name_of(face);
        EXPECT_LT((model().point(face, cap.uv[i]) - cap.points[i]).norm(), 1e-5) << name_of(face);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Curved, CapFaces, testing::ValuesIn(curved_names),
                         [](const auto& info) { return std::string(info.param); });

TEST(CapMesh, cells_of_a_box_face_outwards_and_close_it) {
  const Context context;
  const Model model = box(10, 8, 6);
  const EdgeRows rows = edge_rows(model, 1.5);
  Point3 sum = Point3::Zero();
  double volume = 0.0;
  for (const FaceId face : model.faces()) {
    const CapLoops loops = cap_loops(model, face, rows.nodes, rows.t);
    const CapMesh cap = mesh_cap(model, face, loops, 1.5, CellKind::quad, context);
    for (int c = 0; c < cap.plane.n_cells(); ++c) {
      const auto cell = cap.plane.cell(c);
      const Point3 area = 0.5 * (cap.points[cell[2]] - cap.points[cell[0]])
                                    .cross(cap.points[cell[3]] - cap.points[cell[1]]);
      EXPECT_GT(area.dot(model.normal(face, cap.uv[cell[0]])), 0.0);
      sum += area;
      volume += area.dot(cap.points[cell[0]]) / 3.0;
    }
  }
  EXPECT_LT(sum.norm(), 1e-9);
  EXPECT_NEAR(volume, 480.0, 1e-9);
}

/// The two faces of a prism that look along z, upper first.
std::pair<FaceId, FaceId> ends(const Model& model) {
  FaceId up, down;
  for (const FaceId f : model.faces()) {
    const auto [low, high] = model.uv_bounds(f);
    const Point3 n = model.normal(f, 0.5 * (low + high));
    if (n.z() > 0.99) up = f;
    if (n.z() < -0.99) down = f;
  }
  return {up, down};
}

CapLoops below(const CapLoops& loops, const CapLoops& there) {
  CapLoops out = loops;
  for (auto& loop : out)
    for (CapNode& node : loop)
      for (const auto& other : there)
        for (const CapNode& candidate : other)
          if ((candidate.point - node.point).head<2>().norm() < 1e-6) {
            node = candidate;
            break;
          }
  return out;
}

TEST(CapMesh, the_target_of_a_right_prism_lies_under_its_source) {
  const Context context;
  for (const auto& [name, model] : prisms()) {
    const auto [up, down] = ends(model);
    ASSERT_TRUE(up.is_valid() && down.is_valid()) << name;
    const EdgeRows rows = edge_rows(model, 2.5);
    const CapLoops loops = cap_loops(model, up, rows.nodes, rows.t);
    const CapLoops partner = below(loops, cap_loops(model, down, rows.nodes, rows.t));
    for (const CellKind kind : {CellKind::quad, CellKind::triangle, CellKind::polygon}) {
      const CapPair pair = mesh_cap_pair(model, up, loops, down, partner, 2.5, kind, context);
      EXPECT_EQ(pair.source.plane.cell_nodes, pair.target.plane.cell_nodes);
      for (std::size_t i = 0; i < pair.source.points.size(); ++i)
        EXPECT_LT((pair.source.points[i] - pair.target.points[i]).head<2>().norm(), 1e-9 * 60)
            << name;
      EXPECT_EQ(quality_in_space(model, pair.source).n_inverted, 0) << name;
      EXPECT_EQ(quality_in_space(model, pair.target).n_inverted, 0) << name;
      std::vector<CapNode> flat;
      const CapMesh source = mesh_cap(model, up, loops, 2.5, kind, context);
      for (const NodeId id : source.boundary)
        for (std::size_t l = 0; l < loops.size(); ++l)
          for (std::size_t i = 0; i < loops[l].size(); ++i)
            if (loops[l][i].node == id) flat.push_back(partner[l][i]);
      const CapMesh target = map_cap(model, source, down, flat, 2.5, context);
      for (std::size_t i = 0; i < source.points.size(); ++i)
        EXPECT_LT((source.points[i] - target.points[i]).head<2>().norm(), 1e-9 * 60) << name;
    }
  }
}

TEST(CapMesh, added_cells_look_outwards_on_both_ends) {
  const Context context;
  const Model model = box(10, 8, 6);
  const auto [up, down] = ends(model);
  const EdgeRows rows = edge_rows(model, 2);
  const CapLoops loops = cap_loops(model, up, rows.nodes, rows.t);
  const CapLoops partner = below(loops, cap_loops(model, down, rows.nodes, rows.t));
  const CapPair pair = mesh_cap_pair(model, up, loops, down, partner, 2, CellKind::quad, context);
  SurfaceMesh mesh;
  int n_given = 0;
  for (const auto& row : rows.nodes)
    for (const NodeId id : row) n_given = std::max(n_given, id.index + 1);
  for (int i = 0; i < n_given; ++i) mesh.add_node(Point3::Zero(), {EntityKind::edge, 0});
  for (const CapMesh* cap : {&pair.source, &pair.target})
    for (std::size_t i = 0; i < cap->boundary.size(); ++i)
      mesh.points[cap->boundary[i].index] = cap->points[i];
  add_cap(pair.source, mesh);
  add_cap(pair.target, mesh);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const int* n = &mesh.cell_nodes[mesh.cell_offset[c]];
    const Point3 area =
        (mesh.points[n[2]] - mesh.points[n[0]]).cross(mesh.points[n[3]] - mesh.points[n[1]]);
    EXPECT_GT(area.z() * (mesh.cell_face[c] == up ? 1.0 : -1.0), 0.0);
  }
  for (int i = n_given; i < mesh.n_nodes(); ++i) EXPECT_EQ(mesh.owner[i].kind, EntityKind::face);
}

TEST(CapMesh, errors_name_the_face) {
  const Context context;
  const auto solids = unsweepable();
  for (const auto& [name, model] : solids)
    for (const FaceId face : model.faces()) {
      if (model.is_planar(face) || name == "box with a ball cut out") continue;
      const EdgeRows rows = edge_rows(model, 3);
      try {
        mesh_cap(model, face, cap_loops(model, face, rows.nodes, rows.t), 3, CellKind::quad,
                 context);
        FAIL() << name << " " << name_of(face);
      } catch (const InputError& e) {
        EXPECT_EQ(e.entities(), std::vector<std::string>{name_of(face)});
      }
    }
  const Model model = box(10, 8, 6);
  const auto [up, down] = ends(model);
  const EdgeRows rows = edge_rows(model, 2);
  CapLoops loops = cap_loops(model, up, rows.nodes, rows.t);
  EXPECT_THROW(mesh_cap(model, up, loops, -1, CellKind::quad, context), InputError);
  const CapMesh source = mesh_cap(model, up, loops, 2, CellKind::quad, context);
  EXPECT_THROW(map_cap(model, source, down, {}, 2, context), InputError);
  loops[0].pop_back();
  EXPECT_THROW(mesh_cap(model, up, loops, 2, CellKind::quad, context), InputError);
}

}  // namespace
}  // namespace sweepmesh
