#include "sweepmesh/surface/regular_cells.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/mean_value_2d.h"

namespace sweepmesh {
namespace {

std::vector<double> local_sizes(const PlanarMesh& mesh, const Metric& metric) {
  std::vector<double> sum(mesh.n_boundary, 0.0);
  std::vector<int> count(mesh.n_boundary, 0);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const int a = cell[i], b = cell[(i + 1) % cell.size()];
      if (a >= mesh.n_boundary || b >= mesh.n_boundary) continue;
      const Point2 d = mesh.points[b] - mesh.points[a];
      const double length = metric ? (metric(mesh.points[a]) * d).norm() : d.norm();
      for (const int node : {a, b}) sum[node] += length, ++count[node];
    }
  }
  std::vector<Point2> boundary(mesh.n_boundary);
  for (int i = 0; i < mesh.n_boundary; ++i)
    boundary[i] = Point2(sum[i] / std::max(1, count[i]), 0.0);
  const std::vector<Point2> all = harmonic_extension(mesh, boundary, metric);
  std::vector<double> size(mesh.n_cells(), 0.0);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const int n = static_cast<int>(mesh.cell(c).size());
    for (const int node : mesh.cell(c)) size[c] += all[node].x() / n;
    if (n > 4) size[c] *= std::sqrt(2.0 * regular_area(3) / regular_area(n));
  }
  return size;
}

/// Scales the wished sizes so that the wished areas add up to the domain's.
void fit_to_area(std::vector<double>& size, const PlanarMesh& mesh, const Metric& metric) {
  double wished = 0.0, there = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    std::vector<Point2> corners;
    Point2 centre = Point2::Zero();
    for (const int node : cell) {
      corners.push_back(mesh.points[node]);
      centre += mesh.points[node] / static_cast<double>(cell.size());
    }
    there += signed_area(corners) * (metric ? metric(centre).determinant() : 1.0);
    wished += regular_area(static_cast<int>(cell.size())) * size[c] * size[c];
  }
  for (double& s : size) s *= std::sqrt(there / wished);
}

}  // namespace

std::vector<double> wished_lengths(const PlanarMesh& mesh, const Metric& metric) {
  std::vector<double> size = local_sizes(mesh, metric);
  fit_to_area(size, mesh, metric);
  return size;
}

PlanarMesh smoothed(const PlanarMesh& mesh, const Metric& metric, const Context& context) {
  const std::vector<double> size = wished_lengths(mesh, metric);
  std::vector<char> fixed(mesh.n_nodes(), 0);
  std::fill_n(fixed.begin(), mesh.n_boundary, 1);
  FoldoverOptions options;
  options.tolerance = 1e-3;
  PlanarMesh out = mesh;
  out.points =
      minimise_foldover(mesh.points, fixed, corners_regular(mesh, size), metric, options, context)
          .points;
  return out;
}

}  // namespace sweepmesh
