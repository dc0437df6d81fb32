// Read-only view of one solid of an OpenCASCADE shape: the one place that knows OpenCASCADE.
//
// Numbers are those of FreeCAD: FaceId{6} is "Face7", the seventh entry of TopExp::MapShapes over
// the whole shape, whichever solid is looked at. A degenerate edge (the pole of a sphere) has a
// number there too, but no EdgeId is ever handed out for it.
//
// Faces are oriented by the solid: normals point out of the material, and the loops run with the
// material's face on their left when seen from outside (outer loop counterclockwise, holes
// clockwise). Parameters (u,v) are right-handed seen from outside, that is du x dv points out of
// the material: for a face that OpenCASCADE holds reversed, u and v are swapped. So loops are
// counterclockwise in (u,v) too.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"
#include "sweepmesh/base/tolerances.h"

namespace sweepmesh {

/// One use of an edge by a loop of a face.
struct Coedge {
  EdgeId edge;  ///< invalid for a degenerate edge (a pole), which has no length
  FaceId face;
  bool reversed = false;  ///< the loop runs from the edge's end to its start
  bool seam = false;      ///< the face uses the edge twice (a cylinder's seam)
  VertexId start, end;    ///< in the direction of the loop; equal for a closed edge
  int slot = -1;          ///< internal: which parameter curve this is
};

/// A closed chain of coedges: coedge i ends where coedge i + 1 starts. Loop 0 of a face is the
/// outer.
using Loop = std::vector<Coedge>;

class Model {
 public:
  /// Reads .step/.stp/.brep/.brp/.iges/.igs. Throws InputError (no such file, unreadable, no
  /// solid...).
  static Model from_file(const std::string& path, int solid = 0);
  /// From text in OpenCASCADE's BREP format (FreeCAD's `Shape.exportBrepToString()`).
  static Model from_brep(const std::string& text, int solid = 0);

  /// The same shape seen from another of its solids, 0 <= solid < n_solids(). Throws InputError.
  Model of_solid(int solid) const;

  /// Of the whole shape.
  int n_solids() const;
  int n_faces() const;
  int n_edges() const;
  int n_vertices() const;
  /// The entities of this model's solid, ascending.
  const std::vector<FaceId>& faces() const;
  const std::vector<EdgeId>& edges() const;
  const std::vector<VertexId>& vertices() const;

  const Tolerances& tolerances() const;
  /// Corners of the bounding box: lowest, highest.
  std::pair<Point3, Point3> bounding_box() const;
  double volume() const;
  /// The number of closed shells that bound the solid (one plus its voids).
  int n_shells() const;

  const std::vector<Loop>& loops(FaceId) const;
  /// The coedges of an edge, on this solid's faces: two, both of one face for a seam.
  const std::vector<Coedge>& coedges(EdgeId) const;
  /// The other side of an edge seen from one of its coedges.
  const Coedge& partner(const Coedge&) const;
  /// Edges (not degenerate) that meet at a vertex, ascending, a closed edge once.
  const std::vector<EdgeId>& edges_at(VertexId) const;

  Point3 point(VertexId) const;
  VertexId start(EdgeId) const;
  VertexId end(EdgeId) const;
  double length(EdgeId) const;
  /// Parameter range of the edge's curve, first < last, from start to end.
  std::pair<double, double> range(EdgeId) const;
  Point3 point(EdgeId, double t) const;
  Point3 tangent(EdgeId, double t) const;  ///< unit, towards the end
  /// Curve parameters at the given fractions (0..1) of the edge's length, from its start.
  std::vector<double> at_length_fractions(EdgeId, const std::vector<double>& fractions) const;

  Point3 point(FaceId, const Point2& uv) const;
  Point3 normal(FaceId, const Point2& uv) const;  ///< unit, out of the solid; zero at a singularity
  /// d/du and d/dv as columns.
  Eigen::Matrix<double, 3, 2> derivatives(FaceId, const Point2& uv) const;
  bool is_planar(FaceId) const;
  double area(FaceId) const;
  /// Periods in u and v of the face's surface, 0 where it is not periodic.
  Point2 periods(FaceId) const;
  /// Lowest and highest (u,v) of the face.
  std::pair<Point2, Point2> uv_bounds(FaceId) const;
  /// Parameters of a coedge's point on its face (unwrapped: each seam coedge gives its own side).
  /// For a degenerate coedge `t` runs over its own range (range(const Coedge&)).
  Point2 uv(const Coedge&, double t) const;
  std::pair<double, double> range(const Coedge&) const;
  /// Parameters of the face's point closest to `p`, within the surface (not trimmed).
  Point2 project(FaceId, const Point3& p) const;
  /// Parameter of the edge's point closest to `p`.
  double project(EdgeId, const Point3& p) const;
  /// Distance of a point to the trimmed face, edge.
  double distance(FaceId, const Point3& p) const;
  double distance(EdgeId, const Point3& p) const;
  /// The face nearest to a point (the lowest number of those equally near).
  FaceId nearest_face(const Point3& p) const;

  /// Interior angle of the face where `coedge` of a loop ends and the next starts, in 0..2 pi,
  /// measured in the tangent plane. `loop` and `i` as in loops(face)[loop][i]. Degenerate
  /// neighbours are skipped.
  double interior_angle(FaceId face, int loop, int i) const;
  /// Angle through the material between the edge's two faces, in 0..2 pi, at a fraction of its
  /// length: pi where they are tangent, below pi for a convex edge. Pi for a seam.
  double dihedral(EdgeId, double fraction = 0.5) const;

  struct Impl;
  const Impl& impl() const { return *impl_; }  ///< for model/ itself

 private:
  friend struct DividedModel divide_model(const Model& model,
                                          const std::vector<struct FaceCut>& cuts);
  explicit Model(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace sweepmesh
