#include "terraces.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "sweepmesh/scheme/assess.h"
#include "to_model.h"

namespace sweepmesh::test {
namespace {

TopoDS_Shape prism(const Terrace& t) {
  BRepBuilderAPI_MakePolygon wire;
  for (const Point2& p : t.outline) wire.Add(gp_Pnt(p.x(), p.y(), t.low));
  wire.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                               gp_Vec(0, 0, t.high - t.low))
      .Shape();
}

TopoDS_Shape unified(const TopoDS_Shape& shape) {
  ShapeUpgrade_UnifySameDomain unify(shape, true, true, false);
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const Placement& p) {
  gp_Trsf turn, scale;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(p.axis.x(), p.axis.y(), p.axis.z())), p.angle);
  scale.SetScale(gp_Pnt(0, 0, 0), p.scale);
  return BRepBuilderAPI_Transform(shape, scale * turn, true).Shape();
}

}  // namespace

Model terraced(const std::vector<Terrace>& terraces, const std::vector<Terrace>& pockets,
               const Placement& placement) {
  TopoDS_Shape shape = prism(terraces.front());
  for (std::size_t i = 1; i < terraces.size(); ++i)
    shape = BRepAlgoAPI_Fuse(shape, prism(terraces[i])).Shape();
  for (const Terrace& t : pockets) shape = BRepAlgoAPI_Cut(shape, prism(t)).Shape();
  return to_model(placed(unified(shape), placement));
}

Model pocketed(double twist, double growth, const Placement& placement) {
  constexpr double floor = 16, top = 50;
  const auto outline = [&](double z) {
    const double share = (z - floor) / (top - floor);
    const double turn = share * twist, size = 1 + share * (growth - 1);
    BRepBuilderAPI_MakePolygon wire;
    for (const Point2& p : rectangle(-14 * size, -8 * size, 14 * size, 8 * size)) {
      const Point2 q = Eigen::Rotation2Dd(turn) * p;
      wire.Add(gp_Pnt(q.x(), q.y(), z));
    }
    wire.Close();
    return wire.Wire();
  };
  BRepOffsetAPI_ThruSections loft(true, true);
  loft.AddWire(outline(floor));
  loft.AddWire(outline(top));
  loft.AddWire(outline(top + 1));
  const TopoDS_Shape block = prism({rectangle(-30, -30, 30, 30), 0, top});
  return to_model(placed(BRepAlgoAPI_Cut(block, loft.Shape()).Shape(), placement));
}

std::vector<Point2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Point2> regular_polygon(const Point2& centre, double radius, int n, double angle) {
  std::vector<Point2> out;
  for (int i = 0; i < n; ++i) {
    const double a = angle + 2 * std::numbers::pi * i / n;
    out.emplace_back(centre + radius * Point2(std::cos(a), std::sin(a)));
  }
  return out;
}

std::vector<Terrace> random_terraces(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<Terrace> out = {{rectangle(0, 0, 60, 50), 0, 20}};
  const int n_up = 1 + static_cast<int>(random() % 2), n_down = 1 + static_cast<int>(random() % 2);
  for (int i = 0; i < n_up + n_down; ++i) {
    const double radius = between(8, 14);
    const Point2 centre(between(radius + 2, 58 - radius), between(radius + 2, 48 - radius));
    const auto outline =
        regular_polygon(centre, radius, 3 + static_cast<int>(random() % 5), between(0, 2));
    if (i < n_up)
      out.push_back({outline, 10, between(26, 40)});
    else
      out.push_back({outline, between(-20, -6), 10});
  }
  return out;
}

Scheme upright_scheme(const Model& model, const Placement& placement) {
  const Point3 up =
      Eigen::AngleAxisd(placement.angle, placement.axis.normalized()) * Point3::UnitZ();
  std::vector<FaceRole> roles(model.n_faces(), FaceRole::none);
  for (const FaceId f : model.faces()) {
    const auto [low, high] = model.uv_bounds(f);
    const double cosine = model.normal(f, 0.5 * (low + high)).dot(up);
    roles[f.index] = cosine > 0.9    ? FaceRole::source
                     : cosine < -0.9 ? FaceRole::target
                                     : FaceRole::linking;
  }
  Context context;
  const auto found = solve_scheme(model, roles, context);
  if (const auto* scheme = std::get_if<Scheme>(&found)) return *scheme;
  throw std::runtime_error(std::get<std::vector<Reason>>(found).front().text);
}

}  // namespace sweepmesh::test
