#include "solids.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

#include "to_model.h"

namespace sweepmesh::test {
namespace {

constexpr double pi = std::numbers::pi;

TopoDS_Wire polygon(const std::vector<Point2>& points, double z = 0) {
  BRepBuilderAPI_MakePolygon wire;
  for (const Point2& p : points) wire.Add(gp_Pnt(p.x(), p.y(), z));
  wire.Close();
  return wire.Wire();
}

TopoDS_Shape extruded(const std::vector<Point2>& outline, double height) {
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon(outline)).Face(),
                               gp_Vec(0, 0, height))
      .Shape();
}

TopoDS_Shape block(const Point3& low, const Point3& high) {
  return BRepPrimAPI_MakeBox(gp_Pnt(low.x(), low.y(), low.z()),
                             gp_Pnt(high.x(), high.y(), high.z()))
      .Shape();
}

TopoDS_Shape cylinder(const Point3& foot, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(foot.x(), foot.y(), foot.z()), gp_Dir(0, 0, 1)),
                                  radius, height)
      .Shape();
}

TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts) {
  BRep_Builder builder;
  TopoDS_Compound out;
  builder.MakeCompound(out);
  for (const TopoDS_Shape& part : parts) builder.Add(out, part);
  return out;
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(a, b).Shape());
  unify.Build();
  return unify.Shape();
}

std::vector<Point2> regular(int n, double radius, double turn = 0) {
  std::vector<Point2> points;
  for (int i = 0; i < n; ++i) {
    const double a = turn + 2 * pi * i / n;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return points;
}

TopoDS_Wire circle(double radius, double z) {
  const gp_Circ c(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), radius);
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < 4; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(c, i * pi / 2 + pi / 4, (i + 1) * pi / 2 + pi / 4).Edge());
  return wire.Wire();
}

TopoDS_Shape loft(const std::vector<TopoDS_Wire>& wires) {
  BRepOffsetAPI_ThruSections sections(true, wires.size() == 2);
  sections.CheckCompatibility(false);
  for (const TopoDS_Wire& wire : wires) sections.AddWire(wire);
  return sections.Shape();
}

}  // namespace

Model box(double x, double y, double z) {
  return to_model(block({0, 0, 0}, {x, y, z}));
}

Model two_boxes(double gap) {
  return to_model(
      compound({block({0, 0, 0}, {10, 10, 10}), block({10 + gap, 0, 0}, {20 + gap, 10, 10})}));
}

Model boxes_touching_in_part() {
  return to_model(compound({block({0, 0, 0}, {10, 10, 10}), block({10, 5, 0}, {20, 15, 10})}));
}

Model box_and_ball() {
  const gp_Pnt centre(30, 0, 0);
  return to_model(
      compound({block({0, 0, 0}, {10, 10, 10}), BRepPrimAPI_MakeSphere(centre, 5).Shape()}));
}

std::vector<NamedModel> prisms() {
  const TopoDS_Shape plate = block({0, 0, 0}, {60, 40, 8});
  TopoDS_Shape drilled = cut(plate, cylinder({12, 12, -1}, 5, 10));
  drilled = cut(drilled, cylinder({40, 24, -1}, 8, 10));
  drilled = cut(drilled, block({10, 24, -1}, {22, 34, 10}));
  return {{"square", box(10, 10, 14)},
          {"L", to_model(extruded({{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}}, 15))},
          {"hexagon", to_model(extruded(regular(6, 10), 12))},
          {"disc", to_model(cylinder({0, 0, 0}, 10, 12))},
          {"ring", to_model(cut(cylinder({0, 0, 0}, 10, 12), cylinder({0, 0, -1}, 5, 14)))},
          {"drilled plate", to_model(drilled)}};
}

std::vector<NamedModel> general_one_to_one() {
  std::vector<TopoDS_Wire> twisted;
  for (int i = 0; i <= 4; ++i) twisted.push_back(polygon(regular(4, 10, pi / 4 * i / 4), 5.0 * i));
  return {{"frustum", to_model(BRepPrimAPI_MakeCone(10, 6, 15).Shape())},
          {"bend", to_model(BRepPrimAPI_MakeTorus(30, 6, pi / 2).Shape())},
          {"tapered box", to_model(loft({polygon(regular(4, 10)), polygon(regular(4, 6), 12)}))},
          {"twisted prism", to_model(loft(twisted))},
          {"square to circle", to_model(loft({polygon(regular(4, 10, pi / 4)), circle(7, 15)}))}};
}

std::vector<NamedModel> many_to_one() {
  const TopoDS_Shape base = block({0, 0, 0}, {40, 30, 10});
  const TopoDS_Shape boss = fused(base, cylinder({20, 15, 10}, 8, 12));
  return {
      {"step", to_model(extruded({{0, 0}, {30, 0}, {30, 10}, {15, 10}, {15, 20}, {0, 20}}, 12))},
      {"boss on a plate", to_model(boss)},
      {"blind hole", to_model(cut(base, cylinder({20, 15, 4}, 8, 12)))}};
}

std::vector<NamedModel> drilled_across() {
  const auto drill = [](const Point3& foot, const gp_Dir& way, double radius, double depth) {
    const gp_Ax2 axis(gp_Pnt(foot.x(), foot.y(), foot.z()), way);
    return BRepPrimAPI_MakeCylinder(axis, radius, depth).Shape();
  };
  const auto without = [](TopoDS_Shape shape, const std::vector<TopoDS_Shape>& drills) {
    for (const TopoDS_Shape& tool : drills) shape = BRepAlgoAPI_Cut(shape, tool).Shape();
    return to_model(shape);
  };
  const gp_Dir x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const TopoDS_Shape brick = block({0, 0, 0}, {60, 40, 50}), upright = drill({8, 20, 0}, z, 4, 50);
  return {
      {"three axes", without(brick, {drill({20, 0, 15}, y, 7, 40), drill({0, 20, 36}, x, 7, 60),
                                     drill({45, 33, 0}, z, 4, 50)})},
      {"shaft", without(cylinder({0, 0, 0}, 20, 80), {drill({-30, 0, 40}, x, 8, 60)})},
      {"stepped hole",
       without(brick, {upright, drill({32, 0, 25}, y, 6, 40), drill({32, 0, 25}, y, 10, 12)})},
      {"blind hole", without(brick, {upright, drill({32, 0, 25}, y, 9, 20)})},
  };
}

std::vector<NamedModel> unsweepable() {
  return {{"ball", to_model(BRepPrimAPI_MakeSphere(10).Shape())},
          {"ring torus", to_model(BRepPrimAPI_MakeTorus(20, 5).Shape())},
          {"box with a ball cut out",
           to_model(cut(block({0, 0, 0}, {20, 20, 20}), BRepPrimAPI_MakeSphere(8).Shape()))}};
}

}  // namespace sweepmesh::test
