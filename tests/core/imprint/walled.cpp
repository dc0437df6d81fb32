#include "walled.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "to_model.h"

namespace sweepmesh::test {
namespace {

const gp_Pnt origin(0, 0, 0);
const gp_Dir up(0, 0, 1);

TopoDS_Shape ball(double radius) {
  return BRepPrimAPI_MakeSphere(radius).Shape();
}

TopoDS_Shape block(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(gp_Pnt(-x / 2, -y / 2, -z / 2), x, y, z).Shape();
}

TopoDS_Shape rod(double radius, double length, double z, const gp_Dir& along = up) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, z), along), radius, length).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, double angle, const gp_Dir& axis = up) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(origin, axis), angle);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& by) {
  gp_Trsf move;
  move.SetTranslation(by);
  return BRepBuilderAPI_Transform(shape, move, true).Shape();
}

TopoDS_Shape placed(const TopoDS_Shape& shape, double angle, double scale) {
  gp_Trsf factor;
  factor.SetScale(origin, scale);
  return BRepBuilderAPI_Transform(turned(shape, angle, gp_Dir(1, 2, -0.5)), factor, true).Shape();
}

TopoDS_Shape tee(double main, double branch) {
  return BRepAlgoAPI_Fuse(rod(main, 80, -40), rod(branch, 45, 0, gp_Dir(0, 1, 0))).Shape();
}

double distance(const TopoDS_Shape& body, const Point3& p) {
  double least = 1e300;
  for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next())
    least =
        std::min(least, BRepExtrema_DistShapeShape(
                            face.Current(), BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())))
                            .Value());
  return least;
}

/// Whether all edges of a face lie on the skin of a body.
bool lies_on(const Model& model, FaceId face, const TopoDS_Shape& body) {
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid()) continue;
      const auto [first, last] = model.range(c.edge);
      if (distance(body, model.point(c.edge, 0.3 * first + 0.7 * last)) >
          10 * model.tolerances().point)
        return false;
    }
  return true;
}

struct Bodies {
  std::string name;
  TopoDS_Shape outer, inner;
  int euler;
};

/// `has_ends`: flat faces lead from skin to skin.
Walled walled(const Bodies& b, bool has_ends, double angle, double scale) {
  const TopoDS_Shape outer = placed(b.outer, angle, scale), inner = placed(b.inner, angle, scale);
  Walled out{b.name, to_model(BRepAlgoAPI_Cut(outer, inner).Shape()), {}, b.euler};
  for (const FaceId f : out.model.faces()) {
    if (has_ends && out.model.is_planar(f)) continue;
    const bool on_outer = lies_on(out.model, f, outer), on_inner = lies_on(out.model, f, inner);
    if (on_outer == on_inner) continue;
    (on_outer ? out.picks.sources : out.picks.targets).push_back(f);
  }
  return out;
}

}  // namespace

std::vector<Walled> walled_solids(double angle, double scale) {
  const gp_Dir oblique(0.2, 0.3, 1);
  std::vector<Walled> out;
  for (const Bodies& b : std::initializer_list<Bodies>{
           {"ball_in_ball", ball(24), ball(12), 2},
           {"ball_off_centre", ball(24), moved(turned(ball(12), 1.2, oblique), gp_Vec(3, 2, 1)), 2},
           {"box_in_box", block(60, 50, 40), block(32, 24, 18), 2},
           {"turned_box_in_box", block(60, 50, 40), turned(block(32, 24, 18), 0.35, oblique), 2},
           {"torus", BRepPrimAPI_MakeTorus(40, 14).Shape(), BRepPrimAPI_MakeTorus(40, 8).Shape(),
            0},
           {"can", rod(20, 60, 0), turned(rod(12, 40, 10), 0.9), 2},
           {"ball_in_box", block(50, 46, 40), ball(12), 2},
           {"box_in_ball", ball(30), block(24, 20, 18), 2},
           {"can_in_ball", ball(30), rod(12, 24, -12), 2}})
    out.push_back(walled(b, false, angle, scale));
  for (const Bodies& b : std::initializer_list<Bodies>{
           {"tube", rod(20, 60, 0), rod(12, 60, 0), 0},
           {"tube_with_turned_seam", rod(20, 60, 0), turned(rod(12, 60, 0), 0.9), 0},
           {"tee", tee(20, 12), tee(14, 7), -1}})
    out.push_back(walled(b, true, angle, scale));
  return out;
}

Walled box_with_can_void() {
  return walled({"box_with_can_void", block(50, 46, 40), rod(12, 20, -10), 2}, false, 0.0, 1.0);
}

}  // namespace sweepmesh::test
