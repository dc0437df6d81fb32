#include "sweepmesh/imprint/shell_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/shell_girdle.h"
#include "sweepmesh/surface/cap_periods.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {
namespace {

/// A loop of a cap in the parameter plane.
struct LoopShape {
  UnwrappedLoop line;
  std::vector<Point2> start;  ///< of its edges, as in the patch's loop
  double length = 0.0;        ///< in space
  Point3 middle = Point3::Zero();
};

bool has_pole(const Model& model, FaceId face) {
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop)
      if (!c.edge.is_valid()) return true;
  return false;
}

bool cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto side = [](const Point2& p, const Point2& q, const Point2& r) {
    return cross2(q - p, r - p) > 0.0;
  };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

/// Whether the line a - b meets a closed loop, whichever of its periods.
bool meets(const Point2& a, const Point2& b, const UnwrappedLoop& loop, const Point2& periods) {
  const std::size_t n = loop.uv.size();
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const Point2 shift(i * periods.x(), j * periods.y());
      for (std::size_t s = 0; s < n; ++s)
        if (cross(a, b, loop.uv[s] + shift, loop.uv[(s + 1) % n] + shift)) return true;
    }
  return false;
}

class Cutter {
 public:
  Cutter(const Model& model, bool by_target, int patch, Shell& shell)
      : model_(model),
        shell_(shell),
        index_(patch),
        patch_(shell.patches[patch]),
        by_target_(by_target),
        face_(by_target ? patch_.target : patch_.source),
        periods_(closing_periods(model, face_)) {
    for (const auto& loop : patch_.loops) loops_.push_back(shape_of(loop));
  }

  void run() {
    if (has_pole(model_, face_)) {
      if (is_more_than_a_hemisphere()) cut_girdle();
    } else if (turning().sum() == 2) {
      cut_band();
    } else if (turning().sum() == 0 && periods_.minCoeff() > 0.0 && is_without_outer_loop()) {
      cut_torus();
    } else if (loops_.empty()) {
      refuse();
    }
  }

 private:
  [[noreturn]] void refuse() const {
    throw ImprintError(ImprintFailure::unreachable,
                       name_of(patch_.source) +
                           " closes on itself in a way that cannot be meshed as a cap; split it.",
                       {name_of(patch_.source), name_of(patch_.target)});
  }

  /// Along the CAD edges that bound the face.
  LoopShape shape_of(const std::vector<DirectedEdge>& loop) const {
    constexpr int n_samples = 16;
    LoopShape out;
    std::vector<Point2> uv;
    for (const DirectedEdge& d : loop) {
      const ShellEdge& edge = shell_.edges[d.edge];
      const ShellTrace& trace = by_target_ ? edge.low : edge.high;
      Coedge coedge;
      for (const Coedge& c : model_.coedges(trace.edge))
        if (c.face == face_) coedge = c;
      const auto [first, last] = model_.range(trace.edge);
      const bool is_back = d.reversed != trace.is_reversed;
      out.length += model_.length(trace.edge);
      for (int i = 0; i < n_samples; ++i) {
        const double f = static_cast<double>(i) / n_samples;
        const double t = is_back ? last + (first - last) * f : first + (last - first) * f;
        uv.push_back(model_.uv(coedge, t));
        out.middle += model_.point(trace.edge, t) / static_cast<double>(n_samples * loop.size());
      }
    }
    out.line = unwrapped_loop(uv, periods_);
    for (std::size_t c = 0; c < loop.size(); ++c) out.start.push_back(out.line.uv[c * n_samples]);
    return out;
  }

  Eigen::Vector2i turning() const {
    Eigen::Vector2i sum = Eigen::Vector2i::Zero();
    for (const LoopShape& l : loops_) sum += l.line.turns.cwiseAbs();
    return sum;
  }

  bool is_without_outer_loop() const {
    return std::none_of(loops_.begin(), loops_.end(), [&](const LoopShape& l) {
      return (signed_area(l.line.uv) > 0.0) != by_target_;
    });
  }

  /// A plane disc has 1 for this ratio of area and boundary, a hemisphere 2.
  bool is_more_than_a_hemisphere() const {
    constexpr double most = 2.5;
    double length = 0.0;
    for (const LoopShape& l : loops_) length = std::max(length, l.length);
    return 4.0 * std::numbers::pi * model_.area(face_) > most * length * length;
  }

  int add_edge(int start, int end, std::vector<Point2> high, std::vector<Point2> low) {
    ShellEdge edge{start, end, {}, {}};
    edge.high.face = patch_.source;
    edge.high.uv = std::move(high);
    edge.low.face = patch_.target;
    edge.low.uv = std::move(low);
    shell_.edges.push_back(std::move(edge));
    return static_cast<int>(shell_.edges.size()) - 1;
  }

  // --- bands -------------------------------------------------------------------------------------

  void cut_band() {
    std::vector<std::size_t> rims;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      if (loops_[l].line.turns != Eigen::Vector2i::Zero()) rims.push_back(l);
    if (rims.size() != 2) return;
    double least = std::numeric_limits<double>::infinity();
    std::pair<std::size_t, std::size_t> best;
    for (std::size_t a = 0; a < loops_[rims[0]].start.size(); ++a)
      for (std::size_t b = 0; b < loops_[rims[1]].start.size(); ++b) {
        const double cost = cost_of_line(loops_[rims[0]].start[a], loops_[rims[1]].start[b]);
        if (cost < least) least = cost, best = {a, b};
      }
    if (least < std::numeric_limits<double>::infinity())
      join(rims[0], best.first, rims[1], best.second);
  }

  /// Its length in space; infinite where a hole is in the way.
  double cost_of_line(const Point2& from, const Point2& to) const {
    constexpr int n = 16;
    const Point2 end = nearest_period(to, from, periods_);
    for (const LoopShape& l : loops_)
      if (l.line.turns == Eigen::Vector2i::Zero() && meets(from, end, l.line, periods_))
        return std::numeric_limits<double>::infinity();
    const Point2 middle = middle_of_bounds();
    double length = 0.0;
    for (int i = 0; i < n; ++i) {
      const Point2 a = from + (end - from) * i / n, b = from + (end - from) * (i + 1) / n;
      length += (model_.point(face_, nearest_period(a, middle, periods_)) -
                 model_.point(face_, nearest_period(b, middle, periods_)))
                    .norm();
    }
    return length;
  }

  Point2 middle_of_bounds() const {
    const auto [low, high] = model_.uv_bounds(face_);
    return 0.5 * (low + high);
  }

  int start_of(const DirectedEdge& d) const {
    return d.reversed ? shell_.edges[d.edge].end : shell_.edges[d.edge].start;
  }

  /// One loop of two: around the first from its coedge `a` on, over, around the second, back.
  void join(std::size_t first, std::size_t a, std::size_t second, std::size_t b) {
    auto one = patch_.loops[first], other = patch_.loops[second];
    std::rotate(one.begin(), one.begin() + a, one.end());
    std::rotate(other.begin(), other.begin() + b, other.end());
    const Point2 from = loops_[first].start[a];
    const std::vector<Point2> line = {from,
                                      nearest_period(loops_[second].start[b], from, periods_)};
    const int cut = by_target_ ? add_edge(start_of(one.front()), start_of(other.front()), {}, line)
                               : add_edge(start_of(one.front()), start_of(other.front()), line, {});
    one.push_back({cut, false});
    one.insert(one.end(), other.begin(), other.end());
    one.push_back({cut, true});
    auto& loops = shell_.patches[index_].loops;
    loops.erase(loops.begin() + second);
    loops[first] = std::move(one);
    std::rotate(loops.begin(), loops.begin() + first, loops.begin() + first + 1);
  }

  // --- balls -------------------------------------------------------------------------------------

  /// A closed row of parameters with its first point again at the end, without a jump.
  static std::vector<Point2> closed(const std::vector<Point2>& uv, const Point2& periods) {
    std::vector<Point2> out = unwrapped_loop(uv, periods).uv;
    out.push_back(nearest_period(out.front(), out.back(), periods));
    return out;
  }

  void cut_girdle() {
    const auto girdle = find_girdle(model_, patch_.source, patch_.target);
    if (!girdle) {
      if (loops_.empty()) refuse();
      return;
    }
    const int vertex = shell_.n_vertices++;
    const int cut = add_edge(vertex, vertex, closed(girdle->high, periods_),
                             closed(girdle->low, closing_periods(model_, patch_.target)));
    ShellPatch over{patch_.source, patch_.target, {{{cut, false}}}};
    ShellPatch under{patch_.source, patch_.target, {{{cut, true}}}};
    for (std::size_t l = 0; l < loops_.size(); ++l)
      ((loops_[l].middle - girdle->high_centre).dot(girdle->normal) > 0.0 ? over : under)
          .loops.push_back(patch_.loops[l]);
    shell_.patches[index_] = std::move(over);
    shell_.patches.push_back(std::move(under));
  }

  // --- tori --------------------------------------------------------------------------------------

  void cut_torus() {
    const auto corner = free_corner();
    if (!corner) refuse();
    const Point2 u(periods_.x(), 0.0), v(0.0, periods_.y());
    const int vertex = shell_.n_vertices++;
    const int along_u = add_circle(vertex, *corner, u), along_v = add_circle(vertex, *corner, v);
    auto& loops = shell_.patches[index_].loops;
    loops.insert(loops.begin(),
                 {{along_u, false}, {along_v, false}, {along_u, true}, {along_v, true}});
  }

  /// A place whose two parameter lines meet no hole.
  std::optional<Point2> free_corner() const {
    constexpr int n = 16;
    const Point2 u(periods_.x(), 0.0), v(0.0, periods_.y()),
        low = model_.uv_bounds(patch_.source).first;
    const auto is_free = [&](const Point2& from, const Point2& along) {
      return std::none_of(loops_.begin(), loops_.end(), [&](const LoopShape& l) {
        return meets(from, from + along, l.line, periods_);
      });
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Point2 p = low + u * i / n + v * j / n;
        if (is_free(p, u) && is_free(p, v)) return p;
      }
    return std::nullopt;
  }

  int add_circle(int vertex, const Point2& from, const Point2& along) {
    constexpr int n = 64;
    std::vector<Point2> high, low;
    for (int i = 0; i < n; ++i) {
      high.push_back(from + along * i / n);
      const Point2 on_face = nearest_period(high.back(), middle_of_bounds(), periods_);
      low.push_back(model_.project(patch_.target, model_.point(patch_.source, on_face)));
    }
    return add_edge(vertex, vertex, closed(high, periods_),
                    closed(low, closing_periods(model_, patch_.target)));
  }

  const Model& model_;
  Shell& shell_;
  const int index_;
  const ShellPatch patch_;
  const bool by_target_;
  const FaceId face_;  ///< whose shape decides
  const Point2 periods_;
  std::vector<LoopShape> loops_;  ///< as patch_.loops
};

}  // namespace

void cut_patch(const Model& model, bool by_target, int patch, Shell& shell) {
  Cutter(model, by_target, patch, shell).run();
}

}  // namespace sweepmesh
