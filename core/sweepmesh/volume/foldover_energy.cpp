#include "sweepmesh/volume/foldover_energy.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace sweepmesh {
namespace {

/// Patches with more free nodes are scaled by the diagonal alone: the factor would not fit in
/// memory.
constexpr int largest_factored = 20000;

Eigen::Matrix3d jacobian(const CornerTet& corner, const Points& x) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i)
    edges.col(i) = (x.row(corner.node[i + 1]) - x.row(corner.node[0])).transpose();
  return edges * corner.ideal;
}

Eigen::Matrix3d cofactors(const Eigen::Matrix3d& j) {
  Eigen::Matrix3d c;
  c.col(0) = j.col(1).cross(j.col(2));
  c.col(1) = j.col(2).cross(j.col(0));
  c.col(2) = j.col(0).cross(j.col(1));
  return c;
}

void add_to_nodes(const CornerTet& corner, int n_free, const Eigen::Matrix3d& by_jacobian,
                  Points& gradient) {
  const Eigen::Matrix3d by_edges = by_jacobian * corner.ideal.transpose();
  for (int i = 0; i < 3; ++i) {
    const Eigen::RowVector3d g = by_edges.col(i).transpose();
    if (corner.node[i + 1] < n_free) gradient.row(corner.node[i + 1]) += g;
    if (corner.node[0] < n_free) gradient.row(corner.node[0]) -= g;
  }
}

/// Solves with the matrix of sum tr(J^T J) / 3 over the free nodes, the same for x, y and z.
class FirstMatrix {
 public:
  explicit FirstMatrix(const UnfoldProblem& problem) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const CornerTet& corner : problem.corners) {
      Eigen::Matrix<double, 4, 3> rows;  // J = sum over nodes of position times row
      rows.bottomRows<3>() = corner.ideal;
      rows.row(0) = -corner.ideal.colwise().sum();
      const Eigen::Matrix4d m = rows * rows.transpose() * (2.0 / 3.0);
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
          if (corner.node[a] < problem.n_free && corner.node[b] < problem.n_free)
            entries.emplace_back(corner.node[a], corner.node[b], m(a, b));
    }
    Eigen::SparseMatrix<double> matrix(problem.n_free, problem.n_free);
    matrix.setFromTriplets(entries.begin(), entries.end());
    diagonal_ = matrix.diagonal();
    if (problem.n_free <= largest_factored) factor_.compute(matrix);
    is_factored_ = problem.n_free <= largest_factored && factor_.info() == Eigen::Success;
  }

  Points solve(const Points& g) const {
    if (!is_factored_) return diagonal_.cwiseInverse().asDiagonal() * g;
    Points x(g.rows(), 3);
    for (int d = 0; d < 3; ++d) x.col(d) = factor_.solve(Eigen::VectorXd(g.col(d)));
    return x;
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::VectorXd diagonal_;
  bool is_factored_ = false;
};

/// Takes from the rows of sliding nodes what leaves their planes.
void keep_in_planes(const UnfoldProblem& problem, Points& rows) {
  for (const auto& [node, normal] : problem.sliding) {
    const Eigen::RowVector3d n = normal.transpose();
    rows.row(node) -= rows.row(node).dot(n) * n;
  }
}

double product(const Points& a, const Points& b) {
  return a.cwiseProduct(b).sum();
}

/// The pairs of steps and changes of gradient that L-BFGS remembers (Nocedal and Wright, 7.2).
class Memory {
 public:
  void add(Points step, Points change) {
    const double sy = product(step, change);
    if (!(sy > 0.0)) return;
    pairs_.push_back({std::move(step), std::move(change), 1.0 / sy});
    if (pairs_.size() > 8) pairs_.pop_front();
  }
  void clear() { pairs_.clear(); }

  Points direction(const Points& gradient, const FirstMatrix& first) const {
    Points q = gradient;
    std::vector<double> a(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      a[i] = pairs_[i].rho * product(pairs_[i].step, q);
      q -= a[i] * pairs_[i].change;
    }
    Points r = first.solve(q);
    if (!pairs_.empty()) {
      const Pair& last = pairs_.back();
      r /= last.rho * product(last.change, first.solve(last.change));
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      r += (a[i] - pairs_[i].rho * product(pairs_[i].change, r)) * pairs_[i].step;
    return -r;
  }

 private:
  struct Pair {
    Points step, change;
    double rho;
  };
  std::deque<Pair> pairs_;
};

/// One round: up to max_steps steps with one eps. Returns the energy.
double descend(const UnfoldProblem& problem, const FirstMatrix& first, double eps,
               const UnfoldOptions& options, const Context& context, Points& x) {
  constexpr double sufficient = 1e-4;  // Armijo's constant
  constexpr int max_halvings = 30;
  Points gradient(problem.n_free, 3), next_gradient(problem.n_free, 3);
  double energy = foldover_energy(problem, x, eps, options, &gradient);
  Memory memory;
  for (int step = 0; step < options.max_steps; ++step) {
    context.check("place");
    Points direction = memory.direction(gradient, first);
    keep_in_planes(problem, direction);
    double slope = product(gradient, direction);
    if (!(slope < 0.0)) break;
    double length = 1.0, next = energy;
    Points trial = x;
    int halving = 0;
    for (; halving < max_halvings; ++halving, length *= 0.5) {
      trial.topRows(problem.n_free) = x.topRows(problem.n_free) + length * direction;
      next = foldover_energy(problem, trial, eps, options, &next_gradient);
      if (next <= energy + sufficient * length * slope) break;
    }
    if (halving == max_halvings) break;
    memory.add(length * direction, next_gradient - gradient);
    const double decrease = (energy - next) / energy;
    x = trial;
    gradient = next_gradient;
    energy = next;
    if (decrease < 0.01 * options.stop_at_decrease) break;
  }
  return energy;
}

}  // namespace

double foldover_energy(const UnfoldProblem& problem, const Points& x, double eps,
                       const UnfoldOptions& options, Points* gradient) {
  if (gradient) gradient->setZero(problem.n_free, 3);
  double energy = 0.0;
  for (const CornerTet& corner : problem.corners) {
    const Eigen::Matrix3d j = jacobian(corner, x), cofactor = cofactors(j);
    const double d = j.col(0).dot(cofactor.col(0)), trace = j.squaredNorm();
    const double root = std::sqrt(eps * eps + d * d);
    // For d < 0 the sum cancels; the quotient is the same number.
    const double chi = d > 0.0 ? 0.5 * (d + root) : 0.5 * eps * eps / (root - d);
    const double slope = chi / root;  // of chi
    const double power = std::cbrt(chi * chi);
    const double shape = trace / (3.0 * power), volume = 0.5 * (d * d + 1.0) / chi;
    const double one = shape + options.volume_weight * volume;
    const double less = std::pow(one, options.power - 1);
    energy += less * one;
    if (!gradient) continue;
    const double by_d =
        -2.0 / 3.0 * shape * slope / chi + options.volume_weight * (d - volume * slope) / chi;
    add_to_nodes(corner, problem.n_free,
                 options.power * less * ((2.0 / (3.0 * power)) * j + by_d * cofactor), *gradient);
  }
  if (gradient) keep_in_planes(problem, *gradient);
  return energy;
}

double least_determinant(const UnfoldProblem& problem, const Points& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const CornerTet& corner : problem.corners)
    least = std::min(least, jacobian(corner, x).determinant());
  return least;
}

double minimise_foldover(const UnfoldProblem& problem, Points& x, const UnfoldOptions& options,
                         const Context& context) {
  constexpr double smallest_eps = 1e-6;
  const FirstMatrix first(problem);
  constexpr int most_idle = 3;  // rounds that unfold nothing more
  double least = least_determinant(problem, x), last = 0.0;
  int n_idle = 0;
  for (int round = 0; round < options.max_rounds; ++round) {
    // The schedule of the paper's listing: eps follows the worst determinant down.
    const double folded = std::min(least, 0.0);
    const double eps = std::sqrt(smallest_eps * smallest_eps + 0.04 * folded * folded);
    const double energy = descend(problem, first, eps, options, context, x);
    const double before = least;
    least = least_determinant(problem, x);
    const bool has_settled =
        round > 0 && std::abs(last - energy) <= options.stop_at_decrease * last;
    if (least > 0.0 && has_settled) break;
    n_idle = least <= 0.0 && least <= before + options.stop_at_decrease * std::abs(before)
                 ? n_idle + 1
                 : 0;
    if (n_idle == most_idle) break;
    last = energy;
  }
  return least;
}

}  // namespace sweepmesh
