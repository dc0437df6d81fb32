#include "sweepmesh/volume/place.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/cap_transition.h"
#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/improve.h"
#include "sweepmesh/volume/layer_motion.h"
#include "sweepmesh/volume/layered_solver.h"
#include "sweepmesh/volume/node_ascent.h"
#include "sweepmesh/volume/residual.h"
#include "sweepmesh/volume/unfold.h"
#include "sweepmesh/volume/untangle.h"

namespace sweepmesh {
namespace {

/// Diagonal of the box around the fixed nodes.
double size_of(const Points& points, const std::vector<char>& fixed, ThreadTeam& team) {
  const long n_nodes = static_cast<long>(fixed.size());
  const long grain = ThreadTeam::grain_of(n_nodes, 1L << 10, 1L << 16);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  using Box = std::pair<Point3, Point3>;
  const Box none = {Point3::Constant(infinity), Point3::Constant(-infinity)};
  std::vector<Box> boxes(ThreadTeam::n_chunks(n_nodes, grain), none);
  team.for_chunks(n_nodes, grain, [&](long begin, long end, long chunk) {
    auto [low, high] = none;
    for (long n = begin; n < end; ++n) {
      if (!fixed[n]) continue;
      low = low.cwiseMin(Point3(points.row(n)));
      high = high.cwiseMax(Point3(points.row(n)));
    }
    boxes[chunk] = {low, high};
  });
  Box all = none;
  for (const auto& [low, high] : boxes) all = {all.first.cwiseMin(low), all.second.cwiseMax(high)};
  return (all.second - all.first).norm();
}

/// Adds the correction, which was solved for in units of `unit`, to the free nodes.
void add_correction(const Extrusion& x, const LayeredSystem& system, const Floats& e, double unit,
                    Points& points, ThreadTeam& team) {
  team.for_chunks(x.n_columns(), columns_per_chunk(x), [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c)
      for (int level = system.low[c]; level <= system.high[c]; ++level) {
        const float* v = system.at(e.data(), c, level);
        points.row(x.node(c, level + system.k_first)) += unit * Point3(v[0], v[1], v[2]);
      }
  });
}

void extend_residuals(const Extrusion& x, const std::vector<char>& fixed, const BaseMetric& metric,
                      const LayerMotion& motion, const Residuals& residuals, double unit,
                      const PlacementOptions& options, Points& points, PlacementReport& report,
                      ThreadTeam& team, const Context& context) {
  const CellsOfColumns cells(x);
  const LayeredSystem system = make_layered_system(x, cells, metric, fixed, team);
  if (system.is_empty()) return;
  Floats e = right_hand_side(x, cells, motion, metric, residuals, system, 1.0 / unit, team);
  const SolverReport solved = solve(system, e, {.reduction = options.reduction}, team, context);
  add_correction(x, system, e, unit, points, team);
  report.was_solved = true;
  report.n_iterations = solved.n_iterations;
}

/// Whether layers are only interpolated between their ends: they may be improved even where the
/// boundary left no residual.
bool is_interpolated(const LayerMotion& motion) {
  return std::any_of(motion.blocks.begin(), motion.blocks.end(),
                     [](const MotionBlock& b) { return !b.has_loops && b.k_high > b.k_low + 1; });
}

void set_quality(const ElementCheck& check, PlacementReport& report) {
  report.inverted = check.bad;
  report.min_scaled_jacobian = check.min_scaled_jacobian;
  report.mean_scaled_jacobian = check.mean_scaled_jacobian;
}

void mend_elements(const Extrusion& x, const std::vector<char>& fixed, BaseMetric& metric,
                   const PlacementOptions& options, bool may_improve, Points& points,
                   PlacementReport& report, ThreadTeam& team, const Context& context) {
  set_quality(check_elements(x, points, kDegenerate, team), report);
  report.n_inverted_before = static_cast<long>(report.inverted.size());
  if (!report.inverted.empty() && options.max_attempts > 0) {
    complete_metric(x, points, metric, team);
    unfold_inverted(x, metric, fixed, options.sliding, options.max_attempts, report.inverted,
                    points, team, context);
    set_quality(check_elements(x, points, kDegenerate, team), report);
  }
  // Layers that are exact images of the caps stay so.
  if (!report.inverted.empty() || !may_improve) return;
  complete_metric(x, points, metric, team);
  ImproveOptions improve = options.improve;
  improve.sliding = options.sliding;
  improve.curved = options.curved;
  const double least = improve_elements(x, fixed, metric, improve, report.min_scaled_jacobian,
                                        points, team, context);
  if (report.mean_scaled_jacobian < options.raise_mean_below &&
      x.n_elements() <= options.raise_at_most)
    ascend_nodes(x, fixed, {.sliding = options.sliding}, points, team, context);
  else if (least == report.min_scaled_jacobian)
    return;
  set_quality(check_elements(x, points, kDegenerate, team), report);
}

/// The element of a cell between layers k and k + 1, among those of its kind.
void add_element(const Extrusion& x, int cell, int k, VolumeMesh& mesh) {
  const int* columns = x.cell_columns.data() + x.cell_offset[cell];
  const int n = x.cell_size(cell);
  const auto set = [&](auto element) {
    for (int i = 0; i < n; ++i) {
      element[i] = static_cast<int>(x.node(columns[i], k));
      element[n + i] = element[i] + 1;
    }
  };
  if (n == 4) {
    set(mesh.hexahedra.emplace_back().begin());
  } else if (n == 3) {
    set(mesh.prisms.emplace_back().begin());
  } else {
    mesh.polyhedron_nodes.resize(mesh.polyhedron_nodes.size() + 2 * n);
    set(mesh.polyhedron_nodes.end() - 2 * n);
    mesh.polyhedron_offset.push_back(static_cast<int>(mesh.polyhedron_nodes.size()));
  }
}

}  // namespace

PlacementReport place_interior(const Extrusion& extrusion, const std::vector<char>& fixed,
                               Points& points, const PlacementOptions& options, Context& context) {
  assert(points.rows() == extrusion.n_nodes());
  assert(static_cast<long>(fixed.size()) == extrusion.n_nodes());
  PlacementReport report;
  if (extrusion.n_elements() == 0) return report;
  ThreadTeam& team = team_of(context);
  context.report(0.0, "Placing the interior nodes");
  BaseMetric metric = make_layer_heights(extrusion, fixed, points, team);
  if (options.method != PlacementMethod::harmonic_residual) {
    complete_metric(extrusion, points, metric, team);
    place_by_older_method(options.method, extrusion, fixed, metric, points, team, context);
    set_quality(check_elements(extrusion, points, kDegenerate, team), report);
    return report;
  }
  const LayerMotion motion = make_layer_motion(extrusion, fixed, points, metric, team);
  set_predictions(extrusion, motion, fixed, points, team);
  const Residuals residuals = find_residuals(extrusion, motion, fixed, points, team);
  report.largest_residual = largest(residuals);
  context.report(0.1, "Extending the boundary's residual");
  const double negligible = options.negligible_residual * size_of(points, fixed, team);
  if (report.largest_residual > negligible) {
    complete_metric(extrusion, points, metric, team);
    extend_residuals(extrusion, fixed, metric, motion, residuals, report.largest_residual, options,
                     points, report, team, context);
  }
  context.report(0.5, "Passing from cap to cap");
  const bool has_passed = choose_transitions(extrusion, fixed, metric, motion,
                                             {.negligible = negligible}, points, team, context);
  context.report(0.6, "Checking the elements");
  // Where no residual was left, layers that follow loops are exact images of the caps and stay so.
  const bool may_improve = has_passed || report.was_solved || is_interpolated(motion);
  mend_elements(extrusion, fixed, metric, options, may_improve, points, report, team, context);
  context.report(1.0, "Interior nodes placed");
  return report;
}

VolumeMesh build_volume_mesh(const Extrusion& extrusion, Points points) {
  if (extrusion.n_nodes() > std::numeric_limits<int>::max())
    throw InputError("place", "The mesh has more nodes than elements can number.");
  VolumeMesh mesh;
  mesh.points = std::move(points);
  for (int c = 0; c < extrusion.n_cells(); ++c)
    for (int k = extrusion.cell_k_low[c]; k < extrusion.cell_k_high[c]; ++k)
      add_element(extrusion, c, k, mesh);
  return mesh;
}

}  // namespace sweepmesh
