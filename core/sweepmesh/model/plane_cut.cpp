#include "sweepmesh/model/plane_cut.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
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

/// The one face of a shell that is a whole sphere; null where the shell is something else.
TopoDS_Face whole_sphere(const TopoDS_Shape& shell) {
  TopExp_Explorer faces(shell, TopAbs_FACE);
  const TopoDS_Face face = TopoDS::Face(faces.Current());
  faces.Next();
  const BRepAdaptor_Surface surface(face, false);
  if (faces.More() || surface.GetType() != GeomAbs_Sphere) return {};
  GProp_GProps area;
  BRepGProp::SurfaceProperties(face, area);
  constexpr double rounding = 1e-6;
  const double whole = surface.Sphere().Area();
  return std::abs(area.Mass() - whole) < rounding * whole ? face : TopoDS_Face();
}

/// Where the poles of a whole sphere are says nothing of the solid. Turned towards the plane's
/// normal they lie in the middle of what the plane leaves of the sphere, and not on its rim.
TopoDS_Solid with_poles_across(const TopoDS_Solid& solid, const gp_Dir& normal) {
  BRep_Builder builder;
  TopoDS_Solid out;
  builder.MakeSolid(out);
  for (TopExp_Explorer it(solid, TopAbs_SHELL); it.More(); it.Next()) {
    const TopoDS_Face face = whole_sphere(it.Current());
    if (face.IsNull()) {
      builder.Add(out, it.Current());
      continue;
    }
    const gp_Sphere sphere = BRepAdaptor_Surface(face, false).Sphere();
    BRepPrimAPI_MakeSphere made(gp_Ax2(sphere.Location(), normal), sphere.Radius());
    const bool is_void = (face.Orientation() == TopAbs_REVERSED) == sphere.Direct();
    const TopoDS_Shape shell = made.Shell();
    builder.Add(out, is_void ? shell.Reversed() : shell);
  }
  return out;
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
  constexpr double rounding = 1e-4;  // volumes are integrals over curved faces
  double sum = 0.0;
  for (const Model& piece : pieces) sum += piece.volume();
  return std::abs(sum - whole.volume()) <= rounding * whole.volume();
}

CutPieces pieces_of(const Model& model, const TopoDS_Solid& solid, const Plane& plane) {
  const gp_Dir normal(plane.normal.x(), plane.normal.y(), plane.normal.z());
  const TopoDS_Shape shape = split(with_poles_across(solid, normal), large_face(model, plane));
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
