#include "sweepmesh/surface/worst_first.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/surface/foldover_free_2d.h"

namespace sweepmesh {
namespace {

constexpr int max_rounds = 6;
constexpr int rings = 4;
constexpr double sharpness = 3.0;  // weight of a cell: (1 / scaled Jacobian) to this power
constexpr double heaviest = 1e4;

std::vector<double> cell_sizes(const PlanarMesh& mesh, const std::vector<Point2>& points,
                               const Metric& metric) {
  std::vector<double> out;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    std::vector<Point2> corners;
    Point2 centre = Point2::Zero();
    for (const int node : mesh.cell(c)) {
      corners.push_back(points[node]);
      centre += points[node] / static_cast<double>(mesh.cell(c).size());
    }
    const double area = signed_area(corners) * (metric ? metric(centre).determinant() : 1.0);
    const double of_unit_edge = corners.size() == 3 ? 0.25 * std::sqrt(3.0) : 1.0;
    out.push_back(std::sqrt(area / of_unit_edge));
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
  for (int c = 0; c < mesh.n_cells(); ++c) out.push_back(scaled_jacobian(points, mesh.cell(c), metric));
  return out;
}

}  // namespace

std::vector<Point2> with_worst_raised(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                      double limit, const Metric& metric, const Context& context) {
  std::vector<Point2> best = points, now = points;
  std::vector<double> jacobians = scaled_jacobians(mesh, points, metric);
  double worst = jacobians.empty() ? 1.0 : *std::min_element(jacobians.begin(), jacobians.end());
  if (worst >= limit || worst <= 0.0) return best;
  const std::vector<char> fixed = fixed_but_near(mesh, jacobians, limit);
  FoldoverOptions options;
  options.area_share = 0.05;
  options.max_iterations = 12;
  std::vector<double> weight(mesh.n_cells(), 1.0);
  for (int round = 0; round < max_rounds; ++round) {
    std::vector<MapTriangle> corners = corners_regular(mesh, cell_sizes(mesh, now, metric));
    std::size_t corner = 0;
    for (int c = 0; c < mesh.n_cells(); ++c) {
      weight[c] = std::min(heaviest, std::sqrt(weight[c]) * std::pow(1.0 / jacobians[c], sharpness));
      for (std::size_t i = 0; i < mesh.cell(c).size(); ++i) corners[corner++].weight = weight[c];
    }
    std::erase_if(corners, [&](const MapTriangle& t) {
      return std::all_of(t.node.begin(), t.node.end(), [&](int node) { return fixed[node]; });
    });
    now = minimise_foldover(now, fixed, corners, metric, options, context).points;
    jacobians = scaled_jacobians(mesh, now, metric);
    const double value = *std::min_element(jacobians.begin(), jacobians.end());
    if (value <= 0.0) break;
    if (value > worst) worst = value, best = now;
  }
  return best;
}

}  // namespace sweepmesh
