#include "sweepmesh/surface/cap_map.h"

#include <Eigen/QR>
#include <algorithm>
#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/mean_value_2d.h"
#include "sweepmesh/surface/widened.h"
#include "sweepmesh/surface/worst_first.h"

namespace sweepmesh {
namespace {

Point2 apply(const Affine& a, const Point2& p) {
  return a.leftCols<2>() * p + a.col(2);
}

/// Cells that are worse than `limit`.
std::vector<int> cells_below(double limit, const PlanarMesh& mesh,
                             const std::vector<Point2>& points, const Metric& metric) {
  std::vector<int> out;
  for (int c = 0; c < mesh.n_cells(); ++c)
    if (scaled_jacobian(points, mesh.cell(c), metric) <= limit) out.push_back(c);
  return out;
}

/// Cells with a side that is squeezed, and not of the boundary.
std::vector<int> squeezed_cells(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                const MapOptions& options) {
  if (options.squeezed <= 0.0) return {};
  const SideLengths wished =
      lengths_like(mesh, options.source_metric, points, options.target_metric);
  return cells_narrower_than(options.squeezed, mesh, points, wished, options.target_metric);
}

/// Flags the nodes of the cells and of `rings` rings of cells around them.
std::vector<char> neighbourhood(const PlanarMesh& mesh, const NodeCells& at_nodes,
                                const std::vector<int>& cells, int rings) {
  std::vector<char> is_near(mesh.n_nodes(), 0);
  std::vector<int> front;
  const auto add = [&](int cell, std::vector<int>& next) {
    for (const int node : mesh.cell(cell))
      if (!std::exchange(is_near[node], 1)) next.push_back(node);
  };
  for (const int c : cells) add(c, front);
  for (int r = 0; r < rings && !front.empty(); ++r) {
    std::vector<int> next;
    for (const int node : front)
      for (const int c : at_nodes.of(node)) add(c, next);
    front = std::move(next);
  }
  return is_near;
}

/// The energy over the corners with a node that is free; the rest of the mesh stays.
std::vector<Point2> relaxed(const PlanarMesh& mesh, const std::vector<Point2>& points,
                            const std::vector<char>& is_free, int max_iterations,
                            const MapOptions& options, const Context& context) {
  std::vector<char> fixed(mesh.n_nodes());
  for (int i = 0; i < mesh.n_nodes(); ++i) fixed[i] = i < mesh.n_boundary || !is_free[i];
  std::vector<MapTriangle> corners = corners_like(mesh, mesh.points, options.source_metric);
  std::erase_if(corners, [&](const MapTriangle& t) {
    return std::all_of(t.node.begin(), t.node.end(), [&](int node) { return fixed[node]; });
  });
  FoldoverOptions foldover;
  foldover.tolerance = 1e-3;
  foldover.max_iterations = max_iterations;
  return minimise_foldover(points, fixed, corners, options.target_metric, foldover, context).points;
}

bool is_better(const PlanarQuality& a, const PlanarQuality& b) {
  return a.n_inverted != b.n_inverted ? a.n_inverted < b.n_inverted : a.min > b.min;
}

/// Cells that are much narrower than on the source, wider.
std::vector<Point2> evened(const PlanarMesh& source, const std::vector<Point2>& points,
                           const MapOptions& options, const Context& context) {
  const SideLengths wished =
      lengths_like(source, options.source_metric, points, options.target_metric);
  WidenOptions how;
  how.squeezed = options.squeezed;
  return widened(source, points, wished, how, options.target_metric, context);
}

class Improver {
 public:
  Improver(const PlanarMesh& mesh, const MapOptions& options, const Context& context)
      : mesh_(mesh), options_(options), context_(context), at_nodes_(cells_at_nodes(mesh)) {}

  void run(PlanarMap& map) const {
    std::vector<int> poor = cells_below(options_.poor, mesh_, map.points, options_.target_metric);
    const std::vector<int> squeezed = squeezed_cells(mesh_, map.points, options_);
    poor.insert(poor.end(), squeezed.begin(), squeezed.end());
    if (poor.empty()) return;
    constexpr int steps_of_part = 20, steps_of_whole = 100;
    for (int rings = std::max(1, options_.rings);; rings *= 4) {
      const auto is_free = neighbourhood(mesh_, at_nodes_, poor, rings);
      const bool is_whole = std::all_of(is_free.begin(), is_free.end(), [](char f) { return f; });
      auto points = relaxed(mesh_, map.points, is_free, is_whole ? steps_of_whole : steps_of_part,
                            options_, context_);
      const PlanarQuality q = quality(points, mesh_, options_.target_metric);
      if (is_better(q, map.final) ||
          (is_good_enough(q, map.final) && is_less_squeezed(points, squeezed.size())))
        map.points = std::move(points), map.final = q;
      if (map.final.n_inverted == 0 || is_whole) return;
    }
  }

 private:
  bool is_good_enough(const PlanarQuality& now, const PlanarQuality& before) const {
    return now.n_inverted == 0 && now.min >= std::min(before.min, options_.poor);
  }

  bool is_less_squeezed(const std::vector<Point2>& points, std::size_t n_before) const {
    return squeezed_cells(mesh_, points, options_).size() < n_before;
  }

  const PlanarMesh& mesh_;
  const MapOptions& options_;
  const Context& context_;
  NodeCells at_nodes_;
};

}  // namespace

Affine best_affine(const std::vector<Point2>& from, const std::vector<Point2>& to) {
  Eigen::MatrixX3d left(from.size(), 3);
  Eigen::MatrixX2d right(from.size(), 2);
  for (std::size_t i = 0; i < from.size(); ++i) {
    left.row(i) << from[i].transpose(), 1.0;
    right.row(i) = to[i].transpose();
  }
  return left.colPivHouseholderQr().solve(right).transpose();
}

std::vector<Point2> harmonic_map(const PlanarMesh& source, const std::vector<Point2>& boundary,
                                 const Metric& source_metric) {
  const Affine affine =
      best_affine({source.points.begin(), source.points.begin() + source.n_boundary}, boundary);
  std::vector<Point2> residual(boundary);
  for (int i = 0; i < source.n_boundary; ++i) residual[i] -= apply(affine, source.points[i]);
  std::vector<Point2> out = harmonic_extension(source, residual, source_metric);
  for (int i = 0; i < source.n_nodes(); ++i) out[i] += apply(affine, source.points[i]);
  for (int i = 0; i < source.n_boundary; ++i) out[i] = boundary[i];
  return out;
}

PlanarMap map_planar(const PlanarMesh& source, const std::vector<Point2>& boundary,
                     const MapOptions& options, const Context& context) {
  if (static_cast<int>(boundary.size()) != source.n_boundary)
    throw InputError("surface", "Source and target cap have different numbers of boundary nodes.");
  PlanarMap map;
  map.points = harmonic_map(source, boundary, options.source_metric);
  map.harmonic = map.final = quality(map.points, source, options.target_metric);
  Improver(source, options, context).run(map);
  if (map.final.n_inverted == 0) {
    constexpr int max_rounds = 3;
    map.points = with_worst_raised(source, map.points, options.poor, max_rounds,
                                   options.target_metric, context);
    if (options.squeezed > 0.0) map.points = evened(source, map.points, options, context);
    map.final = quality(map.points, source, options.target_metric);
  }
  const auto inverted = cells_below(0.0, source, map.points, options.target_metric);
  if (!inverted.empty())
    throw InvalidMeshError("surface",
                           "The source mesh cannot be carried to the target face: " +
                               std::to_string(inverted.size()) + " cells stay inverted.",
                           {}, std::vector<long>(inverted.begin(), inverted.end()));
  return map;
}

}  // namespace sweepmesh
