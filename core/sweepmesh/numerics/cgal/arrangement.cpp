#include "sweepmesh/numerics/cgal/arrangement.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <set>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

/// A segment of an input polyline, from its point `index` to the next.
struct Piece {
  int polyline, index;
  auto operator<=>(const Piece&) const = default;
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, Piece>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Halfedge = Arrangement::Halfedge_const_handle;
using Vertex = Arrangement::Vertex_const_handle;

Point2 rounded(const Kernel::Point_2& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

std::vector<Traits::Curve_2> segments_of(const std::vector<std::vector<Point2>>& polylines) {
  std::vector<Traits::Curve_2> out;
  for (std::size_t c = 0; c < polylines.size(); ++c) {
    const auto& points = polylines[c];
    const std::size_t before = out.size();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (!points[i].allFinite() || !points[i + 1].allFinite())
        throw InputError("imprint", "A curve has coordinates that are not finite.");
      if (points[i] == points[i + 1]) continue;
      const SegmentTraits::Curve_2 segment(Kernel::Point_2(points[i].x(), points[i].y()),
                                           Kernel::Point_2(points[i + 1].x(), points[i + 1].y()));
      out.emplace_back(segment, Piece{static_cast<int>(c), static_cast<int>(i)});
    }
    if (out.size() == before) throw InputError("imprint", "A curve has no two different points.");
  }
  return out;
}

/// The input's segments that run along a halfedge, ascending.
std::vector<Piece> pieces_of(Halfedge h) {
  const auto& list = h->curve().data();
  std::vector<Piece> out(list.begin(), list.end());
  std::sort(out.begin(), out.end());
  return out;
}

/// The polylines that run along a halfedge, ascending.
std::vector<int> polylines_of(Halfedge h) {
  std::vector<int> out;
  for (const Piece& p : pieces_of(h))
    if (out.empty() || out.back() != p.polyline) out.push_back(p.polyline);
  return out;
}

/// Reads CGAL's arrangement of segments as one of polylines.
class Reader {
 public:
  Reader(const Arrangement& arrangement, const std::vector<std::vector<Point2>>& polylines)
      : arrangement_(arrangement), polylines_(polylines) {
    for (const auto& points : polylines) {
      ends_.insert({points.front().x(), points.front().y()});
      ends_.insert({points.back().x(), points.back().y()});
    }
  }

  PlaneArrangement read() {
    for (Vertex v = arrangement_.vertices_begin(); v != arrangement_.vertices_end(); ++v)
      if (is_essential(v)) {
        vertex_[&*v] = static_cast<int>(out_.vertices.size());
        out_.vertices.push_back(rounded(v->point()));
      }
    for (Vertex v = arrangement_.vertices_begin(); v != arrangement_.vertices_end(); ++v)
      if (vertex_.contains(&*v)) read_edges_at(v);
    for (auto f = arrangement_.faces_begin(); f != arrangement_.faces_end(); ++f) read_face(f);
    return std::move(out_);
  }

 private:
  bool is_essential(Vertex v) const {
    if (v->degree() != 2) return true;
    const Point2 p = rounded(v->point());
    if (ends_.contains({p.x(), p.y()})) return true;
    const auto first = v->incident_halfedges();
    auto second = first;
    ++second;
    return polylines_of(first) != polylines_of(second);
  }

  void read_edges_at(Vertex v) {
    auto h = v->incident_halfedges();
    const auto last = h;
    do {
      const Halfedge out = h->twin();
      if (!directed_.contains(&*out)) read_edge(out);
    } while (++h != last);
  }

  /// Follows `h` to the next essential vertex.
  void read_edge(Halfedge h) {
    const int index = static_cast<int>(out_.edges.size());
    PlaneArrangement::Edge edge;
    edge.start = vertex_.at(&*h->source());
    edge.points.push_back(rounded(h->source()->point()));
    const Halfedge first = h;
    while (true) {
      directed_[&*h] = {index, false};
      directed_[&*h->twin()] = {index, true};
      edge.points.push_back(rounded(h->target()->point()));
      if (vertex_.contains(&*h->target())) break;
      h = h->next();
    }
    edge.end = vertex_.at(&*h->target());
    for (const int c : polylines_of(first))
      edge.uses.push_back(
          {c, position(first, c, edge.points.front()), position(h, c, edge.points.back())});
    out_.edges.push_back(std::move(edge));
  }

  double position(Halfedge h, int polyline, const Point2& p) const {
    for (const Piece& piece : pieces_of(h)) {
      if (piece.polyline != polyline) continue;
      const Point2 a = polylines_[polyline][piece.index];
      const Point2 d = polylines_[polyline][piece.index + 1] - a;
      return piece.index + std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    }
    return 0.0;
  }

  void read_face(Arrangement::Face_const_handle f) {
    PlaneArrangement::Face face;
    face.is_bounded = !f->is_unbounded();
    if (face.is_bounded) face.loops.push_back(loop_of(f->outer_ccb()));
    for (auto hole = f->inner_ccbs_begin(); hole != f->inner_ccbs_end(); ++hole)
      face.loops.push_back(loop_of(*hole));
    out_.faces.push_back(std::move(face));
  }

  std::vector<DirectedEdge> loop_of(Arrangement::Ccb_halfedge_const_circulator h) const {
    std::vector<DirectedEdge> loop;
    while (!vertex_.contains(&*h->source())) ++h;
    const auto first = h;
    do {
      if (vertex_.contains(&*h->source())) loop.push_back(directed_.at(&*h));
    } while (++h != first);
    return loop;
  }

  const Arrangement& arrangement_;
  const std::vector<std::vector<Point2>>& polylines_;
  std::set<std::pair<double, double>> ends_;
  std::map<const void*, int> vertex_;
  std::map<const void*, DirectedEdge> directed_;
  PlaneArrangement out_;
};

}  // namespace

PlaneArrangement arrange(const std::vector<std::vector<Point2>>& polylines) {
  const auto segments = segments_of(polylines);
  Arrangement arrangement;
  CGAL::insert(arrangement, segments.begin(), segments.end());
  return Reader(arrangement, polylines).read();
}

}  // namespace sweepmesh
