// Internal to model/: the OpenCASCADE side of Model. Included by the .cpp files of this folder
// only.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>
#include <vector>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// One face with its surface. Parameters are right-handed seen from outside the solid: of a face
/// that OpenCASCADE holds reversed, u and v are swapped (`swapped`), so du x dv always points
/// outwards.
struct FaceRecord {
  TopoDS_Face face;  // oriented FORWARD
  bool swapped = false;
  BRepAdaptor_Surface surface;  // untrimmed
  /// Looks for nearest points. It keeps the grid of points where a search begins, which costs far
  /// more than the search; made when first asked for.
  mutable opencascade::handle<ShapeAnalysis_Surface> nearest;
  std::vector<Loop> loops;
};

struct EdgeRecord {
  BRepAdaptor_Curve curve;
  double first = 0, last = 0, length = 0;
  VertexId start, end;
  std::vector<Coedge> coedges;
};

struct Model::Impl {
  TopoDS_Shape shape;
  TopoDS_Solid solid;
  int n_solids = 0;
  int n_shells = 0;
  TopTools_IndexedMapOfShape face_map, edge_map, vertex_map;  // of the whole shape, from 1
  std::vector<FaceId> face_ids;
  std::vector<EdgeId> edge_ids;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceRecord> faces;  // by FaceId; empty records for other solids' faces
  std::vector<EdgeRecord> edges;
  std::vector<Point3> vertex_points;
  std::vector<std::vector<EdgeId>> edges_at_vertex;
  std::vector<Geom2dAdaptor_Curve> pcurves;  // by Coedge::slot
  std::pair<Point3, Point3> box;
  double volume = 0;
  Tolerances tolerances;
};

inline Point3 to_point(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}
inline Point3 to_vector(const gp_Vec& v) {
  return {v.X(), v.Y(), v.Z()};
}
inline gp_Pnt to_gp(const Point3& p) {
  return {p.x(), p.y(), p.z()};
}

/// Runs `f` and turns OpenCASCADE's exceptions into InputError: `what` begins the sentence.
template <class F>
auto translated(const std::string& what, F&& f) {
  try {
    return f();
  } catch (const Standard_Failure& failure) {
    throw InputError("read", what + ": OpenCASCADE says " + failure.GetMessageString() + ".");
  }
}

/// Reads a file or text into a shape; throws InputError (read.cpp).
TopoDS_Shape read_shape_file(const std::string& path);
TopoDS_Shape read_brep_text(const std::string& text);

/// Builds all records of one solid of the shape; throws InputError (topology.cpp).
std::shared_ptr<const Model::Impl> make_impl(const TopoDS_Shape& shape, int solid);

}  // namespace sweepmesh
