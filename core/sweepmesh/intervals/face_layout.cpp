#include "sweepmesh/intervals/face_layout.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace sweepmesh {
namespace {

using Lines = std::vector<std::vector<std::vector<Point2>>>;

Point2 whole_periods(const Point2& from, const Point2& to, const Point2& periods) {
  Point2 shift = Point2::Zero();
  for (int d = 0; d < 2; ++d)
    if (periods[d] > 0.0) shift[d] = periods[d] * std::round((to[d] - from[d]) / periods[d]);
  return shift;
}

Point2 uv_at(const Model& model, const Coedge& c, double fraction) {
  const auto [first, last] = model.range(c);
  return model.uv(
      c, c.reversed ? last - fraction * (last - first) : first + fraction * (last - first));
}

/// Centre of the box around a loop's vertices and the middles of its edges.
Point2 centre_of(const Model& model, const Loop& loop, const std::vector<Point2>& shift) {
  const double far = std::numeric_limits<double>::max();
  Point2 low(far, far), high = -low;
  for (std::size_t c = 0; c < loop.size(); ++c)
    for (const double f : {0.0, 0.5}) {
      const Point2 p = uv_at(model, loop[c], f) + shift[c];
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return 0.5 * (low + high);
}

Lines sampled(const Model& model, FaceId face) {
  const int n_pieces = 8;
  const auto& loops = model.loops(face);
  const auto shift = unwrapping(model, face);
  Lines lines(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t c = 0; c < loops[l].size(); ++c) {
      lines[l].emplace_back();
      for (int s = 0; s <= n_pieces; ++s)
        lines[l].back().push_back(uv_at(model, loops[l][c], double(s) / n_pieces) + shift[l][c]);
    }
  return lines;
}

/// Mean lengths of d/du and d/dv along the boundary.
Point2 mean_scale(const Model& model, FaceId face, const Lines& lines) {
  Point2 sum = Point2::Zero();
  int n = 0;
  for (const auto& loop : lines)
    for (const auto& line : loop) {
      const auto d = model.derivatives(face, line[line.size() / 2]);
      sum += Point2(d.col(0).norm(), d.col(1).norm());
      ++n;
    }
  return sum / n;
}

/// Sum of the chords along i and of those along k, as columns, over a range of loops.
Eigen::Matrix2d chord_sums(const FaceScheme& scheme, const Lines& lines, std::size_t n_loops) {
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  for (std::size_t l = 0; l < n_loops; ++l)
    for (std::size_t c = 0; c < lines[l].size(); ++c) {
      const Direction d = scheme.direction[l][c];
      const bool forward = d == Direction::plus_i || d == Direction::plus_k;
      const Point2 chord = lines[l][c].back() - lines[l][c].front();
      sums.col(is_axial(d) ? 1 : 0) += forward ? chord : Point2(-chord);
    }
  return sums;
}

/// Mean directions of i and k as columns: those of the outer loop (holes may be turned in the
/// face), or of all loops where it has none. False where there are none, or next to parallel ones.
bool find_frame(const FaceScheme& scheme, const Lines& lines, Eigen::Matrix2d& frame) {
  const double least_sine = 0.1;
  for (const std::size_t n_loops : {std::size_t{1}, lines.size()}) {
    frame = chord_sums(scheme, lines, n_loops);
    const double along_i = frame.col(0).norm(), along_k = frame.col(1).norm();
    if (along_i == 0.0 || along_k == 0.0) continue;
    frame.col(0) /= along_i;
    frame.col(1) /= along_k;
    if (std::abs(frame.determinant()) > least_sine) return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<Point2>> unwrapping(const Model& model, FaceId face) {
  const Point2 periods = model.periods(face);
  const auto& loops = model.loops(face);
  std::vector<std::vector<Point2>> shift(loops.size());
  Point2 first_centre = Point2::Zero();
  for (std::size_t l = 0; l < loops.size(); ++l) {
    Point2 end = uv_at(model, loops[l].front(), 0.0);
    for (const Coedge& c : loops[l]) {
      shift[l].push_back(whole_periods(uv_at(model, c, 0.0), end, periods));
      end = uv_at(model, c, 1.0) + shift[l].back();
    }
    const Point2 centre = centre_of(model, loops[l], shift[l]);
    if (l == 0) first_centre = centre;
    const Point2 nearer = whole_periods(centre, first_centre, periods);
    for (Point2& s : shift[l]) s += nearer;
  }
  return shift;
}

FaceLayout lay_out(const Model& model, const FaceScheme& scheme, FaceId face) {
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop)
      if (!c.edge.is_valid()) return {};
  FaceLayout out{sampled(model, face)};
  const Point2 scale = mean_scale(model, face, out.line);
  for (auto& loop : out.line)
    for (auto& line : loop)
      for (Point2& p : line) p = p.cwiseProduct(scale);
  Eigen::Matrix2d frame;
  if (!find_frame(scheme, out.line, frame)) return {};
  const Eigen::Matrix2d to_frame = frame.inverse();
  for (auto& loop : out.line)
    for (auto& line : loop)
      for (Point2& p : line) p = to_frame * p;
  return out;
}

}  // namespace sweepmesh
