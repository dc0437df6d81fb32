#include "sweepmesh/volume/cage.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

constexpr long nodes_per_chunk = 32;

template <class F>
std::vector<Point3> for_inner(const Cage& cage, ThreadTeam& team, const Context& context, F&& f) {
  std::vector<Point3> out(cage.inner.size());
  team.for_chunks(static_cast<long>(out.size()), nodes_per_chunk, [&](long begin, long end, long) {
    context.check("place");
    for (long i = begin; i < end; ++i) out[i] = f(cage.inner_ideal[i]);
  });
  return out;
}

double angle_between(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double sign(double v) {
  return v < 0.0 ? -1.0 : v > 0.0 ? 1.0 : 0.0;
}

/// Adds the weights of one triangle for the point x (Ju, Schaefer, Warren 2005, figure 4). False: x
/// lies on the triangle, and `weight` alone is the answer.
bool mean_value_weights(const Point3 (&p)[3], const Point3& x, Point3& weight) {
  constexpr double small = 1e-12;
  Point3 unit[3], d, theta, c, s;  // s: sine of the dihedral angles of the spherical triangle
  for (int i = 0; i < 3; ++i) {
    d[i] = (p[i] - x).norm();
    unit[i] = (p[i] - x) / d[i];
  }
  for (int i = 0; i < 3; ++i)
    theta[i] = 2.0 * std::asin(std::min(1.0, 0.5 * (unit[(i + 1) % 3] - unit[(i + 2) % 3]).norm()));
  const double h = 0.5 * theta.sum();
  weight.setZero();
  if (std::numbers::pi - h < small) {
    for (int i = 0; i < 3; ++i) weight[i] = std::sin(theta[i]) * d[(i + 1) % 3] * d[(i + 2) % 3];
    return false;
  }
  const double determinant = unit[0].cross(unit[1]).dot(unit[2]);
  for (int i = 0; i < 3; ++i) {
    const double sines = std::sin(theta[(i + 1) % 3]) * std::sin(theta[(i + 2) % 3]);
    c[i] = 2.0 * std::sin(h) * std::sin(h - theta[i]) / sines - 1.0;
    s[i] =
        determinant / sines;  // the same as the root of 1 - c^2, with its sign and all its digits
    if (std::abs(s[i]) <= small) return true;  // in the triangle's plane, outside: no weight
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    weight[i] = (theta[i] - c[j] * theta[k] - c[k] * theta[j]) / (d[i] * std::sin(theta[j]) * s[k]);
  }
  return true;
}

/// Integral over a triangle with apex p (Lipman, Levin, Cohen-Or 2008, appendix; thesis algorithm
/// 6).
double green_integral(const Point3& p, const Point3& v1, const Point3& v2, const Point3& eta) {
  constexpr double flat = 1e-20;  // square of an angle: the triangle is none
  const Point3 a = v2 - v1, b = p - v1, e = v1 - p, f = v2 - p;
  if (std::min(b.squaredNorm(), f.squaredNorm()) <= flat * a.squaredNorm()) return 0.0;
  const double alpha = angle_between(a, b);
  const double beta = angle_between(e, f);
  const double lambda = b.squaredNorm() * std::pow(std::sin(alpha), 2), c = (p - eta).squaredNorm();
  if (lambda <= flat * b.squaredNorm()) return 0.0;
  const auto at = [&](double theta) {
    const double s = std::sin(theta), co = std::cos(theta), s2 = s * s;
    const double first =
        2.0 * std::sqrt(c) * std::atan2(std::sqrt(c) * co, std::sqrt(lambda + s2 * c));
    // The published logarithm, with nothing left in it that cancels: 1 - co and 1 + co by half
    // angles.
    const double less = 2.0 * std::pow(std::sin(0.5 * theta), 2),
                 more = 2.0 * std::pow(std::cos(0.5 * theta), 2);
    const double root = std::sqrt(lambda * lambda + lambda * c * s2);
    const double quotient = (c * less + lambda + root) / (c * more + lambda + root);
    const double logarithm = std::log(2.0 * std::sqrt(lambda) * more / less * quotient);
    return -0.5 * sign(s) * (first + std::sqrt(lambda) * logarithm);
  };
  const double pi = std::numbers::pi;
  return -std::abs(at(pi - alpha) - at(pi - alpha - beta) - std::sqrt(c) * beta) / (4.0 * pi);
}

struct GreenWeights {
  Point3 vertex = Point3::Zero();
  double normal = 0.0;
};

GreenWeights green_weights(const Point3 (&corner)[3], const Point3& eta) {
  constexpr double flat = 1e-10;  // of the triangle's width: the point lies in its plane
  Point3 v[3], n[3];
  for (int l = 0; l < 3; ++l) v[l] = corner[l] - eta;
  const Point3 normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
  const Point3 p = v[0].dot(normal) * normal, zero = Point3::Zero();
  double sum = 0.0;
  Point3 omega = zero;
  for (int l = 0; l < 3; ++l) {
    const Point3 &a = v[l], &b = v[(l + 1) % 3];
    const double side = sign((a - p).cross(b - p).dot(normal));
    if (side != 0.0) sum += side * green_integral(p, a, b, zero);
    n[l] = b.cross(a).normalized();
    omega += n[l] * green_integral(zero, b, a, zero);
  }
  const double integral = -std::abs(sum);
  omega += normal * integral;
  GreenWeights w;
  w.normal = -integral;
  // Seen from its own plane a triangle fills no angle, so its vertices weigh nothing.
  if (p.norm() > flat * (v[1] - v[0]).norm())
    for (int l = 0; l < 3; ++l) w.vertex[l] = n[(l + 1) % 3].dot(omega) / n[(l + 1) % 3].dot(v[l]);
  return w;
}

/// How much a triangle is stretched (ibid., equation 14).
double stretch(const Point3 (&a)[3], const Point3 (&b)[3]) {
  const Point3 u = a[1] - a[0], v = a[2] - a[0], u2 = b[1] - b[0], v2 = b[2] - b[0];
  const double area = 0.5 * u.cross(v).norm();
  const double square = u2.squaredNorm() * v.squaredNorm() - 2.0 * u2.dot(v2) * u.dot(v) +
                        v2.squaredNorm() * u.squaredNorm();
  return std::sqrt(std::max(0.0, square)) / (std::sqrt(8.0) * area);
}

[[noreturn]] void refuse(const char* why) {
  throw InputError("place", std::string("A cage of these runs has no idealised prism: ") + why);
}

/// The level at which all runs begin, or at which all end.
int common_level(const Extrusion& x) {
  const auto is_one = [](const std::vector<int>& v) {
    return std::all_of(v.begin(), v.end(), [&](int k) { return k == v.front(); });
  };
  if (x.n_cells() == 0) refuse("there is none.");
  if (is_one(x.cell_k_low) && is_one(x.k_low)) return x.k_low.front();
  if (is_one(x.cell_k_high) && is_one(x.k_high)) return x.k_high.front();
  refuse("they neither begin nor end at one level.");
}

/// Half the sum of a x b over the cells' sides: the normal of the base at a level.
Point3 base_normal(const Extrusion& x, const Points& points, int level) {
  const Point3 origin = points.row(x.node(0, level));
  Point3 sum = Point3::Zero();
  for (int c = 0; c < x.n_cells(); ++c)
    for (int i = 0, n = x.cell_size(c); i < n; ++i) {
      const int* columns = x.cell_columns.data() + x.cell_offset[c];
      sum += (Point3(points.row(x.node(columns[i], level))) - origin)
                 .cross(Point3(points.row(x.node(columns[(i + 1) % n], level))) - origin);
    }
  return sum.normalized();
}

using NodeTriangles = std::vector<std::array<long, 3>>;

void add_caps(const Extrusion& x, NodeTriangles& triangles) {
  for (int c = 0; c < x.n_cells(); ++c)
    for (int i = 1; i + 1 < x.cell_size(c); ++i) {
      const int* columns = x.cell_columns.data() + x.cell_offset[c];
      const int low = x.cell_k_low[c], high = x.cell_k_high[c];
      triangles.push_back(
          {x.node(columns[0], low), x.node(columns[i + 1], low), x.node(columns[i], low)});
      triangles.push_back(
          {x.node(columns[0], high), x.node(columns[i], high), x.node(columns[i + 1], high)});
    }
}

/// Sides of cells, layer by layer, that no other run has on its other side.
void add_sides(const Extrusion& x, NodeTriangles& triangles) {
  std::map<std::array<int, 2>, std::vector<int>> cells;  // by directed side
  const auto for_sides = [&](auto&& f) {
    for (int c = 0; c < x.n_cells(); ++c)
      for (int i = 0, n = x.cell_size(c); i < n; ++i)
        f(c, x.cell_columns[x.cell_offset[c] + i], x.cell_columns[x.cell_offset[c] + (i + 1) % n]);
  };
  for_sides([&](int c, int a, int b) { cells[{a, b}].push_back(c); });
  for_sides([&](int c, int a, int b) {
    const auto across = cells.find({b, a});
    for (int k = x.cell_k_low[c]; k < x.cell_k_high[c]; ++k) {
      const bool is_inside = across != cells.end() &&
                             std::any_of(across->second.begin(), across->second.end(), [&](int o) {
                               return x.cell_k_low[o] <= k && k < x.cell_k_high[o];
                             });
      if (is_inside) continue;
      triangles.push_back({x.node(a, k), x.node(b, k), x.node(b, k + 1)});
      triangles.push_back({x.node(a, k), x.node(b, k + 1), x.node(a, k + 1)});
    }
  });
}

/// Positions of all nodes on the prism.
std::vector<Point3> ideal_nodes(const Extrusion& x, const BaseMetric& metric,
                                const Points& points) {
  const int level = common_level(x);
  const Point3 direction = base_normal(x, points, level);
  std::vector<Point3> ideal(x.n_nodes());
  for (int c = 0; c < x.n_columns(); ++c) {
    ideal[x.node(c, level)] = points.row(x.node(c, level));
    for (int k = level; k < x.k_high[c]; ++k)
      ideal[x.node(c, k + 1)] = ideal[x.node(c, k)] + metric.height_of(k) * direction;
    for (int k = level; k > x.k_low[c]; --k)
      ideal[x.node(c, k - 1)] = ideal[x.node(c, k)] - metric.height_of(k - 1) * direction;
  }
  return ideal;
}

}  // namespace

Cage make_cage(const Extrusion& extrusion, const std::vector<char>& fixed, const BaseMetric& metric,
               const Points& points) {
  const std::vector<Point3> ideal = ideal_nodes(extrusion, metric, points);
  NodeTriangles triangles;
  add_caps(extrusion, triangles);
  add_sides(extrusion, triangles);
  std::vector<int> vertex(extrusion.n_nodes(), -1);
  for (const auto& t : triangles)
    for (const long node : t) vertex[node] = 0;
  Cage cage;
  for (long node = 0; node < extrusion.n_nodes(); ++node) {
    if ((vertex[node] == 0) != (fixed[node] != 0))
      refuse("nodes are fixed inside, or free on the boundary.");
    if (fixed[node]) {
      vertex[node] = static_cast<int>(cage.node.size());
      cage.node.push_back(node);
      cage.ideal.push_back(ideal[node]);
      cage.actual.push_back(points.row(node));
    } else {
      cage.inner.push_back(node);
      cage.inner_ideal.push_back(ideal[node]);
    }
  }
  for (const auto& t : triangles)
    cage.triangles.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
  return cage;
}

std::vector<Point3> mean_value_positions(const Cage& cage, ThreadTeam& team,
                                         const Context& context) {
  return for_inner(cage, team, context, [&](const Point3& x) {
    Point3 sum = Point3::Zero();
    double total = 0.0;
    for (const auto& t : cage.triangles) {
      const Point3 corner[3] = {cage.ideal[t[0]], cage.ideal[t[1]], cage.ideal[t[2]]};
      Point3 w;
      const bool goes_on = mean_value_weights(corner, x, w);
      if (!goes_on) {
        sum.setZero();
        total = 0.0;
      }
      for (int i = 0; i < 3; ++i) sum += w[i] * cage.actual[t[i]];
      total += w.sum();
      if (!goes_on) break;
    }
    return Point3(sum / total);
  });
}

std::vector<Point3> green_positions(const Cage& cage, ThreadTeam& team, const Context& context) {
  std::vector<Point3> push;  // per triangle: normal of its image times its stretch
  for (const auto& t : cage.triangles) {
    const Point3 a[3] = {cage.ideal[t[0]], cage.ideal[t[1]], cage.ideal[t[2]]};
    const Point3 b[3] = {cage.actual[t[0]], cage.actual[t[1]], cage.actual[t[2]]};
    push.push_back(stretch(a, b) * (b[1] - b[0]).cross(b[2] - b[0]).normalized());
  }
  return for_inner(cage, team, context, [&](const Point3& x) {
    Point3 sum = Point3::Zero();
    for (std::size_t j = 0; j < cage.triangles.size(); ++j) {
      const auto& t = cage.triangles[j];
      const Point3 corner[3] = {cage.ideal[t[0]], cage.ideal[t[1]], cage.ideal[t[2]]};
      const GreenWeights w = green_weights(corner, x);
      for (int i = 0; i < 3; ++i) sum += w.vertex[i] * cage.actual[t[i]];
      sum += w.normal * push[j];
    }
    return sum;
  });
}

std::vector<Point3> rbf_positions(const Cage& cage, ThreadTeam& team, const Context& context) {
  constexpr int most = 4000;
  const int m = static_cast<int>(cage.ideal.size());
  if (m > most)
    throw InputError("place", "Radial basis functions are solved densely, for up to " +
                                  std::to_string(most) + " boundary nodes; this mesh has " +
                                  std::to_string(m) + ".");
  const auto kernel = [](const Point3& a, const Point3& b) {
    return std::pow((a - b).squaredNorm(), 1.5);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(m + 4, m + 4),
                  right = Eigen::MatrixXd::Zero(m + 4, 3);
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < i; ++j) matrix(i, j) = matrix(j, i) = kernel(cage.ideal[i], cage.ideal[j]);
    matrix.block<1, 3>(i, m) = cage.ideal[i].transpose();
    matrix.block<3, 1>(m, i) = cage.ideal[i];
    matrix(i, m + 3) = matrix(m + 3, i) = 1.0;
    right.row(i) = (cage.actual[i] - cage.ideal[i]).transpose();
  }
  context.check("place");
  const Eigen::MatrixXd w = matrix.partialPivLu().solve(right);
  return for_inner(cage, team, context, [&](const Point3& x) {
    Point3 d = (x.transpose() * w.middleRows<3>(m) + w.row(m + 3)).transpose();
    for (int j = 0; j < m; ++j) d += kernel(cage.ideal[j], x) * w.row(j).transpose();
    return Point3(x + d);
  });
}

}  // namespace sweepmesh
