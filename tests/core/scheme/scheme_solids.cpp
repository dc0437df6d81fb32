#include "scheme_solids.h"

#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Circ.hxx>

#include "to_model.h"

namespace sweepmesh::test {
namespace {

TopoDS_Shape block(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Edge line(const gp_Pnt& a, const gp_Pnt& b) {
  return BRepBuilderAPI_MakeEdge(a, b).Edge();
}

TopoDS_Edge arc(const gp_Pnt& a, const gp_Pnt& middle, const gp_Pnt& b) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, middle, b).Value()).Edge();
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : points) wire.Add(p);
  wire.Close();
  return wire.Wire();
}

/// Square section of half width `half`, in the plane x = `x` (or tilted by 45 degrees there),
/// centred at z = `z`.
TopoDS_Wire section(double half, const gp_Pnt& centre, const gp_Vec& across) {
  std::vector<gp_Pnt> points;
  const gp_Vec up(0, half, 0);
  for (auto [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    points.push_back(centre.Translated(across * (a * half) + up * b));
  return polygon(points);
}

/// A bar of square section along x that turns into z at the origin.
TopoDS_Shape mitred_bar(double half, double length) {
  TopoDS_Shape legs[2];
  const gp_Vec mitre(-1, 0, 1);
  int leg = 0;
  for (auto [foot, across] : {std::pair{gp_Pnt(-length, 0, 0), gp_Vec(0, 0, 1)},
                              std::pair{gp_Pnt(0, 0, length), gp_Vec(-1, 0, 0)}}) {
    BRepOffsetAPI_ThruSections loft(true, true);
    loft.CheckCompatibility(false);
    loft.AddWire(section(half, foot, across));
    loft.AddWire(section(half, gp_Pnt(0, 0, 0), mitre));
    legs[leg++] = loft.Shape();
  }
  return BRepAlgoAPI_Fuse(legs[0], legs[1]).Shape();
}

}  // namespace

Model rounded_plate() {
  const double q = std::sqrt(0.5);
  const auto p = [](double x, double y) { return gp_Pnt(x, y, 0); };
  BRepBuilderAPI_MakeWire outline;
  const std::vector<TopoDS_Edge> edges = {
      line(p(12, 0), p(96, 0)),     arc(p(96, 0), p(96 + 14 * q, 14 - 14 * q), p(110, 14)),
      line(p(110, 14), p(110, 60)), line(p(110, 60), p(78, 60)),
      line(p(78, 60), p(78, 74)),   arc(p(78, 74), p(66, 86), p(54, 74)),
      line(p(54, 74), p(54, 66)),   arc(p(54, 66), p(48 + 6 * q, 66 - 6 * q), p(48, 60)),
      line(p(48, 60), p(10, 60)),   arc(p(10, 60), p(-10 * q, 60 + 10 * q), p(0, 50)),
      line(p(0, 50), p(0, 12)),     line(p(0, 12), p(12, 0))};
  for (const TopoDS_Edge& edge : edges) outline.Add(edge);
  BRepBuilderAPI_MakeFace face(outline.Wire());
  const gp_Circ hole(gp_Ax2(p(36, 28), gp_Dir(0, 0, 1)), 10);
  face.Add(TopoDS::Wire(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(hole).Edge()).Wire().Reversed()));
  return to_model(BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 8)).Shape());
}

Model hollow_ball(int n_voids) {
  TopoDS_Shape shape = BRepPrimAPI_MakeSphere(30).Shape();
  for (int v = 0; v < n_voids; ++v) {
    const double x = n_voids == 1 ? 0.0 : -15.0 + 30.0 * v / (n_voids - 1);
    shape = cut(shape, BRepPrimAPI_MakeSphere(gp_Pnt(x, 0, 0), 6).Shape());
  }
  return to_model(shape);
}

Model disc_with_handle() {
  const TopoDS_Shape disc =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -10), gp::DZ()), 25, 10).Shape();
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2(gp::Origin(), gp::DY()), 12, 3).Shape();
  const TopoDS_Shape half = cut(ring, block({-60, -60, -60}, {60, 60, 0}));
  return to_model(BRepAlgoAPI_Fuse(disc, half).Shape());
}

Model hollow_box() {
  return to_model(cut(block({-30, -25, -20}, {30, 25, 20}), block({-16, -12, -9}, {16, 12, 9})));
}

Model box_with_ball_void() {
  return to_model(cut(block({-30, -25, -20}, {30, 25, 20}), BRepPrimAPI_MakeSphere(9).Shape()));
}

Model mitred_tube() {
  return to_model(cut(mitred_bar(6, 40), mitred_bar(3, 41)));
}

Model dovetail() {
  const TopoDS_Wire slot = polygon({{30, -1, 20}, {26.5, -1, 10}, {53.5, -1, 10}, {50, -1, 20}});
  const TopoDS_Shape tool =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(slot).Face(), gp_Vec(0, 42, 0)).Shape();
  return to_model(cut(block({0, 0, 0}, {80, 40, 20}), tool));
}

Model block_with_returning_hole() {
  const std::vector<std::pair<double, double>> path = {{-24, 0}, {-24, 30}, {-12, 48}, {0, 35},
                                                       {12, 22}, {24, 40},  {24, 70}};
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i)
    points->SetValue(static_cast<int>(i) + 1, gp_Pnt(path[i].first, 0, path[i].second));
  GeomAPI_Interpolate spine(points, false, 1e-6);
  spine.Load(gp_Vec(0, 0, 1), gp_Vec(0, 0, 1));
  spine.Perform();
  const TopoDS_Wire wire =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spine.Curve()).Edge()).Wire();
  BRepOffsetAPI_MakePipeShell pipe(wire);
  pipe.Add(
      BRepBuilderAPI_MakeWire(
          BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(-24, 0, 0), gp_Dir(0, 0, 1)), 3)).Edge())
          .Wire());
  pipe.Build();
  pipe.MakeSolid();
  return to_model(cut(block({-45, -25, 0}, {45, 25, 70}), pipe.Shape()));
}

Model slanted_block() {
  const TopoDS_Wire outline =
      polygon({{0, 0, 0}, {40, 0, 0}, {40, 0, 20}, {25, 0, 35}, {0, 0, 35}});
  return to_model(
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline).Face(), gp_Vec(0, 30, 0)).Shape());
}

Model notched_pyramid() {
  const TopoDS_Shape pyramid = BRepPrimAPI_MakeWedge(16, 36, 18, 16, 9, 16, 9).Shape();
  return to_model(BRepAlgoAPI_Cut(pyramid, block({-1, 18, -1}, {12, 26, 19})).Shape());
}

Model open_box() {
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  builder.MakeShell(shell);
  builder.MakeSolid(solid);
  const TopoDS_Shape box = block({0, 0, 0}, {1, 2, 3});
  int n = 0;
  for (TopExp_Explorer faces(box, TopAbs_FACE); faces.More(); faces.Next())
    if (n++ > 0) builder.Add(shell, faces.Current());
  builder.Add(solid, shell);
  return to_model(solid);
}

Model terraces(const std::vector<std::vector<double>>& heights) {
  TopoDS_Shape shape;
  for (std::size_t i = 0; i < heights.size(); ++i)
    for (std::size_t j = 0; j < heights[i].size(); ++j) {
      const TopoDS_Shape column =
          block(gp_Pnt(10.0 * i, 10.0 * j, 0), gp_Pnt(10.0 * i + 10, 10.0 * j + 10, heights[i][j]));
      shape = shape.IsNull() ? column : BRepAlgoAPI_Fuse(shape, column).Shape();
    }
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  return to_model(unify.Shape());
}

Model quartered_box() {
  BOPAlgo_Builder builder;
  builder.AddArgument(block({-30, -30, 0}, {30, 30, 36}));
  for (double z : {0.0, 36.0}) {
    builder.AddArgument(line({0, -30, z}, {0, 30, z}));
    builder.AddArgument(line({-30, 0, z}, {30, 0, z}));
  }
  builder.Perform();
  return to_model(builder.Shape());
}

}  // namespace sweepmesh::test
