#include "sweepmesh/surface/foldover_free_2d.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sweepmesh {
namespace {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Share of the worst negative determinant that eps takes first, and its floor (determinants are
/// scaled to 1).
constexpr double eps_share = 0.2;
constexpr double eps_floor = 1e-8;
/// Least part by which chi of the worst determinant falls from step to step.
constexpr double least_fall = 0.1;
constexpr int max_stalled_steps = 12;
constexpr int max_halvings = 40;
constexpr double sufficient_decrease = 1e-4;

/// The energy of one triangle as a function of its Jacobian's four entries (row by row); the
/// Hessian is projected to positive semidefinite.
struct Density {
  Vector4 gradient = Vector4::Zero();
  Matrix4 hessian = Matrix4::Zero();
};

double chi(double eps, double d) {
  const double s = std::sqrt(eps * eps + d * d);
  // The two forms are equal; each is exact on its side of zero.
  return d >= 0.0 ? 0.5 * (d + s) : 0.5 * eps * eps / (s - d);
}

double density_value(const Eigen::Matrix2d& j, double share, double eps) {
  const double d = j.determinant();
  return 0.5 * ((1.0 - share) * j.squaredNorm() + share * (1.0 + d * d)) / chi(eps, d);
}

/// Derivatives of the density P(n, d) by the squared norm and the determinant; it is linear in n.
struct Derivatives {
  double n, d, nd, dd;
};

Derivatives derivatives(double n, double d, double share, double eps) {
  const double s = std::sqrt(eps * eps + d * d);
  const double x = chi(eps, d), x1 = x / s, x2 = 0.5 * eps * eps / (s * s * s);
  const double h = 0.5 * ((1.0 - share) * n + share * (1.0 + d * d));
  return {0.5 * (1.0 - share) / x, share * d / x - h * x1 / (x * x),
          -0.5 * (1.0 - share) * x1 / (x * x),
          share / x - 2.0 * share * d * x1 / (x * x) -
              h * (x2 / (x * x) - 2.0 * x1 * x1 / (x * x * x))};
}

Eigen::Matrix2d rotation(double angle) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

Vector4 row_by_row(const Eigen::Matrix2d& m) {
  return {m(0, 0), m(0, 1), m(1, 0), m(1, 1)};
}

/// Adds the positive part of the symmetric [[a, b], [b, c]] in the space of two orthonormal
/// vectors.
void add_positive(double a, double b, double c, const Vector4& p, const Vector4& q, Matrix4& out) {
  const double mean = 0.5 * (a + c), radius = std::hypot(0.5 * (a - c), b);
  const double angle = 0.5 * std::atan2(2.0 * b, a - c);
  const Vector4 high = std::cos(angle) * p + std::sin(angle) * q;
  const Vector4 low = std::cos(angle) * q - std::sin(angle) * p;
  out += std::max(0.0, mean + radius) * high * high.transpose() +
         std::max(0.0, mean - radius) * low * low.transpose();
}

/// In the frame of the signed singular values the Hessian falls apart into a twist, a flip and a 2
/// x 2 block.
Density density(const Eigen::Matrix2d& j, double share, double eps) {
  const double e = 0.5 * (j(0, 0) + j(1, 1)), f = 0.5 * (j(0, 0) - j(1, 1));
  const double g = 0.5 * (j(1, 0) + j(0, 1)), h = 0.5 * (j(1, 0) - j(0, 1));
  const double s = std::hypot(e, h) + std::hypot(f, g), t = std::hypot(e, h) - std::hypot(f, g);
  const double left = std::atan2(h, e), right = std::atan2(g, f);
  const Eigen::Matrix2d u = rotation(0.5 * (left + right)), v = rotation(0.5 * (left - right));
  const Derivatives p = derivatives(s * s + t * t, s * t, share, eps);
  Density out;
  out.gradient = 2.0 * p.n * row_by_row(j) + p.d * Vector4(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));
  const Vector4 twist =
      std::sqrt(0.5) * row_by_row(u * (Eigen::Matrix2d() << 0, -1, 1, 0).finished() * v);
  const Vector4 flip =
      std::sqrt(0.5) * row_by_row(u * (Eigen::Matrix2d() << 0, 1, 1, 0).finished() * v);
  out.hessian = std::max(0.0, 2.0 * p.n + p.d) * twist * twist.transpose() +
                std::max(0.0, 2.0 * p.n - p.d) * flip * flip.transpose();
  add_positive(2.0 * p.n + 4.0 * s * t * p.nd + t * t * p.dd,
               p.d + 2.0 * (s * s + t * t) * p.nd + s * t * p.dd,
               2.0 * p.n + 4.0 * s * t * p.nd + s * s * p.dd, row_by_row(u.col(0) * v.row(0)),
               row_by_row(u.col(1) * v.row(1)), out.hessian);
  return out;
}

class Minimiser {
 public:
  Minimiser(const std::vector<Point2>& points, const std::vector<char>& fixed,
            const std::vector<MapTriangle>& triangles, const Metric& metric,
            const FoldoverOptions& options, const Context& context)
      : points_(points),
        triangles_(triangles),
        metric_(metric),
        options_(options),
        context_(context) {
    number_unknowns(fixed);
    update_metric();
  }

  FoldoverResult run() {
    FoldoverResult result;
    double worst = worst_determinant(points_);
    double eps = worst > 0.0 ? eps_floor : eps_floor - eps_share * worst;
    int n_stalled = 0;
    while (result.iterations < options_.max_iterations && n_unknowns_ > 0) {
      context_.check("surface");
      const bool was_valid = worst > 0.0;
      const double before = energy(points_, eps);
      const double after = step(eps, before, was_valid);
      ++result.iterations;
      worst = worst_determinant(points_);
      const bool has_settled = before - after <= options_.tolerance * before;
      n_stalled = has_settled ? n_stalled + 1 : 0;
      if (has_settled && was_valid) break;
      if (n_stalled > max_stalled_steps) break;
      eps = next_eps(eps, worst, 1.0 - after / before);
      update_metric();
      worst = worst_determinant(points_);
    }
    result.is_valid = worst_determinant(points_) > 0.0;
    result.points = std::move(points_);
    return result;
  }

 private:
  void number_unknowns(const std::vector<char>& fixed) {
    std::vector<char> is_used(points_.size(), 0);
    for (const MapTriangle& t : triangles_)
      for (const int node : t.node) is_used[node] = 1;
    unknown_.assign(points_.size(), -1);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (is_used[i] && !fixed[i]) unknown_[i] = n_unknowns_++;
  }

  /// Garanzha et al., eq. 8: chi of the worst determinant falls by the part by which the energy
  /// fell.
  double next_eps(double eps, double worst, double fall) const {
    const double wished = (1.0 - std::max(fall, least_fall)) * chi(eps, worst);
    if (worst >= wished) return eps_floor;
    return std::max(eps_floor, 2.0 * std::sqrt(wished * (wished - worst)));
  }

  void update_metric() {
    roots_.resize(triangles_.size(), Eigen::Matrix2d::Identity());
    if (!metric_) return;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& n = triangles_[t].node;
      roots_[t] = metric_((points_[n[0]] + points_[n[1]] + points_[n[2]]) / 3.0);
    }
  }

  Eigen::Matrix2d jacobian(const std::vector<Point2>& points, std::size_t t) const {
    const auto& n = triangles_[t].node;
    Eigen::Matrix2d edges;
    edges << points[n[1]] - points[n[0]], points[n[2]] - points[n[0]];
    return roots_[t] * edges * triangles_[t].ideal_inverse;
  }

  double worst_determinant(const std::vector<Point2>& points) const {
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      worst = std::min(worst, jacobian(points, t).determinant());
    return worst;
  }

  double energy(const std::vector<Point2>& points, double eps) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      sum += triangles_[t].weight * density_value(jacobian(points, t), options_.area_share, eps);
    return sum;
  }

  /// d(Jacobian entries) / d(coordinates of the three nodes): x0 y0 x1 y1 x2 y2.
  Eigen::Matrix<double, 4, 6> jacobian_derivative(std::size_t t) const {
    const Eigen::Matrix2d& w = triangles_[t].ideal_inverse;
    Eigen::Matrix<double, 4, 6> out;
    for (int node = 0; node < 3; ++node) {
      const Eigen::RowVector2d g = node == 0 ? Eigen::RowVector2d(-w.row(0) - w.row(1))
                                             : Eigen::RowVector2d(w.row(node - 1));
      for (int axis = 0; axis < 2; ++axis)
        for (int entry = 0; entry < 4; ++entry)
          out(entry, 2 * node + axis) = roots_[t](entry / 2, axis) * g(entry % 2);
    }
    return out;
  }

  /// Row of the Hessian for entry a (0..5) of a triangle's own; negative where the node is fixed.
  int row_of(std::size_t t, int a) const {
    const int unknown = unknown_[triangles_[t].node[a / 2]];
    return unknown < 0 ? -1 : 2 * unknown + a % 2;
  }

  /// Builds the Hessian's pattern (lower half) and where each triangle's entries are in it.
  void make_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b <= a; ++b) {
          const int i = row_of(t, a), j = row_of(t, b);
          if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), 0.0);
        }
    hessian_.resize(2 * n_unknowns_, 2 * n_unknowns_);
    hessian_.setFromTriplets(entries.begin(), entries.end());
    const int* outer = hessian_.outerIndexPtr();
    const int* inner = hessian_.innerIndexPtr();
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b <= a; ++b) {
          const int i = row_of(t, a), j = row_of(t, b);
          const int column = std::min(i, j);
          slots_.push_back(column < 0 ? -1
                                      : static_cast<int>(std::lower_bound(inner + outer[column],
                                                                          inner + outer[column + 1],
                                                                          std::max(i, j)) -
                                                         inner));
        }
    solver_.analyzePattern(hessian_);
  }

  void assemble(double eps, Eigen::VectorXd& gradient) {
    if (slots_.empty()) make_pattern();
    double* values = hessian_.valuePtr();
    std::fill_n(values, hessian_.nonZeros(), 0.0);
    std::size_t slot = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Density e = density(jacobian(points_, t), options_.area_share, eps);
      const Eigen::Matrix<double, 4, 6> b = jacobian_derivative(t);
      const Vector6 g = triangles_[t].weight * b.transpose() * e.gradient;
      const Matrix6 h = triangles_[t].weight * b.transpose() * e.hessian * b;
      for (int i = 0; i < 6; ++i) {
        if (const int row = row_of(t, i); row >= 0) gradient[row] += g[i];
        for (int j = 0; j <= i; ++j, ++slot)
          if (slots_[slot] >= 0) values[slots_[slot]] += h(i, j);
      }
    }
  }

  Eigen::VectorXd direction(const Eigen::VectorXd& gradient) {
    const double shift =
        std::sqrt(std::numeric_limits<double>::epsilon()) * hessian_.diagonal().mean();
    for (int i = 0; i < hessian_.cols(); ++i)  // the diagonal comes first in each lower column
      hessian_.valuePtr()[hessian_.outerIndexPtr()[i]] += shift;
    solver_.factorize(hessian_);
    if (solver_.info() != Eigen::Success) return -gradient / hessian_.diagonal().maxCoeff();
    return -solver_.solve(gradient);
  }

  /// One Newton step with a backtracking line search; gives the energy afterwards.
  double step(double eps, double before, bool must_stay_valid) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * n_unknowns_);
    assemble(eps, gradient);
    const Eigen::VectorXd d = direction(gradient);
    const double slope = gradient.dot(d);
    double length = 1.0;
    for (int i = 0; i < max_halvings; ++i, length *= 0.5) {
      std::vector<Point2> trial = moved(d, length);
      if (must_stay_valid && worst_determinant(trial) <= 0.0) continue;
      const double after = energy(trial, eps);
      if (!(after <= before + sufficient_decrease * length * slope)) continue;
      points_ = std::move(trial);
      return after;
    }
    return before;
  }

  std::vector<Point2> moved(const Eigen::VectorXd& d, double length) const {
    std::vector<Point2> out = points_;
    for (std::size_t i = 0; i < out.size(); ++i)
      if (unknown_[i] >= 0) out[i] += length * d.segment<2>(2 * unknown_[i]);
    return out;
  }

  std::vector<Point2> points_;
  const std::vector<MapTriangle>& triangles_;
  const Metric& metric_;
  const FoldoverOptions& options_;
  const Context& context_;
  std::vector<int> unknown_;
  int n_unknowns_ = 0;
  std::vector<Eigen::Matrix2d> roots_;
  Eigen::SparseMatrix<double> hessian_;  ///< lower half
  std::vector<int> slots_;               ///< per triangle 21: where its entries go, -1 for none
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// Edges that leave the corner of a regular polygon, as columns.
Eigen::Matrix2d regular_corner(int n_sides, double edge) {
  const double angle = std::numbers::pi * (1.0 - 2.0 / n_sides);
  Eigen::Matrix2d m;
  m << 1.0, std::cos(angle), 0.0, std::sin(angle);
  return edge * m;
}

double mean_edge(const std::vector<Point2>& points, std::span<const int> cell) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i)
    sum += (points[cell[(i + 1) % cell.size()]] - points[cell[i]]).norm();
  return sum / static_cast<double>(cell.size());
}

/// Below this part of the area that its edges span, a corner is no shape to imitate.
constexpr double flat_corner = 0.05;

}  // namespace

FoldoverResult minimise_foldover(const std::vector<Point2>& points, const std::vector<char>& fixed,
                                 const std::vector<MapTriangle>& triangles, const Metric& metric,
                                 const FoldoverOptions& options, const Context& context) {
  return Minimiser(points, fixed, triangles, metric, options, context).run();
}

std::vector<MapTriangle> corners_like(const PlanarMesh& mesh, const std::vector<Point2>& ideal,
                                      const Metric& ideal_metric) {
  std::vector<MapTriangle> out;
  out.reserve(mesh.cell_nodes.size());
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const int n = static_cast<int>(cell.size());
    const Eigen::Matrix2d root = metric_at(ideal_metric, ideal, cell);
    for (int i = 0; i < n; ++i) {
      const int next = cell[(i + 1) % n], previous = cell[(i + n - 1) % n];
      Eigen::Matrix2d edges;
      edges << ideal[next] - ideal[cell[i]], ideal[previous] - ideal[cell[i]];
      edges = root * edges;
      if (edges.determinant() < flat_corner * edges.col(0).norm() * edges.col(1).norm())
        edges = regular_corner(n, mean_edge(ideal, cell));
      out.push_back({{cell[i], next, previous}, edges.inverse(), 1.0});
    }
  }
  return out;
}

std::vector<MapTriangle> corners_regular(const PlanarMesh& mesh,
                                         const std::vector<double>& edge_length) {
  std::vector<MapTriangle> out;
  out.reserve(mesh.cell_nodes.size());
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const int n = static_cast<int>(cell.size());
    const Eigen::Matrix2d inverse = regular_corner(n, edge_length[c]).inverse();
    for (int i = 0; i < n; ++i)
      out.push_back({{cell[i], cell[(i + 1) % n], cell[(i + n - 1) % n]}, inverse, 1.0});
  }
  return out;
}

}  // namespace sweepmesh
