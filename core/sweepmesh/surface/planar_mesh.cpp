#include "sweepmesh/surface/planar_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sweepmesh {

std::vector<Point2> flattened(const PlanarLoops& loops) {
  std::vector<Point2> out;
  for (const auto& loop : loops) out.insert(out.end(), loop.begin(), loop.end());
  return out;
}

double signed_area(std::span<const Point2> loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross2(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return 0.5 * twice;
}

double regular_area(int n) {
  if (n == 3) return 0.25 * std::sqrt(3.0);
  return n == 4 ? 1.0 : 0.25 * n / std::tan(std::numbers::pi / n);
}

Eigen::Matrix2d metric_at(const Metric& metric, std::span<const Point2> points,
                          std::span<const int> cell) {
  if (!metric) return Eigen::Matrix2d::Identity();
  Point2 centre = Point2::Zero();
  for (const int node : cell) centre += points[node] / static_cast<double>(cell.size());
  return metric(centre);
}

double scaled_jacobian(std::span<const Point2> points, std::span<const int> cell,
                       const Metric& metric) {
  const int n = static_cast<int>(cell.size());
  const Eigen::Matrix2d root = metric_at(metric, points, cell);
  double least = 1.0;
  for (int i = 0; i < n; ++i) {
    const Point2 next = root * (points[cell[(i + 1) % n]] - points[cell[i]]);
    const Point2 previous = root * (points[cell[(i + n - 1) % n]] - points[cell[i]]);
    const double lengths = next.norm() * previous.norm();
    least = std::min(least, lengths > 0.0 ? cross2(next, previous) / lengths : 0.0);
  }
  return n == 4 ? least : std::min(1.0, least / std::sin(2.0 * std::numbers::pi / n));
}

PlanarQuality quality(std::span<const Point2> points, const PlanarMesh& mesh,
                      const Metric& metric) {
  PlanarQuality q;
  double sum = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const double value = scaled_jacobian(points, mesh.cell(c), metric);
    q.min = std::min(q.min, value);
    q.n_inverted += value <= 0.0;
    sum += value;
  }
  if (mesh.n_cells() > 0) q.mean = sum / mesh.n_cells();
  return q;
}

NodeCells cells_at_nodes(const PlanarMesh& mesh) {
  NodeCells out;
  out.offset.assign(mesh.n_nodes() + 1, 0);
  for (const int node : mesh.cell_nodes) ++out.offset[node + 1];
  for (int i = 0; i < mesh.n_nodes(); ++i) out.offset[i + 1] += out.offset[i];
  out.cells.resize(mesh.cell_nodes.size());
  std::vector<int> at(out.offset.begin(), out.offset.end() - 1);
  for (int c = 0; c < mesh.n_cells(); ++c)
    for (const int node : mesh.cell(c)) out.cells[at[node]++] = c;
  return out;
}

}  // namespace sweepmesh
