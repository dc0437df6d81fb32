#include "sweepmesh/imprint/leaning_face.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "sweepmesh/imprint/forest.h"

namespace sweepmesh {
namespace {

/// A transverse edge of the face: its curve along +i, from `first` to `last` in i.
struct Rung {
  double first, last;
  int level;
  Polyline line;

  Polyline between(double a, double b) const {
    const double scale = length(line) / (last - first);
    return part(line, at_arc(line, (a - first) * scale).position,
                at_arc(line, (b - first) * scale).position);
  }
};

class LeaningFace {
 public:
  LeaningFace(const Model& model, const Scheme& scheme, const Walls& walls, const Reference& seen,
              const LevelHeights& height, FaceId face)
      : walls_(walls), seen_(seen), height_(height), face_(face), loop_(model.loops(face)[0]) {
    if (model.loops(face).size() != 1) refuse("has holes");
    direction_ = scheme.face[face.index].direction[0];
  }

  std::vector<Panel> run() {
    lay_out();
    std::vector<Rung> bottoms, tops;
    for (std::size_t j = 0; j < loop_.size(); ++j) {
      if (direction_[j] == Direction::plus_i) bottoms.push_back(rung(j));
      if (direction_[j] == Direction::minus_i) tops.push_back(rung(j));
    }
    const std::set<double> cuts(i_.begin(), i_.end());
    std::vector<Panel> out;
    for (const Rung& bottom : bottoms)
      for (auto cut = cuts.find(bottom.first); *cut != bottom.last; ++cut)
        out.push_back(strip(bottom, tops, *cut, *std::next(cut)));
    return out;
  }

 private:
  [[noreturn]] void refuse(const char* what) const {
    throw ImprintError(ImprintFailure::unreachable,
                       name_of(face_) + " leans along the sweep and " + what +
                           ", so its columns cannot be followed.",
                       {name_of(face_)});
  }

  std::size_t next(std::size_t j) const { return j + 1 == loop_.size() ? 0 : j + 1; }
  bool is_transverse(std::size_t j) const {
    return direction_[j] == Direction::plus_i || direction_[j] == Direction::minus_i;
  }
  /// 1 along +i, -1 against it.
  double sign(std::size_t j) const { return direction_[j] == Direction::plus_i ? 1.0 : -1.0; }

  const Polyline& curve(std::size_t j) const {
    return std::ranges::find(seen_.curves, loop_[j].edge, &ReferenceCurve::edge)->points;
  }
  const Point2& seen_start(std::size_t j) const { return seen_.vertex[loop_[j].start.index]; }
  int level(std::size_t j) const { return walls_.vertex_level[loop_[j].start.index]; }
  /// Whether the vertex where coedge j starts is the end of a curve that is seen.
  bool is_seen(std::size_t j) const {
    return is_transverse(j) || is_transverse(j == 0 ? loop_.size() - 1 : j - 1);
  }

  // --- i of the vertices ------------------------------------------------------------------------

  void lay_out() {
    Forest same(static_cast<int>(loop_.size()));
    for (std::size_t j = 0; j < loop_.size(); ++j)
      if (!is_transverse(j)) same.join(static_cast<int>(j), static_cast<int>(next(j)));
    i_ = solved(same);
    if (!is_forward(i_)) refuse("has an outline that does not close in i");
    Forest joined = same;
    join_stacked(joined);
    if (const std::vector<double> better = solved(joined); is_forward(better)) i_ = better;
    gather();
  }

  /// Least squares of the relative changes of length; i by coedge, of its start.
  std::vector<double> solved(const Forest& same) const {
    const auto n = static_cast<Eigen::Index>(loop_.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (std::size_t j = 0; j < loop_.size(); ++j) {
      const int from = same.root(static_cast<int>(j)), to = same.root(static_cast<int>(next(j)));
      if (!is_transverse(j) || from == to) continue;
      const double weight = 1.0 / length(curve(j));
      a(from, from) += weight;
      a(to, to) += weight;
      a(from, to) -= weight;
      a(to, from) -= weight;
      b(to) += sign(j);
      b(from) -= sign(j);
    }
    for (Eigen::Index j = 0; j < n; ++j)
      if (j == 0 || same.root(static_cast<int>(j)) != j) {  // fixed at 0, or not used
        a.row(j).setZero();
        a.col(j).setZero();
        a(j, j) = 1.0;
        b(j) = 0.0;
      }
    const Eigen::VectorXd root = a.ldlt().solve(b);
    std::vector<double> out;
    for (std::size_t j = 0; j < loop_.size(); ++j)
      out.push_back(root[same.root(static_cast<int>(j))]);
    return out;
  }

  bool is_forward(const std::vector<double>& i) const {
    for (std::size_t j = 0; j < loop_.size(); ++j)
      if (is_transverse(j) && !(sign(j) * (i[next(j)] - i[j]) > 2 * seen_.coincidence))
        return false;
    return true;
  }

  /// Vertices that lie over each other, and that the lengths bring near each other.
  void join_stacked(Forest& same) const {
    constexpr double kNear = 0.1;  // of the face's width
    const auto [low, high] = std::ranges::minmax(i_);
    for (std::size_t a = 0; a < loop_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (is_seen(a) && is_seen(b) && level(a) != level(b) &&
            std::abs(i_[a] - i_[b]) < kNear * (high - low) &&
            (seen_start(a) - seen_start(b)).norm() <= 2 * seen_.coincidence)
          same.join(static_cast<int>(a), static_cast<int>(b));
  }

  /// Makes equal what differs by less than the model's own gaps.
  void gather() {
    std::vector<double> sorted = i_;
    std::ranges::sort(sorted);
    for (double& i : i_) {
      auto at = std::ranges::lower_bound(sorted, i);
      while (at != sorted.begin() && *at - *std::prev(at) <= seen_.coincidence) --at;
      i = *at;
    }
  }

  // --- strips -----------------------------------------------------------------------------------

  Rung rung(std::size_t j) const {
    Rung out{i_[j], i_[next(j)], walls_.level[loop_[j].edge.index], curve(j)};
    if (loop_[j].reversed != (sign(j) < 0)) std::ranges::reverse(out.line);
    if (sign(j) < 0) std::swap(out.first, out.last);
    return out;
  }

  const Rung& top_above(const Rung& bottom, const std::vector<Rung>& tops, double a,
                        double b) const {
    const Rung* out = nullptr;
    for (const Rung& top : tops)
      if (top.level > bottom.level && top.first <= a && b <= top.last &&
          (!out || top.level < out->level))
        out = &top;
    if (!out) refuse("has an edge with no edge above it");
    return *out;
  }

  Panel strip(const Rung& bottom, const std::vector<Rung>& tops, double a, double b) const {
    const Rung& top = top_above(bottom, tops, a, b);
    const Polyline low = bottom.between(a, b), high = top.between(a, b);
    Panel panel{face_, bottom.level, top.level, {0.0, 1.0}, {{}, {}}};
    for (const double share : shares_of(low, high)) {
      panel.line[0].push_back(at_arc(low, share * length(low)).point);
      panel.line[1].push_back(at_arc(high, share * length(high)).point);
    }
    const Panel ruled = panel;
    const Side left = side(a, ruled, false), right = side(b, ruled, true);
    std::set<double> shares;
    for (const Side* s : {&left, &right})
      for (const auto& [share, point] : *s) shares.insert(share);
    panel.share.assign(shares.begin(), shares.end());
    panel.line.clear();
    for (const double share : shares)
      panel.line.push_back(with_ends(ruled.at(share), on(left, share), on(right, share)));
    return panel;
  }

  /// Where the end of a strip passes, by share of its height: on its rungs and through vertices.
  using Side = std::map<double, Point2>;

  Side side(double i, const Panel& strip, bool is_last) const {
    const auto end = [&](const Polyline& l) { return is_last ? l.back() : l.front(); };
    const double low = height_.at(strip.low), high = height_.at(strip.high);
    Side out{{0.0, end(strip.line[0])}, {1.0, end(strip.line[1])}};
    for (std::size_t j = 0; j < loop_.size(); ++j) {
      if (i_[j] != i || !is_seen(j) || level(j) <= strip.low || level(j) >= strip.high) continue;
      const double share = (height_.at(level(j)) - low) / (high - low);
      if (0.0 < share && share < 1.0) out.emplace(share, seen_start(j));
    }
    return out;
  }

  static Point2 on(const Side& side, double share) {
    const auto above = side.lower_bound(share);
    if (above->first == share) return above->second;
    const auto below = std::prev(above);
    const double f = (share - below->first) / (above->first - below->first);
    return below->second + f * (above->second - below->second);
  }

  /// Parts of the length at which either line has a point.
  static std::vector<double> shares_of(const Polyline& a, const Polyline& b) {
    std::set<double> shares;
    for (const Polyline* l : {&a, &b})
      for (const double arc : arc_lengths(*l)) shares.insert(arc / length(*l));
    return {shares.begin(), shares.end()};
  }

  const Walls& walls_;
  const Reference& seen_;
  const LevelHeights& height_;
  const FaceId face_;
  const Loop& loop_;
  std::vector<Direction> direction_;  ///< by coedge
  std::vector<double> i_;             ///< by coedge, of its start
};

}  // namespace

std::vector<Panel> leaning_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                                  const Reference& seen, const LevelHeights& height, FaceId face) {
  return LeaningFace(model, scheme, walls, seen, height, face).run();
}

}  // namespace sweepmesh
