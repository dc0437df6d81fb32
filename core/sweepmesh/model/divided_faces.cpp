#include "sweepmesh/model/divided_faces.h"

#include <BOPTools_AlgoTools.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "sweepmesh/model/impl.h"

namespace sweepmesh {
namespace {

std::string brep_text(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

bool is_straight(const std::vector<Point3>& points, double tolerance) {
  const Point3 chord = points.back() - points.front();
  if (!(chord.norm() > tolerance)) return false;
  return std::all_of(points.begin(), points.end(), [&](const Point3& p) {
    return (p - points.front()).cross(chord.normalized()).norm() <= tolerance;
  });
}

/// The points cut where the line through them turns by more than a corner does.
std::vector<std::vector<Point3>> smooth_parts(const std::vector<Point3>& points) {
  constexpr double corner = 0.35;  // radians
  std::vector<std::vector<Point3>> parts(1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    parts.back().push_back(points[i]);
    if (i == 0 || i + 1 == points.size()) continue;
    const Point3 in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (std::atan2(in.cross(out).norm(), in.dot(out)) > corner) parts.push_back({points[i]});
  }
  return parts;
}

/// Whether the line closes without a corner.
bool is_ring(const std::vector<std::vector<Point3>>& parts) {
  const auto& points = parts.front();
  return parts.size() == 1 && points.front() == points.back() &&
         smooth_parts({points[points.size() - 2], points[0], points[1]}).size() == 1;
}

/// A curve through the points with continuous curvature; `is_closed`: at its ends too.
Handle(Geom_BSplineCurve) spline_through(const std::vector<Point3>& points, bool is_closed) {
  const int n = static_cast<int>(points.size()) - is_closed;
  const Handle(TColgp_HArray1OfPnt) poles = new TColgp_HArray1OfPnt(1, n);
  for (int i = 0; i < n; ++i) poles->SetValue(i + 1, to_gp(points[i]));
  GeomAPI_Interpolate through(poles, is_closed, Precision::Confusion());
  through.Perform();
  return through.IsDone() ? through.Curve() : nullptr;
}

class FaceDivider {
 public:
  explicit FaceDivider(const FaceDivision& division)
      : division_(division),
        record_(division.model.impl().faces[division.face.index]),
        tolerance_(division.model.tolerances().point) {}

  /// Edges in the order of the curves.
  void make_edges() {
    for (std::size_t c = 0; c < division_.curves.size(); ++c) {
      const DividingCurve& curve = division_.curves[c];
      const auto parts = smooth_parts(curve.points);
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      TopoDS_Vertex at = vertex(curve.start, curve.points.front());
      for (std::size_t p = 0; p < parts.size(); ++p) {
        const TopoDS_Vertex next =
            p + 1 < parts.size() ? new_vertex(parts[p].back()) : vertex(curve.end, parts[p].back());
        const TopoDS_Edge edge = make_edge(parts[p], is_ring(parts), at, next);
        edges_.push_back({edge, static_cast<int>(c)});
        builder_.Add(wire, edge);
        at = next;
      }
      wires_.push_back(wire);
    }
  }

  /// Adds the pieces to the compound and the list.
  void divide(int number, TopoDS_Compound& faces, std::vector<FacePiece>& pieces) {
    BRepAlgoAPI_Splitter splitter;
    TopTools_ListOfShape objects, tools;
    objects.Append(record_.face);
    for (const auto& [edge, curve] : edges_) tools.Append(edge);
    splitter.SetArguments(objects);
    splitter.SetTools(tools);
    splitter.SetNonDestructive(true);
    if (!edges_.empty()) splitter.Build();
    if (splitter.HasErrors()) throw_uncut();
    find_cuts(splitter);
    std::vector<char> is_left_cut(division_.curves.size(), false), is_right_cut = is_left_cut;
    const TopoDS_Shape all = edges_.empty() ? TopoDS_Shape(record_.face) : splitter.Shape();
    for (TopExp_Explorer it(all, TopAbs_FACE); it.More(); it.Next()) {
      FacePiece piece = piece_of(TopoDS::Face(it.Current()), is_left_cut, is_right_cut);
      piece.division = number;
      pieces.push_back(piece);
      builder_.Add(faces, record_.swapped ? it.Current().Reversed() : it.Current());
    }
    if (std::count(is_left_cut.begin(), is_left_cut.end(), false) > 0 ||
        std::count(is_right_cut.begin(), is_right_cut.end(), false) > 0)
      throw_uncut();
  }

  const std::vector<TopoDS_Wire>& wires() const { return wires_; }

 private:
  struct CurveEdge {
    TopoDS_Edge edge;
    int curve;
  };
  struct Cut {
    int curve;
    bool is_against;
  };

  TopoDS_Vertex new_vertex(const Point3& p) {
    TopoDS_Vertex v;
    builder_.MakeVertex(v, to_gp(p), tolerance_);
    return v;
  }

  TopoDS_Vertex vertex(int number, const Point3& p) {
    const auto found = vertices_.find(number);
    return found != vertices_.end() ? found->second
                                    : vertices_.emplace(number, new_vertex(p)).first->second;
  }

  /// The largest distance of a curve from the face, half way between the points that it was laid
  /// through.
  double off_face(const Geom_Curve& curve, const std::vector<Point3>& points) const {
    if (division_.model.is_planar(division_.face)) return tolerance_;
    double most = tolerance_;
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double t = first + (last - first) * (i + 0.5) / (points.size() - 1);
      const Point3 p = to_point(curve.Value(t));
      const Point2 uv = division_.model.project(division_.face, p);
      most = std::max(most, 1.5 * (division_.model.point(division_.face, uv) - p).norm());
    }
    return most;
  }

  TopoDS_Edge make_edge(std::vector<Point3> points, bool is_closed, const TopoDS_Vertex& start,
                        const TopoDS_Vertex& end) {
    if (is_straight(points, tolerance_)) return BRepBuilderAPI_MakeEdge(start, end).Edge();
    points.front() = to_point(BRep_Tool::Pnt(start));
    points.back() = to_point(BRep_Tool::Pnt(end));
    const auto curve = spline_through(points, is_closed);
    if (curve.IsNull()) throw_uncut();
    BRepBuilderAPI_MakeEdge made(curve, start, end);
    if (!made.IsDone()) throw_uncut();
    builder_.UpdateEdge(made.Edge(), off_face(*curve, points));
    return made.Edge();
  }

  void find_cuts(BRepAlgoAPI_Splitter& splitter) {
    const Handle(IntTools_Context) context = new IntTools_Context;
    for (const auto& [edge, curve] : edges_) {
      const TopTools_ListOfShape& parts = splitter.Modified(edge);
      if (parts.IsEmpty()) add_cut(edge, curve, false);
      for (const TopoDS_Shape& part : parts)
        add_cut(part, curve,
                BOPTools_AlgoTools::IsSplitToReverse(TopoDS::Edge(part.Oriented(TopAbs_FORWARD)),
                                                     edge, context));
    }
  }

  void add_cut(const TopoDS_Shape& edge, int curve, bool is_against) {
    cut_of_.Bind(edge.Oriented(TopAbs_FORWARD), static_cast<int>(cuts_.size()));
    cuts_.push_back({curve, is_against});
  }

  /// Looks for a cut in the piece's boundary; the material lies on the left of its edges, seen
  /// against the surface's own normal.
  FacePiece piece_of(const TopoDS_Face& face, std::vector<char>& is_left_cut,
                     std::vector<char>& is_right_cut) const {
    FacePiece out;
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Shape forward = it.Current().Oriented(TopAbs_FORWARD);
      if (!cut_of_.IsBound(forward)) continue;
      const Cut& cut = cuts_[cut_of_.Find(forward)];
      const bool is_reversed = it.Current().Orientation() == TopAbs_REVERSED;
      const bool is_left = (is_reversed == cut.is_against) != record_.swapped;
      (is_left ? is_left_cut : is_right_cut)[cut.curve] = true;
      out.curve = cut.curve;
      out.is_left = is_left;
    }
    return out;
  }

  [[noreturn]] void throw_uncut() const {
    throw SolverError("imprint",
                      name_of(division_.face) + " cannot be cut along the imprinted curves.",
                      {name_of(division_.face)});
  }

  const FaceDivision& division_;
  const FaceRecord& record_;
  double tolerance_;
  BRep_Builder builder_;
  std::map<int, TopoDS_Vertex> vertices_;
  std::vector<CurveEdge> edges_;
  std::vector<TopoDS_Wire> wires_;
  TopTools_DataMapOfShapeInteger cut_of_;
  std::vector<Cut> cuts_;
};

}  // namespace

DividedFaces divide_faces(const std::vector<FaceDivision>& divisions) {
  return translated("The caps cannot be cut", [&] {
    BRep_Builder builder;
    TopoDS_Compound faces, curves;
    builder.MakeCompound(faces);
    builder.MakeCompound(curves);
    DividedFaces out;
    for (std::size_t d = 0; d < divisions.size(); ++d) {
      FaceDivider divider(divisions[d]);
      divider.make_edges();
      divider.divide(static_cast<int>(d), faces, out.pieces);
      for (const TopoDS_Wire& wire : divider.wires()) builder.Add(curves, wire);
    }
    out.faces = brep_text(faces);
    out.curves = brep_text(curves);
    return out;
  });
}

}  // namespace sweepmesh
