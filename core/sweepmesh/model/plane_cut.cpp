#include "sweepmesh/model/plane_cut.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <sstream>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

TopoDS_Face large_face(const Model& model, const Plane& plane) {
  const auto [low, high] = model.bounding_box();
  const double reach = 2.0 * (high - low).norm();
  const Point3 middle = (low + high) / 2;
  const Point3 foot = middle - (middle - plane.point).dot(plane.normal) * plane.normal;
  const gp_Dir normal(plane.normal.x(), plane.normal.y(), plane.normal.z());
  return BRepBuilderAPI_MakeFace(gp_Pln(to_gp(foot), normal), -reach, reach, -reach, reach).Face();
}

TopoDS_Shape split(const TopoDS_Solid& solid, const TopoDS_Face& tool) {
  TopTools_ListOfShape solids, tools;
  solids.Append(solid);
  tools.Append(tool);
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(solids);
  splitter.SetTools(tools);
  splitter.SetNonDestructive(true);
  splitter.Build();
  return splitter.HasErrors() ? TopoDS_Shape() : splitter.Shape();
}

std::string text_of(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

bool adds_up(const Model& whole, const std::vector<Model>& pieces) {
  constexpr double rounding = 1e-6;
  double sum = 0.0;
  for (const Model& piece : pieces) sum += piece.volume();
  return std::abs(sum - whole.volume()) <= rounding * whole.volume();
}

CutPieces pieces_of(const Model& model, const TopoDS_Solid& solid, const Plane& plane) {
  const TopoDS_Shape shape = split(solid, large_face(model, plane));
  if (shape.IsNull()) return {};
  CutPieces out;
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
    if (!BRepCheck_Analyzer(it.Current()).IsValid()) return {};
    builder.Add(all, it.Current());
    out.pieces.push_back(Model::from_brep(text_of(it.Current())));
  }
  if (out.pieces.size() < 2 || !adds_up(model, out.pieces)) return {};
  out.shape = text_of(all);
  return out;
}

}  // namespace

Plane plane_of(const Model& model, FaceId face) {
  const auto [low, high] = model.uv_bounds(face);
  return {model.point(face, Point2(low)), model.normal(face, (low + high) / 2)};
}

CutPieces cut_by_plane(const Model& model, const Plane& plane) try {
  return translated("The solid cannot be cut",
                    [&] { return pieces_of(model, model.impl().solid, plane); });
} catch (const InputError&) {
  return {};  // the pieces are not what can be read, or OpenCASCADE gave up
}

}  // namespace sweepmesh
