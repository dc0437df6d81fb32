#include "sweepmesh/surface/mean_value_2d.h"

#include <Eigen/SparseLU>
#include <cmath>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

struct Contribution {
  int node, neighbour;
  double weight;
};

/// What one cell's corner adds to the weights of its two edges; negative where it has no meaning.
void add_corner(const PlanarMesh& mesh, std::span<const int> cell, std::size_t i,
                const Eigen::Matrix2d& root, std::vector<Contribution>& out) {
  const std::size_t n = cell.size();
  const int node = cell[i], next = cell[(i + 1) % n], previous = cell[(i + n - 1) % n];
  const Point2 a = root * (mesh.points[next] - mesh.points[node]);
  const Point2 b = root * (mesh.points[previous] - mesh.points[node]);
  const double lengths = a.norm() * b.norm(), area = cross2(a, b);
  // tan(angle / 2) = sin / (1 + cos)
  const double tangent = area > 0.0 ? area / (lengths + a.dot(b)) : -1.0;
  out.push_back({node, next, tangent < 0.0 ? -1.0 : tangent / a.norm()});
  out.push_back({node, previous, tangent < 0.0 ? -1.0 : tangent / b.norm()});
}

std::vector<Contribution> contributions(const PlanarMesh& mesh, int n_fixed, const Metric& metric) {
  std::vector<Contribution> out;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const Eigen::Matrix2d root = metric_at(metric, mesh.points, cell);
    for (std::size_t i = 0; i < cell.size(); ++i)
      if (cell[i] >= n_fixed) add_corner(mesh, cell, i, root, out);
  }
  return out;
}

void weigh_alike_where_meaningless(std::vector<Contribution>& all, int n_nodes) {
  std::vector<char> is_meaningless(n_nodes, 0);
  for (const auto& c : all)
    if (!(c.weight >= 0.0) || !std::isfinite(c.weight)) is_meaningless[c.node] = 1;
  for (auto& c : all)
    if (is_meaningless[c.node]) c.weight = 1.0;
}

}  // namespace

std::vector<Point2> harmonic_extension(const PlanarMesh& mesh, const std::vector<Point2>& boundary,
                                       const Metric& metric) {
  const int n_fixed = static_cast<int>(boundary.size());
  const int n_free = mesh.n_nodes() - n_fixed;
  std::vector<Point2> out = boundary;
  if (n_free <= 0) return out;
  auto all = contributions(mesh, n_fixed, metric);
  weigh_alike_where_meaningless(all, mesh.n_nodes());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n_free);
  for (const auto& c : all) sum[c.node - n_fixed] += c.weight;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n_free, 2);
  for (int i = 0; i < n_free; ++i) entries.emplace_back(i, i, 1.0);
  for (const auto& c : all) {
    const int row = c.node - n_fixed;
    const double share = c.weight / sum[row];
    if (c.neighbour < n_fixed)
      right.row(row) += share * boundary[c.neighbour].transpose();
    else
      entries.emplace_back(row, c.neighbour - n_fixed, -share);
  }
  Eigen::SparseMatrix<double> matrix(n_free, n_free);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw SolverError("surface",
                      "The harmonic map of a cap has no solution: its mesh is not connected.");
  const Eigen::MatrixX2d inside = solver.solve(right);
  for (int i = 0; i < n_free; ++i) out.emplace_back(inside.row(i).transpose());
  return out;
}

}  // namespace sweepmesh
