// Structured grids on the linking faces of whole solids.
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Circ.hxx>

#include "linking_pipeline.h"

namespace sweepmesh {
namespace {

using namespace testing;

TopoDS_Shape cylinder_at(double x, double y, double z, double r, double h) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), r, h).Shape();
}

TopoDS_Wire circle(double x, double z, double r) {
  const gp_Circ c(gp_Ax2(gp_Pnt(x, 0, z), gp_Dir(0, 0, 1)), r);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(c).Edge()).Wire();
}

/// A duct through four circles: a spline surface with a seam.
TopoDS_Shape duct() {
  BRepOffsetAPI_ThruSections loft(true);
  loft.AddWire(circle(0, 0, 5));
  loft.AddWire(circle(2, 10, 7));
  loft.AddWire(circle(6, 20, 4));
  loft.AddWire(circle(6, 30, 5));
  return loft.Shape();
}

TopoDS_Shape twisted() {
  BRepOffsetAPI_ThruSections loft(true, true);
  for (const double turn : {0.0, 0.5}) {
    std::vector<gp_Pnt> square;
    for (int c = 0; c < 4; ++c) {
      const double a = M_PI / 2 * c + turn;
      square.emplace_back(6 * std::cos(a), 6 * std::sin(a), 20 * turn);
    }
    loft.AddWire(wire_of(square));
  }
  return loft.Shape();
}

TopoDS_Shape plate_with_holes() {
  TopoDS_Shape plate = box(40, 30, 8);
  for (const double x : {8.0, 20.0, 32.0})
    plate = BRepAlgoAPI_Cut(plate, cylinder_at(x, 15, -1, 3, 10)).Shape();
  return plate;
}

/// Linking faces stacked along the sweep: a box whose side is divided by an edge at half height.
TopoDS_Shape stacked() {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 5)).Shape();
  const TopoDS_Shape high = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 5), gp_Pnt(10, 10, 12)).Shape();
  return BRepAlgoAPI_Fuse(low, high).Shape();
}

TopoDS_Shape step() {
  return prism({{gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 0, 10), gp_Pnt(12, 0, 10),
                 gp_Pnt(12, 0, 25), gp_Pnt(0, 0, 25)}},
               gp_Vec(0, 20, 0));
}

TopoDS_Shape windows() {
  const auto window = [](double x, double z, double w, double h) {
    return std::vector<gp_Pnt>{gp_Pnt(x, 0, z), gp_Pnt(x + w, 0, z), gp_Pnt(x + w, 0, z + h),
                               gp_Pnt(x, 0, z + h)};
  };
  return prism(
      {window(0, 0, 60, 40), window(5, 5, 12, 10), window(25, 20, 10, 15), window(45, 8, 10, 25)},
      gp_Vec(0, 15, 0));
}

/// A window through the wall of a pipe: holes in periodic faces.
TopoDS_Shape pipe_with_window() {
  const TopoDS_Shape pipe =
      BRepAlgoAPI_Cut(cylinder_at(0, 0, 0, 10, 30), cylinder_at(0, 0, -1, 7, 32)).Shape();
  const TopoDS_Shape cutter = BRepPrimAPI_MakeBox(gp_Pnt(-3, 0, 10), gp_Pnt(3, 20, 18)).Shape();
  return BRepAlgoAPI_Cut(pipe, cutter).Shape();
}

std::vector<std::pair<std::string, TopoDS_Shape>> family() {
  return {{"box", box(10, 20, 30)},
          {"cylinder", cylinder_at(0, 0, 0, 5, 20)},
          {"frustum", BRepPrimAPI_MakeCone(8, 3, 12).Shape()},
          {"duct", duct()},
          {"twisted", twisted()},
          {"plate with holes", plate_with_holes()},
          {"polygon", regular_prism(17, 30, 5)},
          {"stacked", stacked()},
          {"step", step()},
          {"windows", windows()},
          {"pipe with window", pipe_with_window()}};
}

TEST(LinkingFaces, GridsOfManySolidsAndSizes) {
  for (const auto& [name, shape] : family())
    for (const double size : {2.5, 6.0, 50.0}) {
      SCOPED_TRACE(name + " at size " + std::to_string(size));
      const LinkingMesh m = mesh_upright(shape, {.size = size});
      EXPECT_GT(m.mesh.n_cells(), 0);
      expect_valid_linking_mesh(m, 0.1);
    }
}

TEST(LinkingFaces, SameOnEveryRun) {
  for (const auto& [name, shape] : family()) {
    const LinkingMesh a = mesh_upright(shape, {.size = 2.0}),
                      b = mesh_upright(shape, {.size = 2.0});
    EXPECT_EQ(a.mesh.cell_nodes, b.mesh.cell_nodes) << name;
    EXPECT_EQ(a.mesh.points, b.mesh.points) << name;
  }
}

TEST(LinkingFaces, GradedEdgesGradeTheInterior) {
  const Model model = model_of(box(10, 10, 10));
  IntervalOptions options{.size = 1.0};
  for (const EdgeId e : model.edges()) {
    const bool upright = std::abs(model.tangent(e, model.range(e).first).z()) > 0.9;
    const bool starts_low = model.point(model.start(e)).z() < 5.0;
    if (upright) options.edge_bias[e] = {starts_low ? 1.3 : 1.0 / 1.3, false};
  }
  const LinkingMesh m = mesh_upright(box(10, 10, 10), options);
  expect_valid_linking_mesh(m, 0.999);
  for (const auto& chain : columns_from(m.mesh).chains)
    for (std::size_t j = 2; j < chain.size(); ++j) {
      const auto z = [&](std::size_t at) { return m.mesh.points[chain[at].index].z(); };
      EXPECT_NEAR((z(j) - z(j - 1)) / (z(j - 1) - z(j - 2)), 1.3, 1e-6);
    }
}

TEST(LinkingFaces, BiasAlongTheSweep) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const LinkingMesh m = mesh_upright(shape, {.size = 4.0, .sweep_bias = Bias{1.2}});
    expect_valid_linking_mesh(m, 0.05);
  }
  const LinkingMesh m = mesh_upright(box(10, 10, 10), {.size = 1.0, .sweep_bias = Bias{1.2}});
  for (const auto& chain : columns_from(m.mesh).chains)
    for (std::size_t j = 2; j < chain.size(); ++j) {
      const auto z = [&](std::size_t at) { return m.mesh.points[chain[at].index].z(); };
      EXPECT_NEAR((z(j) - z(j - 1)) / (z(j - 1) - z(j - 2)), 1.2, 1e-6);
    }
}

TEST(LinkingFaces, QuadsOfACylinderAreAllAlike) {
  const LinkingMesh m = mesh_upright(cylinder_at(0, 0, 0, 5, 20), {.size = 1.0});
  double least = 1e9, most = 0.0;
  for (int cell = 0; cell < m.mesh.n_cells(); ++cell)
    for (int c = 0; c < 4; c += 2) {
      const int* node = &m.mesh.cell_nodes[m.mesh.cell_offset[cell]];
      const double length = (m.mesh.points[node[c]] - m.mesh.points[node[c + 1]]).norm();
      least = std::min(least, length);
      most = std::max(most, length);
    }
  EXPECT_NEAR(least, most, 1e-6);
}

TEST(LinkingFaces, PoleIsRefused) {
  try {
    mesh_upright(BRepPrimAPI_MakeCone(5, 0, 10).Shape(), {.size = 1.0});
    FAIL() << "nothing was thrown";
  } catch (const InputError& e) {
    EXPECT_EQ(e.stage(), "intervals");
    EXPECT_EQ(e.entities().size(), 1u);
  }
}

TEST(LinkingFaces, CountsThatBoundNoGridAreRefused) {
  Context context;
  const LinkingMesh m = mesh_upright(box(10, 10, 10), {.size = 2.0});
  Intervals wrong = m.intervals;
  for (const EdgeId e : m.model.edges())
    if (std::abs(m.model.tangent(e, m.model.range(e).first).x()) > 0.9) {
      wrong.edge[e.index] += 1;
      break;
    }
  SurfaceMesh mesh;
  const EdgeMesh edges = mesh_edges(m.model, wrong, place_edge_nodes(m.model, wrong, {}), mesh);
  EXPECT_THROW(mesh_linking_faces(m.model, m.scheme, wrong, edges, context, mesh),
               InvalidMeshError);
}

TEST(LinkingFaces, Cancelled) {
  Context context;
  const LinkingMesh m = mesh_upright(box(10, 10, 10), {.size = 2.0});
  context.cancel();
  SurfaceMesh mesh;
  const EdgeMesh edges =
      mesh_edges(m.model, m.intervals, place_edge_nodes(m.model, m.intervals, {}), mesh);
  EXPECT_THROW(mesh_linking_faces(m.model, m.scheme, m.intervals, edges, context, mesh), Cancelled);
}

/// A slot with as many mesh edges along it as the whole block: nothing is left behind it.
TEST(LinkingFaces, SidesThatCannotKeepTheirOrderNameWhatContradictsThem) {
  const std::vector<gp_Pnt> outline = {{0, 0, 0},  {30, 0, 0},  {30, 0, 30}, {0, 0, 30},
                                       {0, 0, 20}, {20, 0, 20}, {20, 0, 10}, {0, 0, 10}};
  const TopoDS_Shape shape = prism({outline}, gp_Vec(0, 9, 0));
  const Model model = model_of(shape);
  IntervalOptions options{.size = 4.0};
  for (const EdgeId e : model.edges())
    if (std::abs(model.tangent(e, model.range(e).first).x()) > 0.9) options.edge_count[e] = 6;
  try {
    mesh_upright(shape, options);
    FAIL() << "a grid was made";
  } catch (const InvalidMeshError& error) {
    EXPECT_NE(std::string(error.what()).find("must have 6 mesh edges"), std::string::npos);
    EXPECT_GE(error.entities().size(), 3u);
  }
}

}  // namespace
}  // namespace sweepmesh
