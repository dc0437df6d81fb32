#include "sweepmesh/surface/foldover_free_2d.h"

#include <Eigen/Eigenvalues>
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

/// Share of the worst negative determinant that eps takes first, and its floor (determinants are scaled to 1).
constexpr double eps_share = 0.2;
constexpr double eps_floor = 1e-8;
/// Least part by which chi of the worst determinant falls from step to step.
constexpr double least_fall = 0.1;
constexpr int max_stalled_steps = 12;
constexpr int max_halvings = 40;
constexpr double sufficient_decrease = 1e-4;

/// The energy of one triangle as a function of its Jacobian's four entries (row by row).
struct Density {
  double value = 0.0;
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

Density density(const Eigen::Matrix2d& j, double share, double eps) {
  const double d = j.determinant();
  const double s = std::sqrt(eps * eps + d * d);
  const double x = chi(eps, d), x1 = x / s, x2 = 0.5 * eps * eps / (s * s * s);
  const double h = 0.5 * ((1.0 - share) * j.squaredNorm() + share * (1.0 + d * d));
  const Vector4 a(j(0, 0), j(0, 1), j(1, 0), j(1, 1));
  const Vector4 c(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));  // derivative of the determinant
  const double in_norm = 0.5 * (1.0 - share) / x;
  const double in_det = share * d / x - h * x1 / (x * x);
  const double mixed = -0.5 * (1.0 - share) * x1 / (x * x);
  const double in_det2 = share / x - 2.0 * share * d * x1 / (x * x) -
                         h * (x2 / (x * x) - 2.0 * x1 * x1 / (x * x * x));
  Density e;
  e.value = h / x;
  e.gradient = 2.0 * in_norm * a + in_det * c;
  e.hessian = 2.0 * in_norm * Matrix4::Identity() + in_det2 * c * c.transpose() +
              2.0 * mixed * (a * c.transpose() + c * a.transpose());
  e.hessian(0, 3) += in_det, e.hessian(3, 0) += in_det;
  e.hessian(1, 2) -= in_det, e.hessian(2, 1) -= in_det;
  return e;
}

Matrix4 positive_part(const Matrix4& m) {
  const Eigen::LLT<Matrix4> cholesky(m);
  if (cholesky.info() == Eigen::Success) return m;
  const Eigen::SelfAdjointEigenSolver<Matrix4> eigen(m);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

class Minimiser {
 public:
  Minimiser(const std::vector<Point2>& points, const std::vector<char>& fixed,
            const std::vector<MapTriangle>& triangles, const Metric& metric,
            const FoldoverOptions& options, const Context& context)
      : points_(points), triangles_(triangles), metric_(metric), options_(options), context_(context) {
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

  /// Garanzha et al., eq. 8: chi of the worst determinant falls by the part by which the energy fell.
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

  void assemble(double eps, std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& gradient) const {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Density e = density(jacobian(points_, t), options_.area_share, eps);
      const Eigen::Matrix<double, 4, 6> b = jacobian_derivative(t);
      const double w = triangles_[t].weight;
      const Vector6 g = w * b.transpose() * e.gradient;
      const Matrix6 h = w * b.transpose() * positive_part(e.hessian) * b;
      scatter(triangles_[t].node, g, h, entries, gradient);
    }
  }

  void scatter(const std::array<int, 3>& nodes, const Vector6& g, const Matrix6& h,
               std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& gradient) const {
    for (int a = 0; a < 6; ++a) {
      const int row = unknown_[nodes[a / 2]];
      if (row < 0) continue;
      gradient[2 * row + a % 2] += g[a];
      for (int b = 0; b < 6; ++b) {
        const int column = unknown_[nodes[b / 2]];
        if (column >= 0 && 2 * row + a % 2 >= 2 * column + b % 2)
          entries.emplace_back(2 * row + a % 2, 2 * column + b % 2, h(a, b));
      }
    }
  }

  Eigen::VectorXd direction(const std::vector<Eigen::Triplet<double>>& entries,
                            const Eigen::VectorXd& gradient) {
    Eigen::SparseMatrix<double> h(2 * n_unknowns_, 2 * n_unknowns_);
    h.setFromTriplets(entries.begin(), entries.end());
    const double shift = std::sqrt(std::numeric_limits<double>::epsilon()) * h.diagonal().mean();
    for (int i = 0; i < h.rows(); ++i) h.coeffRef(i, i) += shift;
    if (!is_analysed_) solver_.analyzePattern(h);
    is_analysed_ = true;
    solver_.factorize(h);
    if (solver_.info() != Eigen::Success) return -gradient / h.diagonal().maxCoeff();
    return -solver_.solve(gradient);
  }

  /// One Newton step with a backtracking line search; gives the energy afterwards.
  double step(double eps, double before, bool must_stay_valid) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * n_unknowns_);
    assemble(eps, entries, gradient);
    const Eigen::VectorXd d = direction(entries, gradient);
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
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool is_analysed_ = false;
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
    Point2 centre = Point2::Zero();
    for (const int node : cell) centre += ideal[node] / n;
    const Eigen::Matrix2d root = ideal_metric ? ideal_metric(centre) : Eigen::Matrix2d::Identity();
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
