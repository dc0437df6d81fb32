#include "sweepmesh/surface/worst_first.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/surface/foldover_free_2d.h"

namespace sweepmesh {
namespace {

constexpr int rings = 4;
constexpr double sharpness = 3.0;  // weight of a cell: (1 / scaled Jacobian) to this power
constexpr double heaviest = 1e4;

/// The wished edges at corner i of a rectangle whose sides are as long as the quad's are on the
/// mean.
Eigen::Matrix2d rectangle_corner(const std::vector<Point2>& points, std::span<const int> quad,
                                 int i, const Eigen::Matrix2d& root) {
  const auto length = [&](int a) {
    return (root * (points[quad[(a + 1) % 4]] - points[quad[a % 4]])).norm();
  };
  const double along = 0.5 * (length(i) + length(i + 2)),
               across = 0.5 * (length(i + 1) + length(i + 3));
  return Point2(along, across).asDiagonal();
}

/// Corner triangles with the wished shapes, weighted by cell.
std::vector<MapTriangle> weighted_corners(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                          const std::vector<double>& weight, const Metric& metric) {
  std::vector<double> edge(mesh.n_cells(), 1.0);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    std::vector<Point2> corners;
    for (const int node : mesh.cell(c)) corners.push_back(points[node]);
    const double area =
        signed_area(corners) * metric_at(metric, points, mesh.cell(c)).determinant();
    edge[c] = std::sqrt(area / regular_area(static_cast<int>(corners.size())));
  }
  std::vector<MapTriangle> out = corners_regular(mesh, edge);
  std::size_t corner = 0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const Eigen::Matrix2d root = metric_at(metric, points, mesh.cell(c));
    for (int i = 0; i < static_cast<int>(cell.size()); ++i, ++corner) {
      out[corner].weight = weight[c];
      if (cell.size() == 4)
        out[corner].ideal_inverse = rectangle_corner(points, cell, i, root).inverse();
    }
  }
  return out;
}

std::vector<char> fixed_but_near(const PlanarMesh& mesh, const std::vector<double>& jacobians,
                                 double limit) {
  std::vector<char> is_near(mesh.n_nodes(), 0);
  for (int r = 0; r <= rings; ++r) {
    const std::vector<char> before = is_near;
    for (int c = 0; c < mesh.n_cells(); ++c) {
      const auto cell = mesh.cell(c);
      const bool is_seed = r == 0 && jacobians[c] < limit;
      if (is_seed || std::any_of(cell.begin(), cell.end(), [&](int n) { return before[n]; }))
        for (const int node : cell) is_near[node] = 1;
    }
  }
  for (int i = 0; i < mesh.n_nodes(); ++i) is_near[i] = i < mesh.n_boundary || !is_near[i];
  return is_near;
}

std::vector<double> scaled_jacobians(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                     const Metric& metric) {
  std::vector<double> out;
  for (int c = 0; c < mesh.n_cells(); ++c)
    out.push_back(scaled_jacobian(points, mesh.cell(c), metric));
  return out;
}

/// Whether an edge has become much shorter than it was, and next to nothing: angles alone would let
/// cells vanish.
bool has_shrunk(const PlanarMesh& mesh, const std::vector<Point2>& before,
                const std::vector<Point2>& now) {
  constexpr double much = 0.4, nothing = 0.01;  // of its length, of the mean length
  double mean = 0.0;
  const auto each_edge = [&](const auto& f) {
    for (int c = 0; c < mesh.n_cells(); ++c) {
      const auto cell = mesh.cell(c);
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const int a = cell[i], b = cell[(i + 1) % cell.size()];
        f((before[b] - before[a]).norm(), (now[b] - now[a]).norm());
      }
    }
  };
  each_edge([&](double was, double) { mean += was; });
  mean /= static_cast<double>(mesh.cell_nodes.size());
  bool out = false;
  each_edge([&](double was, double is) { out |= is < much * was && is < nothing * mean; });
  return out;
}

}  // namespace

std::vector<Point2> with_worst_raised(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                      double limit, int max_rounds, const Metric& metric,
                                      const Context& context) {
  std::vector<Point2> best = points, now = points;
  std::vector<double> jacobians = scaled_jacobians(mesh, points, metric);
  double worst = jacobians.empty() ? 1.0 : *std::min_element(jacobians.begin(), jacobians.end());
  if (worst >= limit || worst <= 0.0) return best;
  const std::vector<char> fixed = fixed_but_near(mesh, jacobians, limit);
  FoldoverOptions options;
  options.area_share = 0.05;
  options.max_iterations = 8;
  options.tolerance = 1e-3;
  std::vector<double> weight(mesh.n_cells(), 1.0);
  for (int round = 0; round < max_rounds; ++round) {
    for (int c = 0; c < mesh.n_cells(); ++c)
      weight[c] =
          std::min(heaviest, std::sqrt(weight[c]) * std::pow(1.0 / jacobians[c], sharpness));
    std::vector<MapTriangle> corners = weighted_corners(mesh, now, weight, metric);
    std::erase_if(corners, [&](const MapTriangle& t) {
      return std::all_of(t.node.begin(), t.node.end(), [&](int node) { return fixed[node]; });
    });
    now = minimise_foldover(now, fixed, corners, metric, options, context).points;
    jacobians = scaled_jacobians(mesh, now, metric);
    const double value = *std::min_element(jacobians.begin(), jacobians.end());
    if (value <= 0.0 || has_shrunk(mesh, points, now)) break;
    if (value > worst) worst = value, best = now;
    if (worst >= limit) break;
  }
  return best;
}

}  // namespace sweepmesh
