#include "sweepmesh/imprint/polyline.h"

#include <algorithm>
#include <cmath>

namespace sweepmesh {

std::vector<double> arc_lengths(const Polyline& line) {
  std::vector<double> arc(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    arc[i] = arc[i - 1] + (line[i] - line[i - 1]).norm();
  return arc;
}

double length(const Polyline& line) {
  return arc_lengths(line).back();
}

PolylinePoint at_arc(const Polyline& line, double arc) {
  const std::vector<double> arcs = arc_lengths(line);
  const auto upper = std::upper_bound(arcs.begin(), arcs.end() - 1, arc);
  const std::size_t i = upper == arcs.begin() ? 0 : upper - arcs.begin() - 1;
  const std::size_t j = std::min(i, line.size() - 2);
  const double step = arcs[j + 1] - arcs[j];
  const double f = step > 0.0 ? std::clamp((arc - arcs[j]) / step, 0.0, 1.0) : 0.0;
  return {line[j] + f * (line[j + 1] - line[j]), arcs[j] + f * step, static_cast<double>(j) + f};
}

PolylinePoint at_position(const Polyline& line, double position) {
  const std::size_t last = line.size() - 2;
  const std::size_t i = std::min(static_cast<std::size_t>(std::max(position, 0.0)), last);
  const double f = std::clamp(position - static_cast<double>(i), 0.0, 1.0);
  double arc = 0.0, next = 0.0;
  for (std::size_t j = 0; j <= i; ++j) {
    arc = next;
    next += (line[j + 1] - line[j]).norm();
  }
  return {line[i] + f * (line[i + 1] - line[i]), arc + f * (next - arc),
          static_cast<double>(i) + f};
}

Point2 point_at(const Polyline& line, double position) {
  const std::size_t last = line.size() - 2;
  const std::size_t i = std::min(static_cast<std::size_t>(std::max(position, 0.0)), last);
  const double f = std::clamp(position - static_cast<double>(i), 0.0, 1.0);
  return line[i] + f * (line[i + 1] - line[i]);
}

PolylinePoint nearest(const Polyline& line, const Point2& p) {
  SegmentPlace least{0.0, std::numeric_limits<double>::infinity()};
  std::size_t best = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const SegmentPlace place = nearest_on_segment(line[i], line[i + 1], p);
    if (place.squared >= least.squared) continue;
    least = place;
    best = i;
  }
  PolylinePoint out = at_position(line, static_cast<double>(best) + least.share);
  out.distance = std::sqrt(least.squared);
  return out;
}

std::vector<PolylinePoint> resampled(const Polyline& line, double spacing) {
  std::vector<PolylinePoint> out;
  double arc = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double step = (line[i + 1] - line[i]).norm();
    const int n = std::max(1, static_cast<int>(std::ceil(step / spacing)));
    for (int j = 0; j < n; ++j) {
      const double f = static_cast<double>(j) / n;
      out.push_back(
          {line[i] + f * (line[i + 1] - line[i]), arc + f * step, static_cast<double>(i) + f});
    }
    arc += step;
  }
  out.push_back({line.back(), arc, static_cast<double>(line.size() - 1)});
  return out;
}

Polyline part(const Polyline& line, double first_position, double last_position) {
  Polyline out = {at_position(line, first_position).point};
  const auto add = [&](const Point2& p) {
    if (p != out.back()) out.push_back(p);
  };
  for (std::size_t i = static_cast<std::size_t>(first_position) + 1;
       i < line.size() && static_cast<double>(i) < last_position; ++i)
    add(line[i]);
  const Point2 end = at_position(line, last_position).point;
  if (out.size() == 1 || end != out.back()) out.push_back(end);
  return out;
}

Polyline with_ends(const Polyline& line, const Point2& first, const Point2& last) {
  const Point2 d0 = first - line.front(), d1 = last - line.back();
  const std::vector<double> arcs = arc_lengths(line);
  Polyline out = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double f = arcs.back() > 0.0 ? arcs[i] / arcs.back() : 0.0;
    out[i] += (1.0 - f) * d0 + f * d1;
  }
  out.front() = first;
  out.back() = last;
  return out;
}

Polyline with_ends_only(const Polyline& line, const Point2& first, const Point2& last) {
  Polyline out = line;
  out.front() = first;
  out.back() = last;
  return out;
}

Polyline apart_from_ends(const Polyline& line, double distance) {
  Polyline out = {line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if ((line[i] - line.front()).norm() > distance && (line[i] - line.back()).norm() > distance)
      out.push_back(line[i]);
  out.push_back(line.back());
  return out;
}

Box2 box_of(const Polyline& line) {
  Box2 box{line.front(), line.front()};
  for (const Point2& p : line) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

}  // namespace sweepmesh
