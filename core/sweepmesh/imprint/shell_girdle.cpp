#include "sweepmesh/imprint/shell_girdle.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sweepmesh/surface/cap_boundary.h"

namespace sweepmesh {
namespace {

struct Ball {
  FaceId face;
  Point3 centre;
  double radius = 0.0;
  std::vector<Point3> poles;     ///< directions from the centre
  std::vector<Point3> boundary;  ///< directions from the centre
};

/// The sphere nearest to the surface: |p|^2 = 2 c p + b in the least squares sense.
void fit_sphere(const Model& model, Ball& ball) {
  constexpr int n = 12;
  const auto [low, high] = model.uv_bounds(ball.face);
  Eigen::Matrix<double, n * n, 4> left;
  Eigen::Matrix<double, n * n, 1> right;
  const Point3 origin = model.point(ball.face, low);
  for (int i = 0; i < n * n; ++i) {
    const Point2 share((i % n + 0.5) / n, (i / n + 0.5) / n);
    const Point3 p = model.point(ball.face, low + share.cwiseProduct(high - low)) - origin;
    left.row(i) << 2.0 * p.transpose(), 1.0;
    right[i] = p.squaredNorm();
  }
  const Eigen::Vector4d x = left.colPivHouseholderQr().solve(right);
  ball.centre = origin + x.head<3>();
  ball.radius = std::sqrt(std::max(0.0, x[3] + x.head<3>().squaredNorm()));
}

Ball ball_of(const Model& model, FaceId face) {
  constexpr int n_samples = 12;
  Ball ball{face, {}, 0.0, {}, {}};
  fit_sphere(model, ball);
  const auto direction = [&](const Point3& p) { return Point3((p - ball.centre).normalized()); };
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop)
      if (!c.edge.is_valid())
        ball.poles.push_back(direction(model.point(face, model.uv(c, model.range(c).first))));
  for (const Loop& loop : bounding_loops(model, face))
    for (const Coedge& c : loop) {
      const auto [first, last] = model.range(c.edge);
      for (int i = 0; i < n_samples; ++i)
        ball.boundary.push_back(
            direction(model.point(c.edge, first + (last - first) * i / n_samples)));
    }
  return ball;
}

/// Least angle between the girdle's plane and what it should stay away from.
double clearance(const Ball& ball, const Point3& normal) {
  double least = std::numbers::pi / 2;
  for (const auto* list : {&ball.poles, &ball.boundary})
    for (const Point3& d : *list)
      least = std::min(least, std::asin(std::min(1.0, std::abs(d.dot(normal)))));
  return least;
}

std::vector<Point3> candidate_normals(const Ball& a, const Ball& b) {
  std::vector<Point3> out = a.poles;
  out.insert(out.end(), b.poles.begin(), b.poles.end());
  const Point3 z = out.empty() ? Point3::UnitZ() : out.front();
  const Point3 x = z.unitOrthogonal(), y = z.cross(x);
  constexpr int n = 4;  // a grid on the faces of a cube
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
      out.push_back((z + s * x + t * y).normalized());
      out.push_back((x + s * y + t * z).normalized());
      out.push_back((y + s * z + t * x).normalized());
    }
  return out;
}

/// The surface's parameters in directions around the centre; empty where it is not met there.
std::vector<Point2> around(const Model& model, const Ball& ball, const Point3& x, const Point3& y) {
  constexpr int n = 64;
  constexpr double most_off = 0.2;  // radians
  std::vector<Point2> out;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    const Point3 d = std::cos(angle) * x + std::sin(angle) * y;
    Point2 uv = model.project(ball.face, ball.centre + ball.radius * d);
    const double reach = (model.point(ball.face, uv) - ball.centre).dot(d);
    uv = model.project(ball.face, ball.centre + reach * d);
    const Point3 p = model.point(ball.face, uv) - ball.centre;
    if (p.normalized().cross(d).norm() > most_off || p.dot(d) <= 0.0) return {};
    out.push_back(uv);
  }
  return out;
}

}  // namespace

std::optional<Girdle> find_girdle(const Model& model, FaceId source, FaceId target) {
  const Ball high = ball_of(model, source), low = ball_of(model, target);
  constexpr double least_clearance = 0.05, clear = 1e-3;
  Girdle girdle;
  double best = least_clearance;
  for (const Point3& n : candidate_normals(high, low)) {
    const double c = std::min(clearance(high, n), clearance(low, n));
    if (c < best + clear) continue;
    best = c;
    girdle.normal = n;
  }
  if (best <= least_clearance) return std::nullopt;
  const Point3 x = girdle.normal.unitOrthogonal();
  Point3 y = girdle.normal.cross(x);
  const Point2 there = model.project(source, high.centre + high.radius * x);
  if (model.normal(source, there).dot(x) < 0.0) y = -y;
  girdle.high_centre = high.centre;
  girdle.high = around(model, high, x, y);
  girdle.low = around(model, low, x, y);
  if (girdle.high.empty() || girdle.low.empty()) return std::nullopt;
  return girdle;
}

}  // namespace sweepmesh
