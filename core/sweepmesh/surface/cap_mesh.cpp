#include "sweepmesh/surface/cap_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "sweepmesh/surface/cap_map.h"
#include "sweepmesh/surface/chart.h"
#include "sweepmesh/surface/given_cells.h"
#include "sweepmesh/surface/planar_pair.h"

namespace sweepmesh {
namespace {

/// Facets are a little finer than the elements, so that these see the surface bend.
constexpr double facet_share = 0.75;

Point2 mirrored(const Point2& p) {
  return {-p.x(), p.y()};
}

/// The chart's metric, which keeps the chart alive; mirrored if wished.
Metric shared_metric(const std::shared_ptr<const Chart>& chart, bool is_mirrored) {
  const Metric inner = chart->metric();
  if (!inner) return {};
  if (!is_mirrored) return [chart, inner](const Point2& p) { return inner(p); };
  return [chart, inner](const Point2& p) -> Eigen::Matrix2d {
    Eigen::Matrix2d mirror = Point2(-1.0, 1.0).asDiagonal();
    // The mirror on both sides keeps the determinant positive.
    return mirror * inner(mirrored(p)) * mirror;
  };
}

/// Runs a step and names the face in what it throws.
template <class Step>
auto naming(const std::vector<std::string>& faces, const Step& step) {
  const auto sentence = [&](const Error& e) {
    std::string names;
    for (const auto& f : faces) names += (names.empty() ? "" : " and ") + f;
    return names + ": " + e.what();
  };
  try {
    return step();
  } catch (const InvalidMeshError& e) {
    throw InvalidMeshError(e.stage(), sentence(e), faces, e.elements());
  } catch (const InputError& e) {
    throw InputError(e.stage(), sentence(e), faces);
  } catch (const SolverError& e) {
    throw SolverError(e.stage(), sentence(e), faces);
  }
}

/// The least scaled Jacobian of a cell's corners, measured against the cell's own normal.
double corner_jacobian(const std::vector<Point3>& points, std::span<const int> cell,
                       const Point3& normal) {
  const int n = static_cast<int>(cell.size());
  double least = 1.0;
  for (int i = 0; i < n; ++i) {
    const Point3 next = points[cell[(i + 1) % n]] - points[cell[i]];
    const Point3 previous = points[cell[(i + n - 1) % n]] - points[cell[i]];
    const double sine = next.cross(previous).dot(normal) / (next.norm() * previous.norm());
    least = std::min(least, n == 4 ? sine : sine / std::sin(2.0 * std::numbers::pi / n));
  }
  return least;
}

void place_inside(const Model& model, const Chart& chart, CapMesh& cap) {
  for (int i = cap.plane.n_boundary; i < cap.plane.n_nodes(); ++i) {
    const Point2 p = cap.is_mirrored ? mirrored(cap.plane.points[i]) : cap.plane.points[i];
    cap.uv.push_back(chart.uv(p));
    cap.points.push_back(chart.metric() ? model.point(cap.face, cap.uv.back()) : chart.point(p));
  }
}

void take_boundary(const std::vector<CapNode>& nodes, CapMesh& cap) {
  for (const CapNode& n : nodes) {
    cap.boundary.push_back(n.node);
    cap.uv.push_back(n.uv);
    cap.points.push_back(n.point);
  }
}

/// The target's loops for the source's: seen from outside those of an opposite face run the other
/// way.
CapLoops loops_like(const CapMesh& source, const std::vector<CapNode>& boundary, Facing facing) {
  CapLoops loops;
  auto first = boundary.begin();
  for (const int n : source.loop_sizes) {
    if (facing == Facing::same)
      loops.emplace_back(first, first + n);
    else
      loops.emplace_back(std::make_reverse_iterator(first + n), std::make_reverse_iterator(first));
    first += n;
  }
  return loops;
}

/// The chart points of the target's boundary, in the order of the source's loops and nodes;
/// mirrored for an opposite face.
PlanarLoops loops_in_chart(const Chart& chart, Facing facing) {
  PlanarLoops out(chart.order().size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto& loop = chart.loops()[k];
    auto& own = out[chart.order()[k]];
    if (facing == Facing::same)
      own = loop;
    else
      std::transform(loop.rbegin(), loop.rend(), std::back_inserter(own), mirrored);
  }
  return out;
}

std::shared_ptr<const Chart> make_chart(const Model& model, FaceId face, const CapLoops& loops,
                                        double size, std::optional<int> outer,
                                        const Context& context) {
  return std::make_shared<const Chart>(model, face, loops, facet_share * size, context, outer);
}

CapMesh empty_source(FaceId face, const std::shared_ptr<const Chart>& chart,
                     const CapLoops& boundary) {
  CapMesh cap;
  cap.face = face;
  cap.metric = shared_metric(chart, false);
  for (const int loop : chart->order()) {
    take_boundary(boundary[loop], cap);
    cap.loop_sizes.push_back(static_cast<int>(boundary[loop].size()));
  }
  return cap;
}

CapMesh empty_target(FaceId face, const std::shared_ptr<const Chart>& chart, const CapMesh& source,
                     const std::vector<CapNode>& boundary, Facing facing) {
  CapMesh cap;
  cap.face = face;
  cap.is_mirrored = facing == Facing::opposite;
  cap.metric = shared_metric(chart, cap.is_mirrored);
  cap.loop_sizes = source.loop_sizes;
  take_boundary(boundary, cap);
  return cap;
}

PlanarMeshOptions options_for(const CapMesh& cap, double size, CellKind kind) {
  PlanarMeshOptions options;
  options.size = size;
  options.kind = kind;
  options.metric = cap.metric;
  return options;
}

/// Whether the loop that is the outer one on the source is so on the target.
void check_outer_loop(const Chart& chart) {
  if (chart.order().front() != 0)
    throw InputError("surface", "The outer boundary of one cap belongs to a hole of the other.");
}

}  // namespace

PlanarQuality quality_in_space(const Model& model, const CapMesh& cap) {
  PlanarQuality q;
  double sum = 0.0;
  for (int c = 0; c < cap.plane.n_cells(); ++c) {
    const auto cell = cap.plane.cell(c);
    const int n = static_cast<int>(cell.size());
    Point3 outward = Point3::Zero(), area = Point3::Zero();
    for (int i = 0; i < n; ++i) {
      outward += model.normal(cap.face, cap.uv[cell[i]]);
      area += cap.points[cell[i]].cross(cap.points[cell[(i + 1) % n]]);
    }
    const double side = (outward.dot(area) > 0.0) == cap.is_mirrored ? -1.0 : 1.0;
    const double value = side * corner_jacobian(cap.points, cell, area.normalized());
    q.min = std::min(q.min, value);
    q.n_inverted += value <= 0.0;
    sum += value;
  }
  if (cap.plane.n_cells() > 0) q.mean = sum / cap.plane.n_cells();
  return q;
}

CapMesh mesh_cap(const Model& model, FaceId face, const CapLoops& boundary, double size,
                 CellKind kind, const Context& context) {
  return naming({name_of(face)}, [&] {
    const auto chart = make_chart(model, face, boundary, size, {}, context);
    CapMesh cap = empty_source(face, chart, boundary);
    cap.plane = mesh_planar(chart->loops(), options_for(cap, size, kind), context);
    place_inside(model, *chart, cap);
    return cap;
  });
}

CapMesh cap_with_mesh(const Model& model, FaceId face, const CapLoops& boundary,
                      const FaceMesh& mesh, double size, double tolerance, const Context& context) {
  return naming({name_of(face)}, [&] {
    const auto chart = make_chart(model, face, boundary, size, {}, context);
    CapMesh cap = empty_source(face, chart, boundary);
    const GivenCells given = numbered_from(cap.points, mesh, tolerance);
    for (const Point3& p : given.inner) {
      cap.points.push_back(p);
      cap.uv.push_back(model.project(face, p));
    }
    cap.plane = laid_flat(given, cap.points, flattened(chart->loops()), cap.metric, context);
    return cap;
  });
}

CapMesh map_cap(const Model& model, const CapMesh& source, FaceId target,
                const std::vector<CapNode>& boundary, double size, const Context& context,
                Facing facing) {
  std::vector<std::string> names = {name_of(target)};
  if (source.face.is_valid()) names.insert(names.begin(), name_of(source.face));
  return naming(names, [&] {
    if (boundary.size() != source.boundary.size())
      throw InputError("surface",
                       "Source and target cap have different numbers of boundary nodes.");
    const auto chart =
        make_chart(model, target, loops_like(source, boundary, facing), size, 0, context);
    check_outer_loop(*chart);
    CapMesh cap = empty_target(target, chart, source, boundary, facing);
    MapOptions options;
    options.source_metric = source.metric;
    options.target_metric = cap.metric;
    cap.plane = source.plane;
    cap.plane.points =
        map_planar(source.plane, flattened(loops_in_chart(*chart, facing)), options, context)
            .points;
    place_inside(model, *chart, cap);
    return cap;
  });
}

CapPair mesh_cap_pair(const Model& model, FaceId source, const CapLoops& boundary, FaceId target,
                      const CapLoops& partner, double size, CellKind kind, const Context& context) {
  return naming({name_of(source), name_of(target)}, [&] {
    const auto chart = make_chart(model, source, boundary, size, {}, context);
    CapPair pair;
    pair.source = empty_source(source, chart, boundary);
    std::vector<CapNode> there;
    for (const int loop : chart->order())
      there.insert(there.end(), partner.at(loop).begin(), partner.at(loop).end());
    if (there.size() != pair.source.boundary.size())
      throw InputError("surface",
                       "Source and target cap have different numbers of boundary nodes.");
    const auto far_chart = make_chart(
        model, target, loops_like(pair.source, there, Facing::opposite), size, 0, context);
    check_outer_loop(*far_chart);
    pair.target = empty_target(target, far_chart, pair.source, there, Facing::opposite);
    PlanarPair plane =
        mesh_planar_pair(chart->loops(), loops_in_chart(*far_chart, Facing::opposite),
                         options_for(pair.source, size, kind), pair.target.metric, context);
    pair.target.plane = pair.source.plane = std::move(plane.first);
    pair.target.plane.points = std::move(plane.second);
    place_inside(model, *chart, pair.source);
    place_inside(model, *far_chart, pair.target);
    return pair;
  });
}

std::vector<NodeId> add_cap(const CapMesh& cap, SurfaceMesh& mesh) {
  std::vector<NodeId> ids = cap.boundary;
  for (int i = cap.plane.n_boundary; i < cap.plane.n_nodes(); ++i)
    ids.push_back(mesh.add_node(cap.points[i], {EntityKind::face, cap.face.index}));
  for (int c = 0; c < cap.plane.n_cells(); ++c) {
    std::vector<NodeId> nodes;
    for (const int node : cap.plane.cell(c)) nodes.push_back(ids[node]);
    if (cap.is_mirrored) std::reverse(nodes.begin(), nodes.end());
    mesh.add_cell(nodes, cap.face);
  }
  return ids;
}

}  // namespace sweepmesh
