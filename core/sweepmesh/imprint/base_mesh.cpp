#include "sweepmesh/imprint/base_mesh.h"

#include <algorithm>
#include <map>
#include <numbers>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/imprint/domain_division.h"
#include "sweepmesh/imprint/patch_angles.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/surface/quad_cleanup.h"
#include "sweepmesh/surface/regular_cells.h"
#include "sweepmesh/surface/worst_first.h"

namespace sweepmesh {
namespace {

void add_edge_nodes(const Imprint& imprint, const std::vector<int>& counts, BaseMesh& base) {
  for (const ImprintVertex& v : imprint.vertices) base.points.push_back(v.point);
  for (std::size_t e = 0; e < imprint.edges.size(); ++e) {
    const ImprintEdge& edge = imprint.edges[e];
    const double whole = length(edge.points);
    std::vector<int> nodes = {edge.start};
    for (int i = 1; i < counts[e]; ++i) {
      nodes.push_back(base.n_nodes());
      base.points.push_back(at_arc(edge.points, whole * i / counts[e]).point);
    }
    nodes.push_back(edge.end);
    base.edge_nodes.push_back(std::move(nodes));
  }
}

/// Nodes of a loop of imprint edges, the first not repeated.
std::vector<int> nodes_of(const BaseMesh& base, const std::vector<DirectedEdge>& loop) {
  std::vector<int> out;
  for (const DirectedEdge& d : loop) {
    const auto& nodes = base.edge_nodes[d.edge];
    if (d.reversed)
      out.insert(out.end(), nodes.rbegin(), nodes.rend() - 1);
    else
      out.insert(out.end(), nodes.begin(), nodes.end() - 1);
  }
  return out;
}

/// Where a patch touches itself in a node, the node's places in the loops are drawn apart, each
/// into the patch, so that the loops become simple.
void draw_touching_apart(const std::vector<int>& node, PlanarLoops& loops) {
  constexpr double share = 0.2;  // of the shorter mesh edge there
  std::map<int, int> n_uses;
  for (const int n : node) ++n_uses[n];
  std::size_t at = 0;
  for (auto& loop : loops) {
    const std::vector<Point2> before = loop;
    const std::vector<double> angles = interior_angles({before});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (n_uses[node[at++]] < 2) continue;
      const Point2 along = before[(i + 1) % loop.size()] - before[i];
      const Point2 back = before[(i + loop.size() - 1) % loop.size()] - before[i];
      const double reach = share * std::min(along.norm(), back.norm());
      loop[i] += reach * (Eigen::Rotation2Dd(angles[i] / 2) * along.normalized());
    }
  }
}

/// What the caps ask of a patch's mesh.
struct CapWishes {
  BoundaryAngles angles;
  std::vector<CapOutline> outlines;
};

/// Boundary nodes where a single cell would have to open its corner almost flat in one of the
/// shapes, and those where the boundary alone makes a corner flat.
int n_flat_corners(const PlanarMesh& mesh, const CapWishes& caps) {
  constexpr double flat = 160.0 / 180.0 * std::numbers::pi;
  std::vector<int> count(mesh.n_nodes(), 0);
  for (const int n : mesh.cell_nodes) ++count[n];
  const std::vector<char> is_tied = tied_corners(mesh, caps.outlines);
  int n_flat = 0;
  for (int i = 0; i < mesh.n_boundary; ++i)
    n_flat += is_tied[i] || std::any_of(caps.angles.begin(), caps.angles.end(),
                                        [&](const auto& row) { return row[i] > flat * count[i]; });
  return n_flat;
}

/// Where every candidate has flat corners: the same with a ring of cells along the boundary, in
/// which every node has two cells at least.
void add_ringed(const PlanarLoops& loops, const CapWishes& caps, const Context& context,
                std::vector<PlanarMesh>& candidates) {
  if (std::any_of(candidates.begin(), candidates.end(),
                  [&](const PlanarMesh& m) { return n_flat_corners(m, caps) == 0; }))
    return;
  for (std::size_t i = 0, n = candidates.size(); i < n; ++i) {
    const PlanarMesh ringed = smoothed(
        with_rings(candidates[i], loops, caps.angles, tied_corners(candidates[i], caps.outlines)),
        {}, context);
    candidates.push_back(smoothed(with_regular_valences(ringed, caps.angles), {}, context));
  }
}

std::vector<PlanarMesh>::iterator best_of(std::vector<PlanarMesh>& candidates,
                                          const CapWishes& caps) {
  const auto rank = [&](const PlanarMesh& m) {
    return std::pair(-n_flat_corners(m, caps), overall_quality(m));
  };
  return std::max_element(candidates.begin(), candidates.end(),
                          [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

/// Where the best candidate has inverted cells: the same with the domain cut in parts.
void add_divided(const PlanarLoops& loops, const PlanarMeshOptions& options, const CapWishes& caps,
                 const Context& context, std::vector<PlanarMesh>& candidates) {
  const PlanarMesh& best = *best_of(candidates, caps);
  if (quality(best.points, best).n_inverted == 0) return;
  if (auto divided = mesh_divided(loops, best, options, context))
    candidates.push_back(std::move(*divided));
}

PlanarMesh best_candidate(std::vector<PlanarMesh> candidates, const CapWishes& caps,
                          const Context& context) {
  const auto best = best_of(candidates, caps);
  constexpr double worth_raising = 0.7;
  constexpr int n_rounds = 6;
  if (quality(best->points, *best).n_inverted == 0)
    best->points = with_worst_raised(*best, best->points, worth_raising, n_rounds, {}, context);
  return std::move(*best);
}

std::vector<std::string> caps_of(const Patch& patch) {
  std::vector<std::string> names;
  for (const Run& r : patch.runs)
    for (const FaceId f : {r.target, r.source}) names.push_back(name_of(f));
  return names;
}

/// A cell that reaches from one place of a node to another has lost a corner.
void check_corners(const BaseMesh& base, int cell, const Patch& patch) {
  std::vector<int> nodes(base.cell_nodes.begin() + base.cell_offset.back(), base.cell_nodes.end());
  std::sort(nodes.begin(), nodes.end());
  if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end())
    throw InvalidMeshError("surface",
                           "A patch is too narrow for the element size where it touches itself.",
                           caps_of(patch), {cell});
}

/// A patch in R.
struct PatchShape {
  PlanarLoops loops;
  std::vector<int> boundary;  ///< the base's nodes, loop after loop
  CapWishes caps;
};

/// The mesh of a patch, and the base's nodes of its boundary.
struct PatchMesh {
  PlanarMesh plane;
  std::vector<int> boundary;
};

/// The one part that asks the CAD model, which serves one thread at a time.
PatchShape shape_of(const Model& model, const Imprint& imprint, const std::vector<int>& counts,
                    const Patch& patch, const BaseMesh& base) {
  PatchShape out;
  for (const auto& loop : patch.loops) {
    out.loops.emplace_back();
    for (const int n : nodes_of(base, loop)) {
      out.boundary.push_back(n);
      out.loops.back().push_back(base.points[n]);
    }
  }
  draw_touching_apart(out.boundary, out.loops);
  out.caps = {patch_angles(model, imprint, counts, patch, out.loops),
              cap_outlines(model, imprint, counts, patch)};
  return out;
}

PlanarMesh chosen_mesh(const PatchShape& shape, CellKind kind, const Context& context) {
  PlanarMeshOptions options;
  options.kind = kind;
  std::vector<PlanarMesh> candidates =
      candidate_meshes(shape.loops, options, shape.caps.angles, context);
  if (options.kind == CellKind::quad) {
    add_ringed(shape.loops, shape.caps, context, candidates);
    add_divided(shape.loops, options, shape.caps, context, candidates);
  }
  return best_candidate(std::move(candidates), shape.caps, context);
}

/// A mesh that is given stays as it is. Errors name the patch's caps.
PatchMesh mesh_patch(const PatchShape& shape, const Patch& patch, const GivenPatch* own,
                     CellKind kind, const Context& context) {
  const auto sentence = [&](const Error& e) {
    return "The patch between " + name_of(patch.runs[0].target) + " and " +
           name_of(patch.runs[0].source) + ": " + e.what();
  };
  try {
    return {own ? laid_flat(own->cells, own->points, flattened(shape.loops), {}, context)
                : chosen_mesh(shape, kind, context),
            shape.boundary};
  } catch (const InputError& e) {
    throw InputError(e.stage(), sentence(e), caps_of(patch));
  } catch (const SolverError& e) {
    throw SolverError(e.stage(), sentence(e), caps_of(patch));
  }
}

void add_patch(const PatchMesh& mesh, const Patch& patch, int number, BaseMesh& base) {
  const PlanarMesh& plane = mesh.plane;
  std::vector<int> node = mesh.boundary;
  base.first_inner.push_back(base.n_nodes());
  for (int i = plane.n_boundary; i < plane.n_nodes(); ++i) {
    node.push_back(base.n_nodes());
    base.points.push_back(plane.points[i]);
  }
  for (int c = 0; c < plane.n_cells(); ++c) {
    for (const int n : plane.cell(c)) base.cell_nodes.push_back(node[n]);
    check_corners(base, c, patch);
    base.cell_offset.push_back(static_cast<int>(base.cell_nodes.size()));
    base.cell_patch.push_back(number);
  }
}

// --- smoothing across imprint edges
// ----------------------------------------------------------------

/// Nodes on edges that have a patch on one side only.
std::vector<char> outer_nodes(const Imprint& imprint, const BaseMesh& base) {
  std::vector<int> n_sides(imprint.edges.size(), 0);
  for (const Patch& p : imprint.patches)
    for (const auto& loop : p.loops)
      for (const DirectedEdge& d : loop) ++n_sides[d.edge];
  std::vector<char> out(base.n_nodes(), 0);
  for (std::size_t e = 0; e < n_sides.size(); ++e)
    if (n_sides[e] < 2)
      for (const int n : base.edge_nodes[e]) out[n] = 1;
  return out;
}

/// Cells below `limit` and `rings` rings of cells around them.
std::vector<char> cells_around_poor(const BaseMesh& base, double limit, int rings) {
  std::vector<char> is_in(base.n_cells(), 0), touched(base.n_nodes(), 0);
  for (int c = 0; c < base.n_cells(); ++c)
    is_in[c] = scaled_jacobian(base.points, base.cell(c)) < limit;
  for (int ring = 0; ring < rings; ++ring) {
    for (int c = 0; c < base.n_cells(); ++c)
      if (is_in[c])
        for (const int n : base.cell(c)) touched[n] = 1;
    for (int c = 0; c < base.n_cells(); ++c)
      for (const int n : base.cell(c)) is_in[c] = is_in[c] || touched[n];
  }
  return is_in;
}

/// Smooths poor cells and those around them, nodes of inner imprint edges included.
void relax(const Imprint& imprint, const Context& context, BaseMesh& base) {
  constexpr double poor = 0.3;
  constexpr int rings = 3;
  const auto is_in = cells_around_poor(base, poor, rings);
  std::vector<char> fixed = outer_nodes(imprint, base), used(base.n_nodes(), 0);
  for (int c = 0; c < base.n_cells(); ++c)
    for (const int n : base.cell(c)) (is_in[c] ? used : fixed)[n] = 1;
  PlanarMesh part;
  std::vector<int> number(base.n_nodes(), -1), node;
  for (const char wanted : {1, 0}) {
    for (int n = 0; n < base.n_nodes(); ++n)
      if (used[n] && fixed[n] == wanted) {
        number[n] = part.n_nodes();
        node.push_back(n);
        part.points.push_back(base.points[n]);
      }
    if (wanted) part.n_boundary = part.n_nodes();
  }
  for (int c = 0; c < base.n_cells(); ++c) {
    if (!is_in[c]) continue;
    std::vector<int> cell;
    for (const int n : base.cell(c)) cell.push_back(number[n]);
    part.add_cell(cell);
  }
  if (part.n_boundary == 0 || part.n_boundary == part.n_nodes()) return;
  const PlanarMesh smooth = smoothed(part, {}, context);
  if (quality(smooth.points, smooth).min <= quality(part.points, part).min) return;
  for (std::size_t i = 0; i < node.size(); ++i) base.points[node[i]] = smooth.points[i];
}

void throw_if_inverted(const Imprint& imprint, const BaseMesh& base) {
  std::vector<long> inverted;
  for (int c = 0; c < base.n_cells(); ++c)
    if (scaled_jacobian(base.points, base.cell(c)) <= 0.0) inverted.push_back(c);
  if (inverted.empty()) return;
  const Patch& patch = imprint.patches[base.cell_patch[inverted.front()]];
  throw InvalidMeshError("surface",
                         "The mesh of the patch between " + name_of(patch.runs[0].target) +
                             " and " + name_of(patch.runs[0].source) +
                             " keeps inverted cells; try a smaller element size.",
                         caps_of(patch), inverted);
}

}  // namespace

BaseMesh mesh_base_edges(const Imprint& imprint, const std::vector<int>& counts) {
  BaseMesh base;
  add_edge_nodes(imprint, counts, base);
  return base;
}

std::vector<int> loop_nodes(const BaseMesh& base, const Patch& patch) {
  std::vector<int> out;
  for (const auto& loop : patch.loops)
    for (const int n : nodes_of(base, loop)) out.push_back(n);
  return out;
}

BaseMesh mesh_base(const Model& model, const Imprint& imprint, const std::vector<int>& counts,
                   CellKind kind, Context& context, const GivenPatches& given) {
  BaseMesh base = mesh_base_edges(imprint, counts);
  const long n = static_cast<long>(imprint.patches.size());
  std::vector<PatchShape> shapes;
  for (const Patch& patch : imprint.patches)
    shapes.push_back(shape_of(model, imprint, counts, patch, base));
  std::vector<PatchMesh> meshes(n);
  ThreadTeam& team = team_of(context);
  team.for_chunks(n, 1, [&](long p, long, long) {
    context.check("surface");
    const auto own = given.find(static_cast<int>(p));
    meshes[p] = mesh_patch(shapes[p], imprint.patches[p],
                           own == given.end() ? nullptr : &own->second, kind, context);
  });
  for (long p = 0; p < n; ++p) add_patch(meshes[p], imprint.patches[p], static_cast<int>(p), base);
  relax(imprint, context, base);
  throw_if_inverted(imprint, base);
  return base;
}

}  // namespace sweepmesh
