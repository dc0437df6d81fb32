#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <map>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

using Impl = Model::Impl;

TopoDS_Solid chosen_solid(const TopoDS_Shape& shape, int solid, int& n_solids) {
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  n_solids = solids.Extent();
  if (n_solids == 0) {
    const bool surface = TopExp_Explorer(shape, TopAbs_FACE).More();
    throw InputError("read", surface ? "The shape is a surface or an open shell, not a solid."
                                     : "The shape holds no solid, only edges or points.");
  }
  if (solid < 0 || solid >= n_solids)
    throw InputError("read", "The shape has " + std::to_string(n_solids) + " solids; number " +
                                 std::to_string(solid + 1) + " is not one of them.");
  return TopoDS::Solid(solids(solid + 1));
}

double signed_volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

std::pair<Point3, Point3> bounding_box(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  if (box.IsVoid()) throw InputError("read", "The solid is empty.");
  double a[3], b[3];
  box.Get(a[0], a[1], a[2], b[0], b[1], b[2]);
  return {Point3(a[0], a[1], a[2]), Point3(b[0], b[1], b[2])};
}

/// Fills the record of an edge (once; edges are shared by faces).
void add_edge(Impl& impl, const TopoDS_Edge& edge, EdgeId id) {
  EdgeRecord& record = impl.edges[id.index];
  if (record.start.is_valid()) return;
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  TopoDS_Vertex start, end;
  TopExp::Vertices(forward, start, end);
  if (start.IsNull() || end.IsNull())
    throw InputError("read", name_of(id) + " has no end.", {name_of(id)});
  record.curve.Initialize(forward);
  BRep_Tool::Range(forward, record.first, record.last);
  record.start = VertexId{impl.vertex_map.FindIndex(start) - 1};
  record.end = VertexId{impl.vertex_map.FindIndex(end) - 1};
  record.length = GCPnts_AbscissaPoint::Length(record.curve, record.first, record.last);
  impl.edge_ids.push_back(id);
}

/// A coedge as the face's wire holds it (of the FORWARD face), before chaining and swapping.
Coedge make_coedge(Impl& impl, FaceId face, const TopoDS_Edge& edge, const TopoDS_Face& forward) {
  Coedge coedge;
  coedge.face = face;
  coedge.reversed = edge.Orientation() == TopAbs_REVERSED;
  TopoDS_Vertex start, end;
  TopExp::Vertices(edge, start, end, true);
  coedge.start = VertexId{impl.vertex_map.FindIndex(start) - 1};
  coedge.end = VertexId{impl.vertex_map.FindIndex(end) - 1};
  double first, last;
  const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
  if (pcurve.IsNull())
    throw InputError("read", name_of(face) + " has an edge without a curve on its surface.",
                     {name_of(face)});
  coedge.slot = static_cast<int>(impl.pcurves.size());
  impl.pcurves.emplace_back(pcurve, first, last);
  if (!BRep_Tool::Degenerated(edge)) {
    coedge.edge = EdgeId{impl.edge_map.FindIndex(edge) - 1};
    add_edge(impl, edge, coedge.edge);
  }
  return coedge;
}

Point2 pcurve_end(const Impl& impl, const Coedge& coedge, bool at_start) {
  const Geom2dAdaptor_Curve& curve = impl.pcurves[coedge.slot];
  const bool low = at_start != coedge.reversed;
  const gp_Pnt2d p = curve.Value(low ? curve.FirstParameter() : curve.LastParameter());
  return {p.X(), p.Y()};
}

/// Puts the coedges of a wire into the order in which they follow each other. Where several start
/// at the vertex (seams, loops that touch themselves), the one that starts at the same (u,v)
/// follows.
Loop chained(const Impl& impl, std::vector<Coedge> rest) {
  Loop loop = {rest.front()};
  rest.erase(rest.begin());
  while (!rest.empty()) {
    const Coedge& last = loop.back();
    const Point2 uv = pcurve_end(impl, last, false);
    auto best = rest.end();
    double best_distance = std::numeric_limits<double>::infinity();
    for (auto it = rest.begin(); it != rest.end(); ++it) {
      if (it->start != last.end) continue;
      const double distance = (pcurve_end(impl, *it, true) - uv).norm();
      if (distance < best_distance) best = it, best_distance = distance;
    }
    if (best == rest.end())
      throw InputError("read", "The outline of " + name_of(last.face) + " is not closed.",
                       {name_of(last.face)});
    loop.push_back(*best);
    rest.erase(best);
  }
  return loop;
}

/// Twice the area that a loop encloses in (u,v), positive counterclockwise, from samples.
double signed_area(const Impl& impl, const Loop& loop) {
  constexpr int n_samples = 16;
  std::vector<Point2> polygon;
  for (const Coedge& coedge : loop) {
    const Geom2dAdaptor_Curve& curve = impl.pcurves[coedge.slot];
    const double a = curve.FirstParameter(), b = curve.LastParameter();
    for (int i = 0; i < n_samples; ++i) {
      const double s = static_cast<double>(i) / n_samples;
      const gp_Pnt2d p = curve.Value(coedge.reversed ? b + (a - b) * s : a + (b - a) * s);
      polygon.emplace_back(p.X(), p.Y());
    }
  }
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += cross2(polygon[i], polygon[(i + 1) % polygon.size()]);
  return area;
}

void reverse_loop(Loop& loop) {
  std::reverse(loop.begin(), loop.end());
  for (Coedge& coedge : loop) {
    coedge.reversed = !coedge.reversed;
    std::swap(coedge.start, coedge.end);
  }
}

/// An edge on the seam of the surface is a seam of the face only where the face uses it twice.
void mark_seams(std::vector<Coedge>& wire) {
  for (Coedge& c : wire)
    c.seam = c.edge.is_valid() && std::count_if(wire.begin(), wire.end(), [&](const Coedge& other) {
                                    return other.edge == c.edge;
                                  }) == 2;
}

/// Edges that lie inside a face (OpenCASCADE calls them internal) have no direction, and their uses
/// no first and last vertex.
void check_bounds(const std::vector<Coedge>& wire) {
  for (const Coedge& c : wire)
    if (c.edge.is_valid() && !(c.start.is_valid() && c.end.is_valid()))
      throw InputError("read",
                       name_of(c.edge) + " lies in " + name_of(c.face) + " and does not bound it.",
                       {name_of(c.edge), name_of(c.face)});
}

std::vector<Loop> make_loops(Impl& impl, FaceId id, const TopoDS_Face& forward, bool swapped) {
  std::vector<std::pair<double, Loop>> loops;
  for (TopoDS_Iterator wire(forward); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    std::vector<Coedge> coedges;
    for (TopoDS_Iterator it(wire.Value()); it.More(); it.Next())
      coedges.push_back(make_coedge(impl, id, TopoDS::Edge(it.Value()), forward));
    if (coedges.empty()) continue;
    check_bounds(coedges);
    mark_seams(coedges);
    Loop loop = chained(impl, std::move(coedges));
    const double area = signed_area(impl, loop);
    loops.emplace_back(area, std::move(loop));
  }
  if (loops.empty()) throw InputError("read", name_of(id) + " has no outline.", {name_of(id)});
  const auto outer = std::max_element(
      loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::rotate(loops.begin(), outer, outer + 1);
  std::vector<Loop> out;
  for (auto& [area, loop] : loops) {
    if (swapped) reverse_loop(loop);
    out.push_back(std::move(loop));
  }
  return out;
}

void add_face(Impl& impl, const TopoDS_Face& face, bool inside_out) {
  const FaceId id{impl.face_map.FindIndex(face) - 1};
  FaceRecord& record = impl.faces[id.index];
  if (!record.face.IsNull())
    throw InputError("read", name_of(id) + " bounds the solid on both its sides.", {name_of(id)});
  record.face = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  record.swapped = (face.Orientation() == TopAbs_REVERSED) != inside_out;
  record.surface.Initialize(record.face, false);
  record.loops = make_loops(impl, id, record.face, record.swapped);
  impl.face_ids.push_back(id);
  for (const Loop& loop : record.loops)
    for (const Coedge& coedge : loop)
      if (coedge.edge.is_valid()) impl.edges[coedge.edge.index].coedges.push_back(coedge);
}

void check_closed(const Impl& impl) {
  std::vector<std::string> open;
  for (const EdgeId e : impl.edge_ids)
    if (impl.edges[e.index].coedges.size() != 2) open.push_back(name_of(e));
  if (open.empty()) return;
  throw InputError("read",
                   "The solid's boundary is not closed: " + open.front() +
                       (open.size() > 1 ? " and " + std::to_string(open.size() - 1) + " other edges"
                                        : std::string()) +
                       " do not lie between two faces.",
                   open);
}

void add_vertices(Impl& impl) {
  impl.vertex_points.resize(impl.vertex_map.Extent());
  impl.edges_at_vertex.resize(impl.vertex_map.Extent());
  for (int v = 0; v < impl.vertex_map.Extent(); ++v)
    impl.vertex_points[v] = to_point(BRep_Tool::Pnt(TopoDS::Vertex(impl.vertex_map(v + 1))));
  for (const EdgeId e : impl.edge_ids) {
    const EdgeRecord& edge = impl.edges[e.index];
    impl.edges_at_vertex[edge.start.index].push_back(e);
    if (edge.end != edge.start) impl.edges_at_vertex[edge.end.index].push_back(e);
  }
  for (int v = 0; v < impl.vertex_map.Extent(); ++v)
    if (!impl.edges_at_vertex[v].empty()) impl.vertex_ids.emplace_back(v);
}

double largest_tolerance(const Impl& impl) {
  double tolerance = 0;
  for (const EdgeId e : impl.edge_ids)
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(impl.edge_map(e.index + 1))));
  return tolerance;
}

}  // namespace

std::shared_ptr<const Impl> make_impl(const TopoDS_Shape& shape, int solid) {
  return translated("The solid cannot be read", [&]() -> std::shared_ptr<const Impl> {
    auto impl = std::make_shared<Impl>();
    impl->shape = shape;
    impl->solid = chosen_solid(shape, solid, impl->n_solids);
    TopExp::MapShapes(shape, TopAbs_FACE, impl->face_map);
    TopExp::MapShapes(shape, TopAbs_EDGE, impl->edge_map);
    TopExp::MapShapes(shape, TopAbs_VERTEX, impl->vertex_map);
    impl->faces.resize(impl->face_map.Extent());
    impl->edges.resize(impl->edge_map.Extent());
    const double volume = signed_volume(impl->solid);
    impl->volume = std::abs(volume);
    for (TopExp_Explorer it(impl->solid, TopAbs_FACE); it.More(); it.Next())
      add_face(*impl, TopoDS::Face(it.Current()), volume < 0);
    if (impl->face_ids.empty()) throw InputError("read", "The solid has no faces.");
    for (TopExp_Explorer it(impl->solid, TopAbs_SHELL); it.More(); it.Next()) ++impl->n_shells;
    std::sort(impl->face_ids.begin(), impl->face_ids.end());
    std::sort(impl->edge_ids.begin(), impl->edge_ids.end());
    check_closed(*impl);
    add_vertices(*impl);
    impl->box = bounding_box(impl->solid);
    const double size = (impl->box.second - impl->box.first).norm();
    if (!(impl->volume > 0) || !(size > 0)) throw InputError("read", "The solid has no volume.");
    impl->tolerances = Tolerances::from_size(size, largest_tolerance(*impl));
    return impl;
  });
}

}  // namespace sweepmesh
