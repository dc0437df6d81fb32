#include "sweepmesh/imprint/sweep_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "sweepmesh/imprint/axial_edges.h"

namespace sweepmesh {
namespace {

/// The frame's axis at another place: turned as the tangent turns.
Point3 transported(const SweepPath::Station& from, const Point3& tangent) {
  return Eigen::Quaterniond::FromTwoVectors(from.tangent, tangent) * from.axis;
}

/// The cubic with these ends and the tangents scaled to the chord.
Point3 hermite(const SweepPath::Station& a, const SweepPath::Station& b, double u) {
  const double l = b.length - a.length, v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * a.point + u * u * (1.0 + 2.0 * v) * b.point +
         u * v * v * l * a.tangent - u * u * v * l * b.tangent;
}

/// An axial edge in a chain that is as long as any that ends with it.
struct Link {
  double length = 0.0;  ///< of the chain
  int before = -1;      ///< axial edge; -1: the chain begins here
};

double angle_between(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Of chains of axial edges from low to high the longest, as places in `edges`; the first of those
/// equally long but for rounding. Empty where they lead around in a circle.
std::vector<int> longest_chain(const Model& model, const std::vector<AxialEdge>& edges) {
  const double tie = model.tolerances().relative * model.tolerances().model_size;
  std::map<VertexId, std::vector<int>> leaving;
  std::map<VertexId, int> n_arriving;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    leaving[edges[e].low].push_back(e);
    ++n_arriving[edges[e].high];
  }
  std::vector<Link> link(edges.size());
  std::map<VertexId, Link> longest;  // chain up to the vertex; `before` is its last edge
  std::vector<VertexId> open;
  for (const auto& [v, e] : leaving)
    if (!n_arriving.contains(v)) open.push_back(v);
  std::size_t n_seen = 0;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (const int e : leaving[open[i]]) {
      ++n_seen;
      link[e] = longest[open[i]];
      const double length = link[e].length + model.length(edges[e].edge);
      Link& there = longest[edges[e].high];
      if (length > there.length + tie) there = {length, e};
      if (--n_arriving[edges[e].high] == 0) open.push_back(edges[e].high);
    }
  if (n_seen < edges.size()) return {};
  Link last;
  for (const auto& [v, l] : longest)
    if (l.length > last.length + tie) last = l;
  std::vector<int> out;
  for (int e = last.before; e >= 0; e = link[e].before) out.push_back(e);
  std::ranges::reverse(out);
  return out;
}

}  // namespace

SweepPath::SweepPath(const std::vector<Point3>& points, const std::vector<Point3>& tangents) {
  stations_.push_back({points.front(), tangents.front(), tangents.front().unitOrthogonal(), 0.0});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Station& before = stations_.back();
    const double length = before.length + (points[i] - before.point).norm();
    stations_.push_back({points[i], tangents[i], transported(before, tangents[i]), length});
  }
}

/// Where the plane through `p` meets the path between stations i and i + 1.
SweepPath::Station SweepPath::between(std::size_t i, const Point3& p) const {
  const Station &a = stations_[i], &b = stations_[i + 1];
  const auto at = [&](double u) {
    Station out;
    out.point = hermite(a, b, u);
    out.tangent = ((1.0 - u) * a.tangent + u * b.tangent).normalized();
    out.length = (1.0 - u) * a.length + u * b.length;
    return out;
  };
  double low = 0.0, high = 1.0;
  constexpr int n_halves = 50;  // down to rounding
  for (int h = 0; h < n_halves; ++h) {
    const double middle = (low + high) / 2.0;
    const Station here = at(middle);
    (here.tangent.dot(p - here.point) > 0.0 ? low : high) = middle;
  }
  Station out = at((low + high) / 2.0);
  out.axis = transported(a, out.tangent);
  return out;
}

Point3 SweepPath::straightened(const Point3& p) const {
  std::optional<Station> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Station& s) {
    const double along = s.tangent.dot(p - s.point);
    const double distance = (p - s.point - along * s.tangent).norm();
    if (distance >= least) return;
    least = distance;
    best = s;
  };
  const auto is_past = [&](const Station& s) { return s.tangent.dot(p - s.point) > 0.0; };
  if (!is_past(stations_.front())) offer(stations_.front());
  for (std::size_t i = 0; i + 1 < stations_.size(); ++i)
    if (is_past(stations_[i]) && !is_past(stations_[i + 1])) offer(between(i, p));
  if (is_past(stations_.back())) offer(stations_.back());
  const Point3 from = p - best->point;
  return {best->axis.dot(from), best->tangent.cross(best->axis).dot(from),
          best->length + best->tangent.dot(from)};
}

double SweepPath::turning() const {
  double most = 0.0;
  for (const Station& s : stations_)
    most = std::max(most, angle_between(stations_.front().tangent, s.tangent));
  return most;
}

std::optional<SweepPath> sweep_path(const Model& model, const Scheme& scheme) {
  constexpr double least_turning = std::numbers::pi / 6;
  constexpr int n_parts = 48;  // of an edge
  const auto edges = axial_edges(model, scheme);
  std::vector<Point3> points, tangents;
  for (const int i : longest_chain(model, edges)) {
    const auto [first, last] = model.range(edges[i].edge);
    const bool is_down = model.start(edges[i].edge) != edges[i].low;
    for (int k = 0; k <= n_parts; ++k) {
      const double share = static_cast<double>(is_down ? n_parts - k : k) / n_parts;
      const double t = first + share * (last - first);
      const bool is_joint = k == 0 && !points.empty();
      points.push_back(is_joint ? points.back() : model.point(edges[i].edge, t));
      tangents.push_back((is_down ? -1.0 : 1.0) * model.tangent(edges[i].edge, t));
    }
  }
  if (points.empty()) return {};
  SweepPath path(points, tangents);
  if (path.turning() < least_turning) return {};
  return path;
}

}  // namespace sweepmesh
