// Solids made in code for the tests of intervals and linking faces.
#pragma once

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh::testing {

inline Model model_of(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return Model::from_brep(text.str());
}

inline TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

inline TopoDS_Wire wire_of(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& p : points) polygon.Add(p);
  polygon.Close();
  return polygon.Wire();
}

/// A plane face with holes, moved along a vector: the outer loop first, all in the same sense.
inline TopoDS_Shape prism(const std::vector<std::vector<gp_Pnt>>& loops, const gp_Vec& along) {
  BRepBuilderAPI_MakeFace face(wire_of(loops[0]), true);
  for (std::size_t l = 1; l < loops.size(); ++l) {
    TopoDS_Wire hole = wire_of(loops[l]);
    hole.Reverse();
    face.Add(hole);
  }
  return BRepPrimAPI_MakePrism(face.Face(), along).Shape();
}

/// An upright prism over a regular polygon.
inline TopoDS_Shape regular_prism(int n_sides, double radius, double height) {
  std::vector<gp_Pnt> points;
  for (int s = 0; s < n_sides; ++s) {
    const double a = 2.0 * M_PI * s / n_sides;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.0);
  }
  return prism({points}, gp_Vec(0, 0, height));
}

/// The faces whose normal at the middle of their (u,v) box has a z component above the bound in
/// absolute value, by its sign.
inline std::vector<FaceId> faces_facing(const Model& model, double sign, double bound = 0.7) {
  std::vector<FaceId> out;
  for (const FaceId f : model.faces()) {
    const auto [low, high] = model.uv_bounds(f);
    if (sign * model.normal(f, 0.5 * (low + high)).z() > bound) out.push_back(f);
  }
  return out;
}

}  // namespace sweepmesh::testing
