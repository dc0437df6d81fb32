#include "sweepmesh/surface/parameter_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/cap_periods.h"

namespace sweepmesh {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

[[noreturn]] void refuse(FaceId face) {
  throw InputError(
      "surface",
      name_of(face) + " closes on itself in a way that cannot be meshed as a cap; split it.",
      {name_of(face)});
}

UnwrappedLoop unwrapped(const std::vector<CapNode>& loop, const Point2& periods) {
  std::vector<Point2> uv;
  for (const CapNode& node : loop) uv.push_back(node.uv);
  return unwrapped_loop(uv, periods);
}

/// Whether a loop reaches all around without closing there: a band that is cut from rim to rim.
bool is_cut_open(const CapLoops& loops, const Point2& periods) {
  constexpr double whole = 0.99;  // of a period
  return std::any_of(loops.begin(), loops.end(), [&](const auto& loop) {
    const UnwrappedLoop u = unwrapped(loop, periods);
    Point2 low = u.uv.front(), high = low;
    for (const Point2& p : u.uv) low = low.cwiseMin(p), high = high.cwiseMax(p);
    return ((high - low).array() >= whole * periods.array() && periods.array() > 0.0).any();
  });
}

/// Mean lengths of the two derivatives over a few points of the face's bounds.
Point2 mean_lengths(const Model& model, FaceId face) {
  constexpr int n = 5;
  const auto [low, high] = model.uv_bounds(face);
  Point2 sum = Point2::Zero();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point2 share((i + 0.5) / n, (j + 0.5) / n);
      const auto d = model.derivatives(face, low + share.cwiseProduct(high - low));
      sum += Point2(d.col(0).norm(), d.col(1).norm()) / (n * n);
    }
  return sum;
}

/// Longest length in space of the parameter line `axis` = `value` within the bounds.
double line_length(const Model& model, FaceId face, int axis, double value) {
  constexpr int n = 5;
  const auto [low, high] = model.uv_bounds(face);
  double longest = 0.0;
  for (int i = 0; i < n; ++i) {
    Point2 uv = low + (i + 0.5) / n * (high - low);
    uv[axis] = value;
    longest = std::max(longest, model.derivatives(face, uv).col(1 - axis).norm());
  }
  return longest * (high - low)[1 - axis];
}

}  // namespace

ParameterPlane::ParameterPlane(const Model& model, FaceId face, const CapLoops& loops,
                               std::optional<int> outer)
    : model_(&model), face_(face) {
  if (!model.is_planar(face)) periods_ = closing_periods(model, face);
  if (model.is_planar(face))
    lay_planar(loops);
  else if (find_axis(loops, outer))
    lay_polar(loops);
  else
    lay_scaled(loops);
}

void ParameterPlane::lay_planar(const CapLoops& loops) {
  kind_ = Kind::planar;
  const auto [low, high] = model_->uv_bounds(face_);
  const Point2 middle = 0.5 * (low + high);
  const Point3 normal = model_->normal(face_, middle);
  origin_ = model_->point(face_, middle);
  axes_.col(0) = model_->derivatives(face_, middle).col(0).normalized();
  axes_.col(1) = normal.cross(axes_.col(0)).normalized();
  for (const auto& loop : loops) {
    loops_.emplace_back();
    for (const CapNode& node : loop)
      loops_.back().push_back(axes_.transpose() * (node.point - origin_));
  }
}

/// Decides whether the domain is polar: around which parameter, and where the centre is.
bool ParameterPlane::find_axis(const CapLoops& loops, std::optional<int> outer) {
  Eigen::Vector2i turning = Eigen::Vector2i::Zero(), sum = Eigen::Vector2i::Zero();
  for (const auto& loop : loops) {
    const UnwrappedLoop u = unwrapped(loop, periods_);
    turning += u.turns.cwiseAbs();
    sum += u.turns;
  }
  const double tolerance = model_->tolerances().point;
  const auto [low, high] = model_->uv_bounds(face_);
  if (turning.x() > 0 && turning.y() > 0) refuse(face_);
  std::optional<double> pole;
  for (int axis = 0; axis < 2; ++axis) {  // a pole is a line of constant `axis` without length
    if (turning[axis] > 0) continue;
    for (const double value : {low[axis], high[axis]}) {
      if (line_length(*model_, face_, axis, value) > 10.0 * tolerance) continue;
      const int around = 1 - axis;
      // Where the domain turns around, the pole is inside if one loop alone does, on its left.
      const bool is_at_high = value == high[axis];
      const bool is_left = (around == 0) == is_at_high;
      if (turning[around] > 0 && sum[around] != (is_left ? 1 : -1)) continue;
      if (!pole) pole = value, along_v_ = around == 1;
    }
  }
  if (turning.sum() == 0) {
    if (is_cut_open(loops, periods_)) return false;
    if (pole) across_of_centre_ = along_v_ ? -*pole : *pole;
    return pole.has_value();
  }
  along_v_ = turning.y() > 0;
  if (turning.sum() > 2 || (turning.sum() == 1) != pole.has_value()) refuse(face_);
  scale_.x() = full_turn / periods_[along_v_];
  if (pole) {
    across_of_centre_ = along_v_ ? -*pole : *pole;
    return true;
  }
  lay_centre_of_band(!outer || unwrapped(loops[*outer], periods_).turns[along_v_] > 0);
  return true;
}

/// A band's circumference at the centre's side becomes that of the inner circle. The loop that has
/// the domain on its left when it turns by +1 is the one at the low end of `across`.
void ParameterPlane::lay_centre_of_band(bool is_at_high) {
  const auto [low, high] = model_->uv_bounds(face_);
  const double low_end = turned(along_v_ ? high : low).y(),
               high_end = turned(along_v_ ? low : high).y();
  const double end = is_at_high ? high_end : low_end;
  const int axis = along_v_ ? 0 : 1;
  const double around = line_length(*model_, face_, axis, along_v_ ? -end : end);
  const double beyond = around / full_turn / mean_lengths(*model_, face_)[axis];
  across_of_centre_ = is_at_high ? end + beyond : end - beyond;
}

void ParameterPlane::lay_polar(const CapLoops& loops) {
  kind_ = Kind::polar;
  const Point2 lengths = mean_lengths(*model_, face_);
  const auto [low, high] = model_->uv_bounds(face_);
  const double period = periods_[along_v_];
  scale_.x() = full_turn / (period > 0.0 ? period : 2.0 * (high - low)[along_v_]);
  const double middle = turned(0.5 * (low + high)).y();
  // The radius falls towards the centre; seen the other way round the angle has to be turned.
  scale_.y() = (middle < across_of_centre_ ? -1.0 : 1.0) * lengths[along_v_ ? 0 : 1];
  for (const auto& loop : loops) {
    loops_.emplace_back();
    for (const CapNode& node : loop) {
      const Point2 st = turned(node.uv);
      const double radius = scale_.y() * (st.y() - across_of_centre_);
      const double angle = (scale_.y() < 0.0 ? 1.0 : -1.0) * scale_.x() * st.x();
      loops_.back().push_back(radius * Point2(std::cos(angle), std::sin(angle)));
    }
  }
  const auto is_outer = [](const auto& loop) { return signed_area(loop) > 0.0; };
  if (std::count_if(loops_.begin(), loops_.end(), is_outer) != 1) refuse(face_);
}

void ParameterPlane::lay_scaled(const CapLoops& loops) {
  kind_ = Kind::scaled;
  scale_ = mean_lengths(*model_, face_);
  std::vector<UnwrappedLoop> all;
  int outer = -1;
  for (const auto& loop : loops) {
    all.push_back(unwrapped(loop, periods_));
    if (signed_area(all.back().uv) > 0.0) outer = static_cast<int>(all.size()) - 1;
  }
  if (outer < 0) refuse(face_);
  Point2 low = all[outer].uv[0], high = low;
  for (const Point2& p : all[outer].uv) low = low.cwiseMin(p), high = high.cwiseMax(p);
  for (auto& loop : all) {
    Point2 shift = Point2::Zero();
    if (&loop != &all[outer])
      shift = nearest_period(loop.uv[0], 0.5 * (low + high), periods_) - loop.uv[0];
    loops_.emplace_back();
    for (const Point2& p : loop.uv) loops_.back().push_back(scale_.cwiseProduct(p + shift));
  }
}

Point2 ParameterPlane::uv(const Point2& p) const {
  if (kind_ == Kind::planar) return model_->project(face_, in_space(p));
  Point2 uv = p.cwiseQuotient(scale_);
  if (kind_ == Kind::polar) {
    const double angle = (scale_.y() < 0.0 ? 1.0 : -1.0) * std::atan2(p.y(), p.x());
    uv = turned_back({angle / scale_.x(), across_of_centre_ + p.norm() / scale_.y()});
  }
  const auto [low, high] = model_->uv_bounds(face_);
  return nearest_period(uv, 0.5 * (low + high), periods_);
}

}  // namespace sweepmesh
