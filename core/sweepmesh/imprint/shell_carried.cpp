#include "sweepmesh/imprint/shell_carried.h"

#include <algorithm>
#include <map>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/imprint/shell_cuts.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/cap_periods.h"

namespace sweepmesh {
namespace {

constexpr int n_samples = 32;

bool is_closed(const Model& model, const std::vector<FaceId>& caps) {
  return caps.size() == 1 && bounding_loops(model, caps.front()).empty();
}

double area_of(const Model& model, const std::vector<FaceId>& faces) {
  double sum = 0.0;
  for (const FaceId f : faces) sum += model.area(f);
  return sum;
}

/// Of points spread evenly over the parameters of a face.
Point3 middle_of(const Model& model, FaceId face) {
  constexpr int n = 8;
  const auto [low, high] = model.uv_bounds(face);
  Point3 sum = Point3::Zero();
  for (int i = 0; i < n * n; ++i) {
    const Point2 share((i % n + 0.5) / n, (i / n + 0.5) / n);
    sum += model.point(face, low + share.cwiseProduct(high - low)) / (n * n);
  }
  return sum;
}

Point3 middle_of(const Model& model, const std::vector<FaceId>& faces) {
  Point3 sum = Point3::Zero();
  for (const FaceId f : faces) sum += middle_of(model, f) * model.area(f);
  return sum / area_of(model, faces);
}

class Carrier {
 public:
  /// `by_target`: the targets are divided, and the source is the closed surface.
  Carrier(const Model& model, const std::vector<FaceId>& divided, FaceId closed, bool by_target)
      : model_(model), divided_(divided), closed_(closed), by_target_(by_target) {
    const bool is_closed_inside = model.area(closed) < area_of(model, divided);
    centre_ = is_closed_inside ? middle_of(model, closed) : middle_of(model, divided);
    reach_ = (model.point(closed, model.project(closed, centre_)) - centre_).norm();
  }

  Shell run() {
    for (const FaceId f : divided_) add_patch(f);
    const int n = static_cast<int>(shell_.patches.size());
    for (int p = 0; p < n; ++p) cut_patch(model_, by_target_, p, shell_);
    for (ShellEdge& e : shell_.edges) carry(e);
    return std::move(shell_);
  }

 private:
  ShellTrace& own(ShellEdge& e) const { return by_target_ ? e.low : e.high; }
  ShellTrace& image(ShellEdge& e) const { return by_target_ ? e.high : e.low; }

  int vertex_at(VertexId v) {
    const auto [at, is_new] = vertex_.emplace(v, shell_.n_vertices);
    shell_.n_vertices += is_new;
    return at->second;
  }

  int edge_of(EdgeId e) {
    const auto [at, is_new] = edge_.emplace(e, static_cast<int>(shell_.edges.size()));
    if (is_new) {
      ShellEdge edge{vertex_at(model_.start(e)), vertex_at(model_.end(e)), {}, {}};
      own(edge).edge = e;
      image(edge).face = closed_;
      shell_.edges.push_back(std::move(edge));
    }
    return at->second;
  }

  /// Loops of targets run the other way round as seen from outside the source.
  void add_patch(FaceId face) {
    ShellPatch patch;
    patch.source = by_target_ ? closed_ : face;
    patch.target = by_target_ ? face : closed_;
    for (const Loop& loop : bounding_loops(model_, face)) {
      patch.loops.emplace_back();
      for (const Coedge& c : loop) patch.loops.back().push_back({edge_of(c.edge), c.reversed});
      if (!by_target_) continue;
      std::reverse(patch.loops.back().begin(), patch.loops.back().end());
      for (DirectedEdge& d : patch.loops.back()) d.reversed = !d.reversed;
    }
    shell_.patches.push_back(std::move(patch));
  }

  std::vector<Point3> points_of(const ShellTrace& trace) const {
    std::vector<Point3> out;
    if (trace.edge.is_valid()) {
      const auto [first, last] = model_.range(trace.edge);
      for (int i = 0; i <= n_samples; ++i)
        out.push_back(model_.point(trace.edge, first + (last - first) * i / n_samples));
      return out;
    }
    const auto [low, high] = model_.uv_bounds(trace.face);
    const Point2 periods = closing_periods(model_, trace.face);
    for (const Point2& uv : even_on_face(model_, trace.face, trace.uv, n_samples))
      out.push_back(model_.point(trace.face, nearest_period(uv, 0.5 * (low + high), periods)));
    return out;
  }

  void carry(ShellEdge& edge) const {
    if (!image(edge).uv.empty()) return;  // a girdle
    std::vector<Point2> uv;
    for (const Point3& p : points_of(own(edge))) uv.push_back(along_ray(p));
    image(edge).uv = unwrapped_loop(uv, closing_periods(model_, closed_)).uv;
  }

  Point2 along_ray(const Point3& p) const {
    constexpr int n_steps = 40;
    constexpr double most_off = 0.3;  // sine
    const Point3 ray = (p - centre_).normalized();
    double reach = reach_;
    Point2 uv;
    Point3 met = Point3::Zero();
    for (int step = 0; step < n_steps; ++step) {
      uv = model_.project(closed_, centre_ + reach * ray);
      met = model_.point(closed_, uv) - centre_;
      const double next = met.dot(ray);
      const bool is_there = std::abs(next - reach) < model_.tolerances().point;
      reach = next;
      if (is_there) break;
    }
    if (!(reach > 0.0) || met.cross(ray).norm() > most_off * met.norm())
      throw ImprintError(ImprintFailure::unreachable,
                         "The edges of the other caps cannot be carried to " + name_of(closed_) +
                             ": it is not seen whole from its middle.",
                         {name_of(closed_)});
    return uv;
  }

  const Model& model_;
  const std::vector<FaceId>& divided_;
  const FaceId closed_;
  const bool by_target_;
  Point3 centre_;
  double reach_ = 0.0;
  Shell shell_;
  std::map<VertexId, int> vertex_;
  std::map<EdgeId, int> edge_;
};

}  // namespace

std::optional<Shell> carried_shell(const Model& model, const Scheme& scheme) {
  const auto sources = scheme.faces_with(FaceRole::source),
             targets = scheme.faces_with(FaceRole::target);
  if (is_closed(model, targets)) return Carrier(model, sources, targets.front(), false).run();
  if (is_closed(model, sources)) return Carrier(model, targets, sources.front(), true).run();
  return std::nullopt;
}

}  // namespace sweepmesh
