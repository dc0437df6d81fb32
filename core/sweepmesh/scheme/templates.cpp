#include "sweepmesh/scheme/templates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {

namespace {

constexpr double kHalfTurn = 2 * kQuarterTurn;
constexpr int kSamples = 24;

/// A coedge with the corner where it ends.
struct Side {
  EdgeId edge;
  VertexId end;
  double length = 0.0;
  double heading = 0.0;  ///< at its start
  std::array<double, kSamples + 1> turned =
      {};  ///< of its tangent in the face, left positive, so far
  bool is_one_way = true;
  double angle = 0.0;  ///< interior angle at its end

  double turn() const { return turned.back(); }
};

/// Fractions of the curve's parameter range at equal parts of a coedge's length, along the coedge.
std::vector<double> even_fractions(const Model& model, const Coedge& coedge) {
  std::vector<double> out;
  for (int j = 0; j <= kSamples; ++j) out.push_back(static_cast<double>(j) / kSamples);
  out = model.at_length_fractions(coedge.edge, out);
  const auto [first, last] = model.range(coedge.edge);
  for (double& t : out) t = (t - first) / (last - first);
  if (!coedge.reversed) return out;
  std::ranges::reverse(out);
  for (double& t : out) t = 1 - t;
  return out;
}

void measure_turn(const Model& model, const Coedge& coedge, Side& side) {
  const std::vector<double> fractions = even_fractions(model, coedge);
  double before = side.heading = heading(model, coedge, 0.0), turn = 0.0;
  for (int j = 0; j <= kSamples; ++j) {
    const double after = heading(model, coedge, fractions[j]);
    turn += std::remainder(after - before, 2 * kHalfTurn);
    side.turned[j] = turn;
    before = after;
  }
  const auto [least, most] = std::ranges::minmax(side.turned);
  side.is_one_way = most - least < 1.1 * std::abs(turn);
}

std::vector<Side> sides_of(const Model& model, FaceId face, int loop) {
  std::vector<Side> out;
  const Loop& coedges = model.loops(face)[loop];
  for (std::size_t i = 0; i < coedges.size(); ++i) {
    const Coedge& c = coedges[i];
    if (!c.edge.is_valid()) continue;
    Side side{c.edge, c.end, model.length(c.edge)};
    side.angle = model.interior_angle(face, loop, static_cast<int>(i));
    measure_turn(model, c, side);
    out.push_back(side);
  }
  return out;
}

class LoopTemplates {
 public:
  LoopTemplates(std::vector<Side> sides, const TemplateOptions& options)
      : sides_(std::move(sides)), options_(options), virtual_(sides_.size()) {}

  std::vector<FaceCorner> corners() {
    for (const auto& [first, count] : runs()) add_round(first, count);
    for (std::size_t s = 0; s < sides_.size(); ++s) add_chamfer(s);
    std::vector<FaceCorner> out;
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      std::ranges::sort(virtual_[s], {}, &FaceCorner::at);
      out.insert(out.end(), virtual_[s].begin(), virtual_[s].end());
      out.push_back({sides_[s].end, {}, 0.0, sides_[s].angle});
    }
    return out;
  }

 private:
  std::size_t next(std::size_t s) const { return (s + 1) % sides_.size(); }
  std::size_t previous(std::size_t s) const { return (s + sides_.size() - 1) % sides_.size(); }

  bool turns(std::size_t s) const {
    return sides_[s].is_one_way && std::abs(sides_[s].turn()) > options_.tangent_tolerance;
  }

  /// Whether the turn goes on from a side into the next.
  bool goes_on(std::size_t s) const {
    return turns(s) && turns(next(s)) && sides_[s].turn() * sides_[next(s)].turn() > 0 &&
           std::abs(sides_[s].angle - kHalfTurn) < options_.tangent_tolerance;
  }

  /// First side and number of sides of each longest run that turns one way without a corner.
  std::vector<std::pair<std::size_t, std::size_t>> runs() const {
    std::vector<std::pair<std::size_t, std::size_t>> out;
    bool is_round_loop = true;
    for (std::size_t s = 0; s < sides_.size(); ++s) is_round_loop &= goes_on(s);
    if (is_round_loop && !sides_.empty()) return {{0, sides_.size()}};
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      if (!turns(s) || goes_on(previous(s))) continue;
      std::size_t count = 1;
      for (std::size_t at = s; goes_on(at); at = next(at)) ++count;
      out.emplace_back(s, count);
    }
    return out;
  }

  void add_round(std::size_t first, std::size_t count) {
    double turn = 0.0;
    for (std::size_t j = 0, s = first; j < count; ++j, s = next(s)) turn += sides_[s].turn();
    const int n = static_cast<int>(std::lround(std::abs(turn) / kQuarterTurn));
    if (n < 1 || n > 4 || std::abs(std::abs(turn) - n * kQuarterTurn) > options_.turn_tolerance)
      return;
    const double begin = is_loop(first, count) && options_.frame ? half_way(first, turn) : 0.5;
    for (int j = 0; j < n; ++j) add_turn(first, count, (j + begin) / n * std::abs(turn), turn / n);
  }

  bool is_loop(std::size_t first, std::size_t count) const {
    return count == sides_.size() && goes_on((first + count - 1) % sides_.size());
  }

  /// Quarter turns from the start of a side to the first place half way between the directions of
  /// the frame.
  double half_way(std::size_t s, double turn) const {
    const double wanted = *options_.frame + kQuarterTurn / 2 - sides_[s].heading;
    const double turns = (turn > 0 ? wanted : -wanted) / kQuarterTurn;
    return turns - std::floor(turns);
  }

  /// A virtual corner where a run has turned so far, or on a vertex of the run that is as good as
  /// there.
  void add_turn(std::size_t first, std::size_t count, double turned, double turn) {
    constexpr double kOnVertex = 0.05;  // of the side's length
    for (std::size_t j = 0, s = first; j < count; ++j, s = next(s)) {
      const double own = std::abs(sides_[s].turn());
      if (turned > own && j + 1 < count) {
        turned -= own;
        continue;
      }
      const double at = fraction_at(sides_[s], turned);
      if (at > 1 - kOnVertex && j + 1 < count)
        sides_[s].angle = kHalfTurn - turn;
      else if (at < kOnVertex && j > 0)
        sides_[previous(s)].angle = kHalfTurn - turn;
      else
        virtual_[s].push_back({{}, sides_[s].edge, at, kHalfTurn - turn});
      return;
    }
  }

  /// Fraction of a side's length at which it has turned so far.
  static double fraction_at(const Side& side, double turned) {
    for (int j = 1; j <= kSamples; ++j) {
      const double before = std::abs(side.turned[j - 1]), after = std::abs(side.turned[j]);
      if (after < turned) continue;
      const double part = after > before ? (turned - before) / (after - before) : 0.0;
      return (j - 1 + std::clamp(part, 0.0, 1.0)) / kSamples;
    }
    return 1.0;
  }

  /// Angles of 135 and 135 become 180, 90 and 180; angles of 225 and 225 become 180, 270 and 180.
  void add_chamfer(std::size_t s) {
    const std::size_t before = previous(s), after = next(s);
    if (before == after || turns(s)) return;
    const double length = std::min(sides_[before].length, sides_[after].length);
    if (sides_[s].length > options_.chamfer_length * length) return;
    for (double sign : {1.0, -1.0}) {
      const double angle = kHalfTurn - sign * kQuarterTurn / 2;
      if (std::abs(sides_[before].angle - angle) > options_.chamfer_tolerance ||
          std::abs(sides_[s].angle - angle) > options_.chamfer_tolerance)
        continue;
      const double middle = sides_[before].angle + sides_[s].angle - kHalfTurn;
      virtual_[s].push_back({{}, sides_[s].edge, 0.5, middle});
      sides_[before].angle = sides_[s].angle = kHalfTurn;
    }
  }

  std::vector<Side> sides_;
  const TemplateOptions& options_;
  std::vector<std::vector<FaceCorner>> virtual_;  // by side
};

}  // namespace

FaceCorners face_corners(const Model& model, FaceId face) {
  FaceCorners out;
  const auto& loops = model.loops(face);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    out.emplace_back();
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      if (loops[l][i].edge.is_valid())
        out.back().push_back(
            {loops[l][i].end,
             {},
             0.0,
             model.interior_angle(face, static_cast<int>(l), static_cast<int>(i))});
  }
  return out;
}

std::optional<double> frame_of_straight_edges(const Model& model, FaceId face,
                                              const TemplateOptions& options) {
  Point2 sum = Point2::Zero();
  for (std::size_t l = 0; l < model.loops(face).size(); ++l)
    for (const Side& side : sides_of(model, face, static_cast<int>(l))) {
      const auto [least, most] = std::ranges::minmax(side.turned);
      if (most - least > options.tangent_tolerance) continue;
      const double angle = 4 * (side.heading + side.turn() / 2);
      sum += side.length * Point2(std::cos(angle), std::sin(angle));
    }
  if (sum.norm() <= model.tolerances().point) return {};
  return std::atan2(sum.y(), sum.x()) / 4;
}

FaceCorners face_corners_with_templates(const Model& model, FaceId face,
                                        const TemplateOptions& options) {
  TemplateOptions framed = options;
  if (!framed.frame) framed.frame = frame_of_straight_edges(model, face, options);
  FaceCorners out;
  for (std::size_t l = 0; l < model.loops(face).size(); ++l)
    out.push_back(LoopTemplates(sides_of(model, face, static_cast<int>(l)), framed).corners());
  return out;
}

}  // namespace sweepmesh
