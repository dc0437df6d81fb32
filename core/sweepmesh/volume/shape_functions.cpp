#include "sweepmesh/volume/shape_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sweepmesh {
namespace {

using Gradient = Eigen::RowVector3d;

/// Corners of the reference cube (-1..1) in VTK's order.
constexpr std::array<std::array<int, 3>, 8> cube = {{{-1, -1, -1},
                                                     {1, -1, -1},
                                                     {1, 1, -1},
                                                     {-1, 1, -1},
                                                     {-1, -1, 1},
                                                     {1, -1, 1},
                                                     {1, 1, 1},
                                                     {-1, 1, 1}}};

/// Gradients of the 20 serendipity functions at xi:
/// corner  N = (1+xX)(1+yY)(1+zZ)(xX+yY+zZ-2)/8,  mid-side e.g. X = 0: N = (1-x^2)(1+yY)(1+zZ)/4.
std::array<Gradient, 20> hexahedron_gradients(const Point3& xi) {
  std::array<Gradient, 20> g;
  for (int n = 0; n < 8; ++n) {
    const Point3 s(cube[n][0], cube[n][1], cube[n][2]);
    const Point3 f = Point3::Ones() + xi.cwiseProduct(s);
    const double sum = xi.dot(s) - 2;
    for (int d = 0; d < 3; ++d) {
      const double others = f[(d + 1) % 3] * f[(d + 2) % 3];
      g[n][d] = s[d] * others * (sum + f[d]) / 8;
    }
  }
  for (int m = 0; m < 12; ++m) {
    const auto& a = cube[hexahedron_sides[m].first];
    const auto& b = cube[hexahedron_sides[m].second];
    Point3 f, df;
    for (int d = 0; d < 3; ++d) {
      const double s = (a[d] + b[d]) / 2.0;
      f[d] = s == 0 ? 1 - xi[d] * xi[d] : 1 + s * xi[d];
      df[d] = s == 0 ? -2 * xi[d] : s;
    }
    for (int d = 0; d < 3; ++d) g[8 + m][d] = df[d] * f[(d + 1) % 3] * f[(d + 2) % 3] / 4;
  }
  return g;
}

/// Gradients of the 15 functions at (r, s, z), z in -1..1, with L = (1-r-s, r, s):
/// corner  L(2L-1)(1 + zZ)/2 - L(1-z^2)/2,  mid of a triangle's side 2 La Lb (1 + zZ),  upright
/// L(1-z^2).
std::array<Gradient, 15> prism_gradients(const Point3& xi) {
  const std::array<double, 3> l = {1 - xi.x() - xi.y(), xi.x(), xi.y()};
  const std::array<Eigen::RowVector2d, 3> dl = {
      {Eigen::RowVector2d(-1, -1), Eigen::RowVector2d(1, 0), Eigen::RowVector2d(0, 1)}};
  const double z = xi.z(), bubble = 1 - z * z;
  std::array<Gradient, 15> g;
  for (int half = 0; half < 2; ++half) {
    const double side = half == 0 ? -1 : 1, h = (1 + side * z) / 2, dh = side / 2;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      g[3 * half + c] << dl[c] * ((4 * l[c] - 1) * h - bubble / 2),
          l[c] * (2 * l[c] - 1) * dh + l[c] * z;
      g[6 + 3 * half + c] << 4 * h * (dl[c] * l[d] + l[c] * dl[d]), 4 * l[c] * l[d] * dh;
    }
  }
  for (int c = 0; c < 3; ++c) g[12 + c] << dl[c] * bubble, -2 * z * l[c];
  return g;
}

template <std::size_t N, std::size_t M>
double determinant(const Points& points, const std::array<int, N>& corners,
                   const std::array<int, M>& mids, const std::array<Gradient, N + M>& gradients) {
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < N; ++n) jacobian += points.row(corners[n]).transpose() * gradients[n];
  for (std::size_t m = 0; m < M; ++m)
    jacobian += points.row(mids[m]).transpose() * gradients[N + m];
  return jacobian.determinant();
}

std::vector<std::array<Gradient, 20>> hexahedron_samples() {
  std::vector<std::array<Gradient, 20>> samples;
  const double gauss = 1 / std::sqrt(3.0);
  for (const auto& c : cube) {
    const Point3 corner(c[0], c[1], c[2]);
    samples.push_back(hexahedron_gradients(corner));
    samples.push_back(hexahedron_gradients(gauss * corner));
  }
  for (const auto& [a, b] : hexahedron_sides)
    samples.push_back(hexahedron_gradients(
        Point3(cube[a][0] + cube[b][0], cube[a][1] + cube[b][1], cube[a][2] + cube[b][2]) / 2));
  return samples;
}

std::vector<std::array<Gradient, 15>> prism_samples() {
  const std::array<Point2, 6> corners_and_mids = {
      {Point2(0, 0), Point2(1, 0), Point2(0, 1), Point2(.5, 0), Point2(.5, .5), Point2(0, .5)}};
  std::vector<std::array<Gradient, 15>> samples;
  for (const double z : {-1.0, -1 / std::sqrt(3.0), 0.0, 1 / std::sqrt(3.0), 1.0})
    for (const Point2& p : corners_and_mids)
      samples.push_back(prism_gradients(Point3(p.x(), p.y(), z)));
  return samples;
}

template <class Samples, class Corners, class Mids>
double smallest(const Points& points, const Corners& corners, const Mids& mids,
                const Samples& samples) {
  double low = std::numeric_limits<double>::infinity();
  for (const auto& gradients : samples)
    low = std::min(low, determinant(points, corners, mids, gradients));
  return low;
}

}  // namespace

double min_jacobian(const Points& points, const std::array<int, 8>& corners,
                    const std::array<int, 12>& mids) {
  static const auto samples = hexahedron_samples();
  return smallest(points, corners, mids, samples);
}

double min_jacobian(const Points& points, const std::array<int, 6>& corners,
                    const std::array<int, 9>& mids) {
  static const auto samples = prism_samples();
  return smallest(points, corners, mids, samples);
}

}  // namespace sweepmesh
