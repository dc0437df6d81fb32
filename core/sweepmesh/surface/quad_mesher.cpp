#include "sweepmesh/surface/quad_mesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/numerics/gmsh/gmsh.h"
#include "sweepmesh/surface/delaunay_quads.h"
#include "sweepmesh/surface/polygon_dual.h"
#include "sweepmesh/surface/quad_cleanup.h"
#include "sweepmesh/surface/quad_templates.h"
#include "sweepmesh/surface/regular_cells.h"
#include "sweepmesh/surface/worst_first.h"

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
      throw InputError(
          "surface",
          "A boundary loop of a cap has fewer than three mesh edges; choose a smaller size.");
    if ((signed_area(loops[l]) > 0.0) != (l == 0))
      throw InputError("surface", "The boundary loops of a cap do not run around its face.");
  }
  if (!is_domain(loops))
    throw InputError("surface",
                     "The boundary loops of a cap touch or cross; choose a smaller element size.");
  if (options.kind == CellKind::quad && n_edges % 2 != 0)
    throw InputError("surface",
                     "A cap's boundary has an odd number of mesh edges, so quads cannot fill it.");
}

/// Shortest by longest edge, the mean over all cells.
double mean_edge_ratio(const PlanarMesh& mesh, const Metric& metric) {
  double sum = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const Eigen::Matrix2d root =
        metric ? metric(mesh.points[cell[0]]) : Eigen::Matrix2d::Identity();
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const double length =
          (root * (mesh.points[cell[(i + 1) % cell.size()]] - mesh.points[cell[i]])).norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    sum += shortest / longest;
  }
  return sum / std::max(1, mesh.n_cells());
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

/// All that making one unstructured candidate needs.
struct Task {
  const PlanarLoops& loops;
  const PlanarMeshOptions& options;
  const BoundaryAngles& angles;
  const Context& context;
};

PlanarMesh cleaned(const PlanarMesh& quads, const Task& task) {
  const Metric& metric = task.options.metric;
  return smoothed(with_regular_valences(smoothed(quads, metric, task.context), task.angles), metric,
                  task.context);
}

std::optional<PlanarMesh> unstructured(GmshAlgorithm algorithm, const Task& task) {
  const auto quads =
      with_triangles_paired(by_gmsh(task.loops, algorithm, task.options.size, true, task.context));
  if (!quads) return std::nullopt;
  return cleaned(*quads, task);
}

/// Whether a loop's sharper corners are at its odd nodes: those of every second node must be kept.
bool has_odd_corners(const std::vector<Point2>& loop) {
  const std::vector<double> angles = interior_angles({loop});
  std::array<double, 2> turn = {0.0, 0.0};
  for (std::size_t i = 0; i < loop.size(); ++i)
    turn[i % 2] += std::pow(1.0 - angles[i] / std::numbers::pi, 2);
  return turn[1] > turn[0];
}

/// Undoes that loops began with their second node: those of `is_turned`.
PlanarMesh turned_back(PlanarMesh mesh, const PlanarLoops& loops,
                       const std::vector<char>& is_turned) {
  std::vector<int> number(mesh.n_nodes());
  std::iota(number.begin(), number.end(), 0);
  int first = 0;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const int n = static_cast<int>(loops[l].size());
    for (int i = 0; i < n && is_turned[l]; ++i) number[first + i] = first + (i + 1) % n;
    first += n;
  }
  const std::vector<Point2> points = mesh.points;
  for (int i = 0; i < mesh.n_nodes(); ++i) mesh.points[number[i]] = points[i];
  for (int& node : mesh.cell_nodes) node = number[node];
  return mesh;
}

/// Possible where every loop has an even number of edges.
std::optional<PlanarMesh> by_halving(const Task& task) {
  PlanarLoops half, whole = task.loops;
  std::vector<char> is_turned;
  for (auto& loop : whole) {
    if (loop.size() % 2 != 0 || loop.size() < 6) return std::nullopt;
    is_turned.push_back(has_odd_corners(loop));
    if (is_turned.back()) std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    half.emplace_back();
    for (std::size_t i = 0; i < loop.size(); i += 2) half.back().push_back(loop[i]);
  }
  const double size = 2.0 * task.options.size;
  const PlanarMesh quads =
      refined_to_quads(by_gmsh(half, GmshAlgorithm::frontal, size, true, task.context), whole);
  return cleaned(turned_back(quads, task.loops, is_turned), task);
}

std::optional<PlanarMesh> by_delaunay(const Task& task) {
  const auto quads = delaunay_quads(task.loops, task.options.size);
  if (!quads) return std::nullopt;
  return cleaned(*quads, task);
}

/// Lets one way of meshing fail, as long as another one works.
template <class Make>
void try_to_add(const Make& make, std::vector<PlanarMesh>& out,
                std::optional<SolverError>& failure) {
  try {
    if (std::optional<PlanarMesh> mesh = make()) out.push_back(std::move(*mesh));
  } catch (const SolverError& e) {
    failure = e;
  }
}

double worst(const std::vector<PlanarMesh>& meshes, const Metric& metric) {
  double best = -1.0;
  for (const PlanarMesh& m : meshes) best = std::max(best, quality(m.points, m, metric).min);
  return best;
}

std::vector<PlanarMesh> quad_candidates(const Task& task) {
  constexpr double poor = 0.3, decent = 0.5;
  constexpr int large = 4000;  // cells; a second choice would cost seconds
  std::vector<PlanarMesh> out;
  std::optional<SolverError> failure;
  for (const PlanarMesh& pattern : structured_candidates(task.loops, task.options.size))
    out.push_back(smoothed(pattern, task.options.metric, task.context));
  if (worst(out, task.options.metric) >= good_enough) return out;
  for (const auto algorithm : {GmshAlgorithm::frontal, GmshAlgorithm::parallelograms}) {
    const bool is_large = !out.empty() && out.back().n_cells() > large;
    if (is_large && worst(out, task.options.metric) >= decent) break;
    try_to_add([&] { return unstructured(algorithm, task); }, out, failure);
  }
  if (worst(out, task.options.metric) < poor) {
    try_to_add([&] { return by_halving(task); }, out, failure);
    if (worst(out, task.options.metric) <= 0.0)
      try_to_add([&] { return by_delaunay(task); }, out, failure);
    for (std::size_t i = 0, n = out.size(); i < n; ++i)
      out.push_back(cleaned(with_rings(out[i], task.loops, task.angles), task));
  }
  if (!out.empty()) return out;
  if (failure) throw *failure;
  throw SolverError("surface", "No mesh of quads was found for a cap; try another element size.");
}

/// Every quad as two triangles, along the diagonal that leaves the better ones.
PlanarMesh split_into_triangles(const PlanarMesh& quads, const Metric& metric) {
  PlanarMesh out;
  out.points = quads.points;
  out.n_boundary = quads.n_boundary;
  for (int c = 0; c < quads.n_cells(); ++c) {
    const auto q = quads.cell(c);
    if (q.size() < 4) {
      out.add_cell(q);
      continue;
    }
    const auto halves = [&](int i) {
      return std::array{std::array{q[i], q[i + 1], q[(i + 2) % 4]},
                        std::array{q[i], q[(i + 2) % 4], q[(i + 3) % 4]}};
    };
    const auto worse = [&](const auto& two) {
      return std::min(scaled_jacobian(out.points, two[0], metric),
                      scaled_jacobian(out.points, two[1], metric));
    };
    const auto first = halves(0), second = halves(1);
    for (const auto& triangle : worse(first) >= worse(second) ? first : second)
      out.add_cell(triangle);
  }
  return out;
}

/// Triangles all over; and where these are poor (they know nothing of the metric), halved quads.
std::vector<PlanarMesh> triangle_candidates(const Task& task) {
  constexpr double poor = 0.3;
  const Metric& metric = task.options.metric;
  std::vector<PlanarMesh> out = {
      smoothed(by_gmsh(task.loops, GmshAlgorithm::frontal, task.options.size, false, task.context),
               metric, task.context)};
  if (flattened(task.loops).size() % 2 != 0 || worst(out, metric) >= poor) return out;
  try {
    for (const PlanarMesh& quads : quad_candidates(task))
      out.push_back(smoothed(split_into_triangles(quads, metric), metric, task.context));
  } catch (const SolverError&) {  // no quads: the triangles have to do
  }
  return out;
}

/// Where a polygon stays reflex in its place: cut there, and smoothed again.
PlanarMesh made_convex(PlanarMesh mesh, const Task& task) {
  constexpr int max_rounds = 6;
  const Metric& metric = task.options.metric;
  mesh = smoothed(mesh, metric, task.context);
  for (int r = 0; r < max_rounds && quality(mesh.points, mesh, metric).n_inverted > 0; ++r)
    mesh = smoothed(with_reflex_corners_cut(mesh, metric), metric, task.context);
  return mesh;
}

/// Duals of triangles, with links as the corners wish and, where these come out poor, with a link
/// at each boundary node. Triangles where no dual is valid.
std::vector<PlanarMesh> polygon_candidates(const Task& task) {
  constexpr double poor = 0.3;
  const Metric& metric = task.options.metric;
  const std::vector<PlanarMesh> triangles = triangle_candidates(task);
  const std::vector<int> wished = polygons_at_nodes(task.angles);
  std::vector<int> all_linked = wished;
  for (int& n : all_linked) n = std::max(n, 2);
  std::vector<PlanarMesh> out;
  for (const auto& cells : {wished, all_linked})
    for (const PlanarMesh& mesh : triangles)
      if (worst(out, metric) < poor)
        if (auto dual = polygon_dual(mesh, cells))
          out.push_back(made_convex(std::move(*dual), task));
  if (worst(out, metric) <= 0.0) out.insert(out.end(), triangles.begin(), triangles.end());
  return out;
}

}  // namespace

double overall_quality(const PlanarMesh& mesh, const Metric& metric) {
  constexpr double useless = 0.1, weight = 5.0;  // a cell below that spoils any mesh
  const PlanarQuality q = quality(mesh.points, mesh, metric);
  return weight * std::min(q.min, useless) + q.min + 0.5 * q.mean + mean_edge_ratio(mesh, metric);
}

std::vector<double> interior_angles(const PlanarLoops& loops) {
  std::vector<double> out;
  for (const auto& loop : loops) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 in = loop[i] - loop[(i + n - 1) % n], along = loop[(i + 1) % n] - loop[i];
      out.push_back(std::numbers::pi - std::atan2(cross2(in, along), in.dot(along)));
    }
  }
  return out;
}

bool is_domain(const PlanarLoops& loops) {
  std::vector<std::vector<int>> numbers;
  int first = 0;
  double wished = 0.0, found = 0.0;
  for (const auto& loop : loops) {
    wished += signed_area(loop);
    numbers.emplace_back(loop.size());
    for (int& i : numbers.back()) i = first++;
  }
  try {
    const std::vector<Point2> points = flattened(loops);
    for (const auto& [a, b, c] : constrained_delaunay(points, numbers))
      found += 0.5 * cross2(points[b] - points[a], points[c] - points[a]);
  } catch (const InputError&) {
    return false;
  }
  constexpr double rounding = 1e-9;  // of areas
  return wished > 0.0 && std::abs(found - wished) <= rounding * wished;
}

std::vector<PlanarMesh> candidate_meshes(const PlanarLoops& loops, const PlanarMeshOptions& options,
                                         const BoundaryAngles& angles, const Context& context) {
  check_input(loops, options);
  const Task task{loops, options, angles, context};
  switch (options.kind) {
    case CellKind::quad:
      return quad_candidates(task);
    case CellKind::triangle:
      return triangle_candidates(task);
    case CellKind::polygon:
      break;
  }
  return polygon_candidates(task);
}

PlanarMesh mesh_planar(const PlanarLoops& loops, const PlanarMeshOptions& options,
                       const Context& context) {
  std::vector<PlanarMesh> all = candidate_meshes(loops, options, {interior_angles(loops)}, context);
  const auto best = std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return overall_quality(a, options.metric) < overall_quality(b, options.metric);
  });
  constexpr double worth_raising = 0.7;
  constexpr int max_rounds = 6;
  best->points =
      with_worst_raised(*best, best->points, worth_raising, max_rounds, options.metric, context);
  std::vector<long> inverted;
  for (int c = 0; c < best->n_cells(); ++c)
    if (scaled_jacobian(best->points, best->cell(c), options.metric) <= 0.0) inverted.push_back(c);
  if (inverted.empty()) return std::move(*best);
  throw InvalidMeshError("surface",
                         "The mesh of a cap keeps " + std::to_string(inverted.size()) +
                             " inverted cells; try a smaller element size.",
                         {}, inverted);
}

}  // namespace sweepmesh
