#include "sweepmesh/model/model.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

constexpr double pi = std::numbers::pi;

/// To the surface's own parameters from ours, and back (the swap is its own inverse).
Point2 swapped_if(const FaceRecord& face, const Point2& uv) {
  return face.swapped ? Point2(uv.y(), uv.x()) : uv;
}

double to_full_turn(double angle) {
  return angle < 0 ? angle + 2 * pi : angle;
}

double distance_to(const TopoDS_Shape& shape, const Point3& p) {
  const BRepExtrema_DistShapeShape extrema(BRepBuilderAPI_MakeVertex(to_gp(p)).Vertex(), shape);
  return extrema.IsDone() ? extrema.Value() : std::numeric_limits<double>::infinity();
}

}  // namespace

Model Model::from_file(const std::string& path, int solid) {
  return Model(make_impl(read_shape_file(path), solid));
}
Model Model::from_brep(const std::string& text, int solid) {
  return Model(make_impl(read_brep_text(text), solid));
}

Model Model::of_solid(int solid) const {
  return Model(make_impl(impl_->shape, solid));
}

int Model::n_solids() const {
  return impl_->n_solids;
}
int Model::n_faces() const {
  return impl_->face_map.Extent();
}
int Model::n_edges() const {
  return impl_->edge_map.Extent();
}
int Model::n_vertices() const {
  return impl_->vertex_map.Extent();
}
const std::vector<FaceId>& Model::faces() const {
  return impl_->face_ids;
}
const std::vector<EdgeId>& Model::edges() const {
  return impl_->edge_ids;
}
const std::vector<VertexId>& Model::vertices() const {
  return impl_->vertex_ids;
}
const Tolerances& Model::tolerances() const {
  return impl_->tolerances;
}
std::pair<Point3, Point3> Model::bounding_box() const {
  return impl_->box;
}
double Model::volume() const {
  return impl_->volume;
}
int Model::n_shells() const {
  return impl_->n_shells;
}
const std::vector<Loop>& Model::loops(FaceId f) const {
  return impl_->faces[f.index].loops;
}
const std::vector<Coedge>& Model::coedges(EdgeId e) const {
  return impl_->edges[e.index].coedges;
}

const Coedge& Model::partner(const Coedge& c) const {
  const auto& both = coedges(c.edge);
  return both[0].slot == c.slot ? both[1] : both[0];
}

const std::vector<EdgeId>& Model::edges_at(VertexId v) const {
  return impl_->edges_at_vertex[v.index];
}

Point3 Model::point(VertexId v) const {
  return impl_->vertex_points[v.index];
}
VertexId Model::start(EdgeId e) const {
  return impl_->edges[e.index].start;
}
VertexId Model::end(EdgeId e) const {
  return impl_->edges[e.index].end;
}
double Model::length(EdgeId e) const {
  return impl_->edges[e.index].length;
}

std::pair<double, double> Model::range(EdgeId e) const {
  return {impl_->edges[e.index].first, impl_->edges[e.index].last};
}

Point3 Model::point(EdgeId e, double t) const {
  return to_point(impl_->edges[e.index].curve.Value(t));
}

Point3 Model::tangent(EdgeId e, double t) const {
  const EdgeRecord& edge = impl_->edges[e.index];
  gp_Pnt p;
  gp_Vec d;
  edge.curve.D1(t, p, d);
  if (d.Magnitude() * (edge.last - edge.first) > impl_->tolerances.relative * edge.length)
    return to_vector(d).normalized();
  // A curve may stand still at its end (coinciding control points): take a short chord instead.
  const double step = 1e-4 * (edge.last - edge.first);
  const double a = std::max(edge.first, t - step), b = std::min(edge.last, t + step);
  return (point(e, b) - point(e, a)).normalized();
}

std::vector<double> Model::at_length_fractions(EdgeId e,
                                               const std::vector<double>& fractions) const {
  const EdgeRecord& edge = impl_->edges[e.index];
  return translated("The length of " + name_of(e) + " cannot be divided", [&] {
    std::vector<double> parameters;
    double done = 0, t = edge.first;
    for (const double fraction : fractions) {
      if (fraction >= 1) {
        t = edge.last;
      } else if (fraction > done) {
        const GCPnts_AbscissaPoint next(edge.curve, (fraction - done) * edge.length, t);
        t = std::clamp(next.Parameter(), edge.first, edge.last);
      }
      done = fraction;
      parameters.push_back(t);
    }
    return parameters;
  });
}

Point3 Model::point(FaceId f, const Point2& uv) const {
  const FaceRecord& face = impl_->faces[f.index];
  const Point2 own = swapped_if(face, uv);
  return to_point(face.surface.Value(own.x(), own.y()));
}

Eigen::Matrix<double, 3, 2> Model::derivatives(FaceId f, const Point2& uv) const {
  const FaceRecord& face = impl_->faces[f.index];
  const Point2 own = swapped_if(face, uv);
  gp_Pnt p;
  gp_Vec du, dv;
  face.surface.D1(own.x(), own.y(), p, du, dv);
  Eigen::Matrix<double, 3, 2> d;
  d.col(face.swapped ? 1 : 0) = to_vector(du);
  d.col(face.swapped ? 0 : 1) = to_vector(dv);
  return d;
}

Point3 Model::normal(FaceId f, const Point2& uv) const {
  const auto d = derivatives(f, uv);
  const Point3 n = d.col(0).cross(d.col(1));
  const double scale = d.col(0).norm() * d.col(1).norm();
  if (n.norm() <= impl_->tolerances.relative * scale || scale == 0) return Point3::Zero();
  return n.normalized();
}

bool Model::is_planar(FaceId f) const {
  return impl_->faces[f.index].surface.GetType() == GeomAbs_Plane;
}

double Model::area(FaceId f) const {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(impl_->faces[f.index].face, properties);
  return std::abs(properties.Mass());
}

Point2 Model::periods(FaceId f) const {
  const FaceRecord& face = impl_->faces[f.index];
  const BRepAdaptor_Surface& s = face.surface;
  return swapped_if(
      face, Point2(s.IsUPeriodic() ? s.UPeriod() : 0.0, s.IsVPeriodic() ? s.VPeriod() : 0.0));
}

std::pair<Point2, Point2> Model::uv_bounds(FaceId f) const {
  const FaceRecord& face = impl_->faces[f.index];
  Point2 low, high;
  BRepTools::UVBounds(face.face, low.x(), high.x(), low.y(), high.y());
  return {swapped_if(face, low), swapped_if(face, high)};
}

Point2 Model::uv(const Coedge& c, double t) const {
  const gp_Pnt2d p = impl_->pcurves[c.slot].Value(t);
  return swapped_if(impl_->faces[c.face.index], Point2(p.X(), p.Y()));
}

std::pair<double, double> Model::range(const Coedge& c) const {
  const Geom2dAdaptor_Curve& curve = impl_->pcurves[c.slot];
  return {curve.FirstParameter(), curve.LastParameter()};
}

Point2 Model::project(FaceId f, const Point3& p) const {
  const FaceRecord& face = impl_->faces[f.index];
  if (face.nearest.IsNull())
    face.nearest = new ShapeAnalysis_Surface(BRep_Tool::Surface(face.face));
  const gp_Pnt2d uv = face.nearest->ValueOfUV(to_gp(p), impl_->tolerances.point);
  return swapped_if(face, Point2(uv.X(), uv.Y()));
}

double Model::project(EdgeId e, const Point3& p) const {
  const EdgeRecord& edge = impl_->edges[e.index];
  // Closest of the ends and of the feet of perpendiculars inside the range.
  double best = edge.first;
  double best_distance = (point(e, edge.first) - p).norm();
  if (const double d = (point(e, edge.last) - p).norm(); d < best_distance)
    best = edge.last, best_distance = d;
  const Extrema_ExtPC feet(to_gp(p), edge.curve, impl_->tolerances.point);
  for (int i = 1; feet.IsDone() && i <= feet.NbExt(); ++i) {
    const double t = feet.Point(i).Parameter();
    const double d = std::sqrt(feet.SquareDistance(i));
    if (d < best_distance && t >= edge.first && t <= edge.last) best = t, best_distance = d;
  }
  return best;
}

double Model::distance(FaceId f, const Point3& p) const {
  return distance_to(impl_->face_map(f.index + 1), p);
}
double Model::distance(EdgeId e, const Point3& p) const {
  return distance_to(impl_->edge_map(e.index + 1), p);
}

FaceId Model::nearest_face(const Point3& p) const {
  FaceId best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const FaceId f : faces()) {
    const double d = distance(f, p);
    if (d < best_distance - impl_->tolerances.point) best = f, best_distance = d;
  }
  return best;
}

namespace {

/// Normal of a face at a coedge's parameter; next to a singularity (a pole) it is taken a little
/// inside the coedge instead.
Point3 normal_at(const Model& model, const Coedge& c, double t) {
  const auto [a, b] = model.range(c);
  for (const double step : {0.0, 1e-4, 1e-3, 1e-2}) {
    const double inside = t + step * ((a + b) / 2 - t);
    const Point3 n = model.normal(c.face, model.uv(c, inside));
    if (n.squaredNorm() > 0) return n;
  }
  return Point3::UnitZ();
}

/// Direction in which the loop runs at a coedge's start or end.
Point3 loop_tangent(const Model& model, const Coedge& c, bool at_start) {
  const auto [a, b] = model.range(c.edge);
  const Point3 t = model.tangent(c.edge, at_start != c.reversed ? a : b);
  return c.reversed ? Point3(-t) : t;
}

/// Direction of the chord to a point a little way along the coedge: tells a cusp of 0 from one of
/// 360.
Point3 loop_chord(const Model& model, const Coedge& c, bool at_start) {
  constexpr double part = 0.02;
  const auto [a, b] = model.range(c.edge);
  const bool low = at_start != c.reversed;
  const Point3 here = model.point(c.edge, low ? a : b);
  const Point3 there = model.point(c.edge, low ? a + part * (b - a) : b - part * (b - a));
  return at_start ? Point3(there - here) : Point3(here - there);
}

/// Angle counterclockwise about n from `out` to the opposite of `in`, in 0..2 pi.
double angle_between(const Point3& n, const Point3& in, const Point3& out) {
  return to_full_turn(std::atan2(n.dot(out.cross(-in)), out.dot(-in)));
}

}  // namespace

double Model::interior_angle(FaceId f, int loop, int i) const {
  const Loop& coedges = loops(f)[loop];
  const Coedge& in = coedges[i];
  const Coedge& out = coedges[(i + 1) % coedges.size()];
  // At a pole the corner exists in (u,v) alone, where the outline of a trimmed patch turns square.
  if (!in.edge.is_valid() || !out.edge.is_valid()) return pi / 2;
  const auto [a, b] = range(in.edge);
  const Point3 n = normal_at(*this, in, in.reversed ? a : b);
  const double angle =
      angle_between(n, loop_tangent(*this, in, false), loop_tangent(*this, out, true));
  const double cusp = 10 * impl_->tolerances.angle;
  if (angle > cusp && angle < 2 * pi - cusp) return angle;
  return angle_between(n, loop_chord(*this, in, false), loop_chord(*this, out, true));
}

double Model::dihedral(EdgeId e, double fraction) const {
  const Coedge& one = coedges(e)[0];
  const Coedge& two = coedges(e)[1];
  if (one.face == two.face && one.seam) return pi;
  const double t = at_length_fractions(e, {fraction}).front();
  Point3 along = tangent(e, t);
  if (one.reversed) along = -along;
  const Point3 n1 = normal_at(*this, one, t), n2 = normal_at(*this, two, t);
  const Point3 into1 = n1.cross(along), into2 = n2.cross(-along);
  return to_full_turn(std::atan2(into2.dot(-n1), into2.dot(into1)));
}

}  // namespace sweepmesh
