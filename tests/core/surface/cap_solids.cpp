#include "cap_solids.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>
#include <stdexcept>

#include "to_model.h"

namespace sweepmesh::test {
namespace {

constexpr double pi = std::numbers::pi;

gp_Ax2 upwards(double x, double y, double z) {
  return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)};
}

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(upwards(x, y, z), radius, height).Shape();
}

/// A cylinder of radius 10 whose top is the cap of a ball of the given radius.
TopoDS_Shape domed(double ball) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(upwards(0, 0, 0), ball).Shape();
  return BRepAlgoAPI_Common(cylinder(0, 0, 0, 10, 2 * ball), sphere).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return BRepAlgoAPI_Cut(a, b).Shape();
}

TopoDS_Shape square_to_circle() {
  BRepBuilderAPI_MakePolygon square;
  for (const auto& [x, y] : {std::pair{-8., -8.}, {8., -8.}, {8., 8.}, {-8., 8.}})
    square.Add(gp_Pnt(x, y, 0));
  square.Close();
  BRepBuilderAPI_MakeWire circle;
  for (int i = 0; i < 4; ++i)
    circle.Add(BRepBuilderAPI_MakeEdge(gp_Circ(upwards(0, 0, 15), 7), (2 * i - 3) * pi / 4,
                                       (2 * i - 1) * pi / 4)
                   .Edge());
  BRepOffsetAPI_ThruSections loft(true, true);
  loft.CheckCompatibility(false);
  loft.AddWire(square.Wire());
  loft.AddWire(circle.Wire());
  return loft.Shape();
}

}  // namespace

CurvedSolid curved_solid(const std::string& name) {
  const auto solid = [&](const TopoDS_Shape& shape, double size) {
    return CurvedSolid{name, to_model(shape), size};
  };
  if (name == "dome") return solid(domed(12), 2.0);
  if (name == "flat_dome") return solid(domed(14), 2.0);
  if (name == "dome_drilled_at_its_pole")
    return solid(cut(domed(12), cylinder(0, 0, -1, 4, 30)), 2.0);
  if (name == "dome_drilled_aside") return solid(cut(domed(12), cylinder(4, 1, -1, 3, 30)), 1.5);
  if (name == "bowl")
    return solid(
        cut(cylinder(0, 0, 0, 12, 20), BRepPrimAPI_MakeSphere(upwards(0, 0, 24), 11).Shape()), 2.0);
  if (name == "cone") return solid(BRepPrimAPI_MakeCone(8, 0, 12).Shape(), 2.0);
  if (name == "frustum") return solid(BRepPrimAPI_MakeCone(8, 5, 9).Shape(), 2.0);
  if (name == "octant") return solid(BRepPrimAPI_MakeSphere(10, 0, pi / 2, pi / 2).Shape(), 1.8);
  if (name == "zone") return solid(BRepPrimAPI_MakeSphere(10, -0.6, 0.7).Shape(), 2.0);
  if (name == "bend") return solid(BRepPrimAPI_MakeTorus(20, 5, pi / 2).Shape(), 2.5);
  if (name == "wedge") return solid(BRepPrimAPI_MakeCylinder(10, 12, 2.0).Shape(), 2.0);
  if (name == "square_to_circle") return solid(square_to_circle(), 2.0);
  throw std::invalid_argument(name);
}

EdgeRows edge_rows(const Model& model, double size) {
  EdgeRows out{std::vector<std::vector<NodeId>>(model.n_edges()),
               std::vector<std::vector<double>>(model.n_edges())};
  int next = model.n_vertices();
  for (const EdgeId e : model.edges()) {
    const int n = std::max(2, 2 * static_cast<int>(std::lround(0.5 * model.length(e) / size)));
    std::vector<double> fractions;
    for (int i = 0; i <= n; ++i) fractions.push_back(static_cast<double>(i) / n);
    out.t[e.index] = model.at_length_fractions(e, fractions);
    auto& nodes = out.nodes[e.index];
    nodes.push_back(NodeId{model.start(e).index});
    for (int i = 1; i < n; ++i) nodes.push_back(NodeId{next++});
    nodes.push_back(NodeId{model.end(e).index});
  }
  return out;
}

}  // namespace sweepmesh::test
