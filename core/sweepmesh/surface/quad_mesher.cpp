#include "sweepmesh/surface/quad_mesher.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sweepmesh/numerics/gmsh/gmsh.h"
#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/mean_value_2d.h"
#include "sweepmesh/surface/quad_cleanup.h"
#include "sweepmesh/surface/quad_templates.h"

namespace sweepmesh {
namespace {

/// A structured mesh as good as this is taken without trying others.
constexpr double good_enough = 0.7;

void check_input(const PlanarLoops& loops, const PlanarMeshOptions& options) {
  if (!(options.size > 0.0) || !std::isfinite(options.size))
    throw InputError("surface", "The element size of a cap must be positive.");
  if (loops.empty()) throw InputError("surface", "A cap without a boundary cannot be meshed.");
  std::size_t n_edges = 0;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    n_edges += loops[l].size();
    if (loops[l].size() < 3)
      throw InputError("surface", "A boundary loop of a cap has fewer than three mesh edges; choose a smaller size.");
    if ((signed_area(loops[l]) > 0.0) != (l == 0))
      throw InputError("surface", "The boundary loops of a cap do not run around its face.");
  }
  if (options.kind == CellKind::quad && n_edges % 2 != 0)
    throw InputError("surface", "A cap's boundary has an odd number of mesh edges, so quads cannot fill it.");
}

/// Shortest by longest edge, the mean over all cells.
double mean_edge_ratio(const PlanarMesh& mesh, const Metric& metric) {
  double sum = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const Eigen::Matrix2d root = metric ? metric(mesh.points[cell[0]]) : Eigen::Matrix2d::Identity();
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const double length = (root * (mesh.points[cell[(i + 1) % cell.size()]] - mesh.points[cell[i]])).norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    sum += shortest / longest;
  }
  return sum / std::max(1, mesh.n_cells());
}

/// How good a mesh is as a whole: the worst cell counts most.
double score(const PlanarMesh& mesh, const Metric& metric) {
  const PlanarQuality q = quality(mesh.points, mesh, metric);
  return q.min + 0.5 * q.mean + mean_edge_ratio(mesh, metric);
}

PlanarMesh from_gmsh(const GmshMesh& made, const PlanarLoops& loops) {
  PlanarMesh mesh;
  mesh.points = made.points;
  const std::vector<Point2> boundary = flattened(loops);
  mesh.n_boundary = static_cast<int>(boundary.size());
  std::copy(boundary.begin(), boundary.end(), mesh.points.begin());
  for (const auto& cell : made.cells) mesh.add_cell({cell.data(), cell[3] < 0 ? 3u : 4u});
  return mesh;
}

PlanarMesh by_gmsh(const PlanarLoops& loops, GmshAlgorithm algorithm, double size, bool recombine,
                   const Context& context) {
  GmshOptions options;
  options.algorithm = algorithm;
  options.recombine = recombine;
  options.size_max = size;
  return from_gmsh(mesh_by_gmsh(loops, options, context), loops);
}

std::optional<PlanarMesh> unstructured(const PlanarLoops& loops, GmshAlgorithm algorithm,
                                       const PlanarMeshOptions& options, const Context& context) {
  const auto quads = with_triangles_paired(by_gmsh(loops, algorithm, options.size, true, context));
  if (!quads) return std::nullopt;
  return smoothed(with_regular_valences(smoothed(*quads, options.metric, context)), options.metric, context);
}

/// Possible where every loop has an even number of edges.
std::optional<PlanarMesh> by_halving(const PlanarLoops& loops, const PlanarMeshOptions& options,
                                     const Context& context) {
  PlanarLoops half;
  for (const auto& loop : loops) {
    if (loop.size() % 2 != 0 || loop.size() < 6) return std::nullopt;
    half.emplace_back();
    for (std::size_t i = 0; i < loop.size(); i += 2) half.back().push_back(loop[i]);
  }
  const PlanarMesh coarse = by_gmsh(half, GmshAlgorithm::frontal, 2.0 * options.size, true, context);
  const PlanarMesh quads = refined_to_quads(coarse, loops);
  return smoothed(with_regular_valences(smoothed(quads, options.metric, context)), options.metric, context);
}

class Best {
 public:
  explicit Best(const Metric& metric) : metric_(metric) {}
  void offer(std::optional<PlanarMesh> mesh) {
    if (!mesh) return;
    const double value = score(*mesh, metric_);
    if (mesh_ && value <= value_) return;
    mesh_ = std::move(mesh);
    value_ = value;
  }
  double min_quality() const { return mesh_ ? quality(mesh_->points, *mesh_, metric_).min : -1.0; }
  std::optional<PlanarMesh>& mesh() { return mesh_; }

 private:
  const Metric& metric_;
  std::optional<PlanarMesh> mesh_;
  double value_ = 0.0;
};

PlanarMesh best_quads(const PlanarLoops& loops, const PlanarMeshOptions& options, const Context& context) {
  constexpr double poor = 0.2;
  Best best(options.metric);
  for (const PlanarMesh& candidate : structured_candidates(loops, options.size))
    best.offer(smoothed(candidate, options.metric, context));
  if (best.min_quality() >= good_enough) return *best.mesh();
  for (const auto algorithm : {GmshAlgorithm::frontal, GmshAlgorithm::parallelograms})
    best.offer(unstructured(loops, algorithm, options, context));
  if (best.min_quality() < poor) best.offer(by_halving(loops, options, context));
  if (!best.mesh())
    throw SolverError("surface", "No mesh of quads was found for a cap; try another element size.");
  return *best.mesh();
}

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
  for (int c = 0; c < mesh.n_cells(); ++c)
    for (const int node : mesh.cell(c)) size[c] += all[node].x() / static_cast<double>(mesh.cell(c).size());
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
    const double regular_area = cell.size() == 3 ? 0.25 * std::sqrt(3.0) : 1.0;
    wished += regular_area * size[c] * size[c];
  }
  for (double& s : size) s *= std::sqrt(there / wished);
}

}  // namespace

PlanarMesh smoothed(const PlanarMesh& mesh, const Metric& metric, const Context& context) {
  std::vector<double> size = local_sizes(mesh, metric);
  fit_to_area(size, mesh, metric);
  std::vector<char> fixed(mesh.n_nodes(), 0);
  std::fill_n(fixed.begin(), mesh.n_boundary, 1);
  PlanarMesh out = mesh;
  out.points = minimise_foldover(mesh.points, fixed, corners_regular(mesh, size), metric, {}, context).points;
  return out;
}

PlanarMesh mesh_planar(const PlanarLoops& loops, const PlanarMeshOptions& options, const Context& context) {
  check_input(loops, options);
  const PlanarMesh mesh =
      options.kind == CellKind::quad
          ? best_quads(loops, options, context)
          : smoothed(by_gmsh(loops, GmshAlgorithm::frontal, options.size, false, context), options.metric,
                     context);
  std::vector<long> inverted;
  for (int c = 0; c < mesh.n_cells(); ++c)
    if (scaled_jacobian(mesh.points, mesh.cell(c), options.metric) <= 0.0) inverted.push_back(c);
  if (!inverted.empty())
    throw InvalidMeshError("surface",
                           "The mesh of a cap keeps " + std::to_string(inverted.size()) +
                               " inverted cells; try a smaller element size.",
                           {}, inverted);
  return mesh;
}

}  // namespace sweepmesh
