#include "sweepmesh/imprint/divided_caps.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "sweepmesh/imprint/edge_lengths.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/imprint/section_map.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/chart.h"

namespace sweepmesh {
namespace {

Point2 mirrored(const Point2& p) {
  return {-p.x(), p.y()};
}

bool is_cap(FaceRole role) {
  return role == FaceRole::source || role == FaceRole::target;
}

/// The pair to which each patch belongs on one cap.
std::map<int, int> pairs_on(const Imprint& imprint, FaceId cap) {
  std::map<int, int> out;
  int number = 0;
  for (std::size_t p = 0; p < imprint.patches.size(); ++p)
    for (const Run& r : imprint.patches[p].runs) {
      if (r.target == cap || r.source == cap) out[static_cast<int>(p)] = number;
      ++number;
    }
  return out;
}

/// An imprint edge between two patches of one cap: the patches on its left and right, in R.
struct InnerEdge {
  int edge, left, right;
};

std::vector<InnerEdge> inner_edges(const Imprint& imprint, const std::map<int, int>& pairs) {
  std::map<int, std::pair<int, int>> sides;
  for (const auto& [patch, pair] : pairs)
    for (const auto& loop : imprint.patches[patch].loops)
      for (const DirectedEdge& d : loop) {
        auto& [left, right] = sides.try_emplace(d.edge, -1, -1).first->second;
        (d.reversed ? right : left) = patch;
      }
  std::vector<InnerEdge> out;
  for (const auto& [edge, side] : sides)
    if (side.first >= 0 && side.second >= 0) out.push_back({edge, side.first, side.second});
  return out;
}

/// Points between those of a line, on cubic curves with the tangents of their neighbours.
Polyline smoothly_refined(const Polyline& line, int n_parts) {
  const auto tangent = [&](std::size_t i) -> Point2 {
    const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, line.size() - 1);
    return (line[b] - line[a]) / static_cast<double>(b - a);
  };
  Polyline out = {line.front()};
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int part = 1; part <= n_parts; ++part) {
      const double s = static_cast<double>(part) / n_parts, r = 1.0 - s;
      out.push_back(r * r * (1 + 2 * s) * line[i] + s * s * (1 + 2 * r) * line[i + 1] +
                    s * r * (r * tangent(i) - s * tangent(i + 1)));
    }
  return out;
}

/// As resampled(), without points that all but coincide.
std::vector<PolylinePoint> spread(const Polyline& line, double spacing) {
  constexpr double least_share = 0.02;
  const double least = std::min(least_share * spacing, length(line) / 2);
  std::vector<PolylinePoint> out;
  auto all = resampled(line, spacing);
  for (const PolylinePoint& p : all)
    if (out.empty() || (p.arc - out.back().arc > least && all.back().arc - p.arc > least))
      out.push_back(p);
  out.push_back(all.back());
  return out;
}

/// One cap: its outline in R and in its chart, point by point, and what is carried between them.
class CapDivider {
 public:
  CapDivider(const Model& model, const Imprint& imprint, FaceId cap, bool is_source,
             const Context& context)
      : model_(model), imprint_(imprint), cap_(cap), is_source_(is_source), context_(context) {}

  CapDivision run() {
    CapDivision out{{model_, cap_, {}}, {}, -1};
    const auto pairs = pairs_on(imprint_, cap_);
    const auto inner = inner_edges(imprint_, pairs);
    if (inner.empty()) {
      if (!pairs.empty()) out.whole = pairs.begin()->second;
      return out;
    }
    find_spacing();
    sample_outline();
    carry(inner);
    for (const InnerEdge& e : inner) {
      out.division.curves.push_back(curve_of(e.edge));
      const int left = pairs.at(e.left), right = pairs.at(e.right);
      out.sides.push_back(is_source_ ? CapDivision::Sides{left, right}
                                     : CapDivision::Sides{right, left});
    }
    return out;
  }

 private:
  // --- the outline -------------------------------------------------------------------------------

  void find_spacing() {
    constexpr double n_across = 48.0;
    std::optional<Box2> all;
    for (const Loop& loop : model_.loops(cap_))
      for (const Coedge& c : loop)
        for (const DirectedEdge& d : chain(c)) {
          const Box2 box = box_of(line_of(d.edge));
          all = all ? Box2{all->low.cwiseMin(box.low), all->high.cwiseMax(box.high)} : box;
        }
    spacing_ = (all->high - all->low).norm() / n_across;
  }

  /// As long as it is in the model.
  Polyline line_of(int edge) const {
    Polyline line = imprint_.edges[edge].points;
    for (Point2& p : line) p *= imprint_.unit;
    return line;
  }

  std::vector<DirectedEdge> chain(const Coedge& c) const {
    return c.edge.is_valid() ? imprint_.chain[c.edge.index] : std::vector<DirectedEdge>{};
  }

  /// Nodes along the cap's edges, numbered from 0: where each lies in R, and on its edge.
  void sample_outline() {
    std::vector<std::vector<NodeId>> nodes(model_.n_edges());
    std::vector<std::vector<double>> t(model_.n_edges());
    for (const Loop& loop : model_.loops(cap_))
      for (const Coedge& c : loop)
        if (c.edge.is_valid() && nodes[c.edge.index].empty())
          sample(c.edge, nodes[c.edge.index], t[c.edge.index]);
    CapLoops loops = cap_loops(model_, cap_, nodes, t);
    if (!is_source_)
      for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
    make_chart(loops);
  }

  void sample(EdgeId e, std::vector<NodeId>& nodes, std::vector<double>& t) {
    for (const DirectedEdge& d : imprint_.chain[e.index]) {
      const ImprintEdge& edge = imprint_.edges[d.edge];
      const auto trace = std::find_if(edge.traces.begin(), edge.traces.end(),
                                      [&](const Trace& tr) { return tr.edge == e; });
      Polyline line = line_of(d.edge);
      if (d.reversed) std::reverse(line.begin(), line.end());
      const double whole = length(line), first = d.reversed ? trace->last : trace->first;
      const double last = d.reversed ? trace->first : trace->last;
      for (const PolylinePoint& p : spread(line, spacing_)) {
        const bool is_start = p.arc <= 0.0, is_end = p.arc >= whole;
        if (is_start && !t.empty()) continue;
        t.push_back(is_start ? first : is_end ? last : parameter_at(e, first, last, p.arc / whole));
        const int vertex = is_start ? (d.reversed ? edge.end : edge.start)
                           : is_end ? (d.reversed ? edge.start : edge.end)
                                    : -1;
        nodes.push_back(node_at(p.point, vertex, e, t.back()));
      }
    }
  }

  /// Of an edge: where a part of the length between two parameters has passed.
  double parameter_at(EdgeId e, double first, double last, double share) const {
    const auto ends = length_fractions(model_, e, {first, last});
    return model_.at_length_fractions(e, {ends[0] + share * (ends[1] - ends[0])}).front();
  }

  NodeId node_at(const Point2& p, int vertex, EdgeId e, double t) {
    if (vertex >= 0) place_of_vertex_.emplace(vertex, model_.point(e, t));
    in_reference_.push_back(p);
    vertex_of_.push_back(vertex);
    return NodeId{in_reference_.size() - 1};
  }

  void make_chart(const CapLoops& above) {
    CapLoops outside = above;
    if (!is_source_)
      for (auto& loop : outside) std::reverse(loop.begin(), loop.end());
    std::optional<int> outer;
    for (std::size_t l = 0; l < above.size(); ++l) {
      Polyline from;
      for (const CapNode& n : above[l]) from.push_back(in_reference_[n.node.index]);
      if (signed_area(from) > 0.0) outer = static_cast<int>(l);
      from.push_back(from.front());
      outline_.push_back({std::move(from), {}});
    }
    chart_.emplace(model_, cap_, outside, facet_size(outside), context_, outer);
    for (std::size_t k = 0; k < chart_->order().size(); ++k) {
      Polyline to = chart_->loops()[k];
      if (!is_source_) {
        std::reverse(to.begin(), to.end());
        std::transform(to.begin(), to.end(), to.begin(), mirrored);
      }
      to.push_back(to.front());
      outline_[chart_->order()[k]].to = std::move(to);
    }
    for (std::size_t l = 0; l < above.size(); ++l)
      for (std::size_t i = 0; i < above[l].size(); ++i)
        if (const int v = vertex_of_[above[l][i].node.index]; v >= 0)
          in_chart_[v] = outline_[l].to[i];
  }

  static double facet_size(const CapLoops& loops) {
    constexpr double n_around = 64.0;
    double perimeter = 0.0;
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        perimeter += (loop[i].point - loop[(i + 1) % loop.size()].point).norm();
    return perimeter / n_around;
  }

  // --- curves inside -----------------------------------------------------------------------------

  bool is_on_outline(int vertex) const { return place_of_vertex_.contains(vertex); }

  void carry(const std::vector<InnerEdge>& inner) {
    std::vector<Point2> points;
    std::map<int, std::size_t> at_vertex;
    std::map<int, std::vector<std::size_t>> at_edge;
    for (const InnerEdge& e : inner) {
      const ImprintEdge& edge = imprint_.edges[e.edge];
      for (const int v : {edge.start, edge.end})
        if (!is_on_outline(v) && at_vertex.try_emplace(v, points.size()).second)
          points.push_back(imprint_.unit * imprint_.vertices[v].point);
      const auto samples = spread(line_of(e.edge), spacing_);
      for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        at_edge[e.edge].push_back(points.size());
        points.push_back(samples[i].point);
      }
    }
    const auto images = carried_smoothly(outline_, points, spacing_, context_);
    for (const auto& [v, i] : at_vertex) {
      in_chart_[v] = images[i];
      place_of_vertex_.emplace(v, in_space(images[i]));
    }
    for (const auto& [e, list] : at_edge)
      for (const std::size_t i : list) inside_[e].push_back(images[i]);
  }

  Point3 in_space(const Point2& p) const { return chart_->point(is_source_ ? p : mirrored(p)); }

  /// On a curved face points are added, so that a curve through them keeps to the face.
  DividingCurve curve_of(int e) const {
    constexpr int n_parts = 4;
    const ImprintEdge& edge = imprint_.edges[e];
    Polyline line = {in_chart_.at(edge.start)};
    if (const auto found = inside_.find(e); found != inside_.end())
      line.insert(line.end(), found->second.begin(), found->second.end());
    line.push_back(in_chart_.at(edge.end));
    if (!model_.is_planar(cap_)) line = smoothly_refined(line, n_parts);
    DividingCurve out{{place_of_vertex_.at(edge.start)}, edge.start, edge.end};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) out.points.push_back(in_space(line[i]));
    out.points.push_back(place_of_vertex_.at(edge.end));
    return out;
  }

  const Model& model_;
  const Imprint& imprint_;
  const FaceId cap_;
  const bool is_source_;
  const Context& context_;
  double spacing_ = 0.0;              ///< between nodes of the triangulation in R
  std::vector<Point2> in_reference_;  ///< by node of the outline
  std::vector<int> vertex_of_;        ///< by node of the outline: the imprint vertex, or -1
  std::vector<OutlinePart> outline_;  ///< as seen from above
  std::optional<Chart> chart_;
  std::map<int, Point3> place_of_vertex_;      ///< by imprint vertex, on the cap
  std::map<int, Point2> in_chart_;             ///< by imprint vertex
  std::map<int, std::vector<Point2>> inside_;  ///< by imprint edge, its ends left out; in the chart
};

}  // namespace

std::vector<CapDivision> divide_caps(const Model& model, const Scheme& scheme,
                                     const Imprint& imprint, const Context& context) {
  std::vector<CapDivision> out;
  for (const FaceId f : model.faces()) {
    if (!is_cap(scheme.face_role[f.index])) continue;
    context.check("imprint");
    const bool is_source = scheme.face_role[f.index] == FaceRole::source;
    try {
      out.push_back(CapDivider(model, imprint, f, is_source, context).run());
    } catch (const InvalidMeshError& e) {
      throw InvalidMeshError("imprint",
                             "The imprinted curves cannot be laid onto " + name_of(f) + ".",
                             {name_of(f)}, {});
    }
  }
  return out;
}

}  // namespace sweepmesh
