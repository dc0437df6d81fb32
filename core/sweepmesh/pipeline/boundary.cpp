#include "sweepmesh/pipeline/boundary.h"

#include <algorithm>
#include <map>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/surface/cap_mesh.h"
#include "sweepmesh/surface/linking_columns.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

std::vector<std::string> names_of(const std::vector<FaceId>& faces) {
  std::vector<std::string> names;
  for (const FaceId f : faces) names.push_back(name_of(f));
  return names;
}

/// The only face of a role; InputError where there are more.
FaceId only_face(const Scheme& scheme, FaceRole role, const char* what) {
  const std::vector<FaceId> faces = scheme.faces_with(role);
  if (faces.size() == 1) return faces.front();
  throw InputError("surface",
                   "This solid sweeps with " + std::to_string(faces.size()) + " " + what +
                       " faces; sweeps with more than one are not served yet.",
                   names_of(faces));
}

/// The target's node under each node of the source's loops, at the foot of its column.
CapLoops feet(const Model& model, FaceId source, const CapLoops& loops, FaceId target,
              const EdgeMesh& edges, const std::vector<ColumnNodes>& columns,
              const std::vector<ColumnId>& column_at) {
  std::map<NodeId, CapNode> on_target;
  for (const auto& loop : cap_loops(model, target, edges.edge, edges.parameters.t))
    for (const CapNode& node : loop) on_target.emplace(node.node, node);
  CapLoops out = loops;
  for (auto& loop : out)
    for (CapNode& node : loop) {
      const ColumnId c = column_at[node.node.index];
      const auto foot =
          c.is_valid() ? on_target.find(columns[c.index].nodes.front()) : on_target.end();
      if (foot == on_target.end())
        throw InvalidMeshError("surface",
                               "The linking faces do not lead from " + name_of(source) + " to " +
                                   name_of(target) + ".",
                               {name_of(source), name_of(target)}, {});
      node = foot->second;
    }
  return out;
}

/// Both caps, whose loops have their nodes in the same order, those of the target against the way
/// they run there.
struct Ends {
  FaceId source, target;
  CapLoops source_loops, target_loops;
};

CapLoops turned_round(CapLoops loops) {
  for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
  return loops;
}

/// In the order of the nodes of `cap`, which are among `from`: those of `to`.
std::vector<CapNode> in_order_of(const CapMesh& cap, const CapLoops& from, const CapLoops& to) {
  std::map<NodeId, CapNode> over;
  for (std::size_t l = 0; l < from.size(); ++l)
    for (std::size_t i = 0; i < from[l].size(); ++i) over.emplace(from[l][i].node, to[l][i]);
  std::vector<CapNode> out;
  for (const NodeId n : cap.boundary) out.push_back(over.at(n));
  return out;
}

/// The other end of a cap whose mesh is given: its image, or, where it is given too, that.
CapMesh other_end(const Model& model, const CapMesh& cap, FaceId face,
                  const std::vector<CapNode>& boundary, const GivenBoundary& given, double size,
                  const Context& context) {
  const auto own = given.faces.find(face);
  if (own == given.faces.end()) return map_cap(model, cap, face, boundary, size, context);
  return same_mesh_on(model, cap, face, boundary, own->second, given.tolerance);
}

CapPair given_pair(const Model& model, const Ends& ends, const GivenBoundary& given, double size,
                   const Context& context) {
  const auto known = [&](FaceId face, const CapLoops& loops) {
    return cap_with_mesh(model, face, loops, given.faces.at(face), size, given.tolerance, context);
  };
  if (given.faces.contains(ends.source)) {
    const CapMesh source = known(ends.source, ends.source_loops);
    const auto there = in_order_of(source, ends.source_loops, ends.target_loops);
    return {source, other_end(model, source, ends.target, there, given, size, context)};
  }
  const CapMesh target = known(ends.target, turned_round(ends.target_loops));
  const auto there = in_order_of(target, ends.target_loops, ends.source_loops);
  return {other_end(model, target, ends.source, there, given, size, context), target};
}

}  // namespace

BoundaryMesh mesh_boundary(const Model& model, const Scheme& scheme, const Intervals& intervals,
                           const IntervalOptions& options, CellKind kind, Context& context,
                           const GivenBoundary& given) {
  const FaceId source = only_face(scheme, FaceRole::source, "source");
  const FaceId target = only_face(scheme, FaceRole::target, "target");
  BoundaryMesh mesh;
  EdgeNodes nodes = place_edge_nodes(model, intervals, options);
  take_edges(given, nodes);
  const EdgeMesh edges = mesh_edges(model, intervals, nodes, mesh.surface);
  mesh_linking_faces(model, scheme, intervals, edges, context, mesh.surface);
  take_linking_faces(scheme, given, mesh.surface);
  mesh.columns = linking_columns(mesh.surface);
  auto column_at = columns_at_nodes(mesh.columns, mesh.surface.n_nodes());

  const CapLoops loops = cap_loops(model, source, edges.edge, edges.parameters.t);
  const CapLoops partner = feet(model, source, loops, target, edges, mesh.columns, column_at);
  const Ends ends{source, target, loops, partner};
  const auto [upper, lower] =
      given.faces.contains(source) || given.faces.contains(target)
          ? given_pair(model, ends, given, options.size, context)
          : mesh_cap_pair(model, source, loops, target, partner, options.size, kind, context);
  const std::vector<NodeId> up = add_cap(upper, mesh.surface);
  const std::vector<NodeId> down = add_cap(lower, mesh.surface);
  add_runs_between(upper, up, down, 0, mesh.surface.k[up.front().index], column_at, mesh);
  drop_loose_nodes(mesh);
  return mesh;
}

std::vector<ColumnId> columns_at_nodes(const std::vector<ColumnNodes>& columns, int n_nodes) {
  std::vector<ColumnId> at(n_nodes);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (const NodeId node : columns[c].nodes)
      if (node.is_valid()) at[node.index] = ColumnId{c};
  return at;
}

std::vector<ColumnNodes> linking_columns(const SurfaceMesh& surface) {
  std::vector<ColumnNodes> columns;
  for (auto& chain : columns_from(surface).chains) {
    const int k_low = surface.k[chain.front().index];
    columns.push_back({k_low, std::move(chain)});
  }
  return columns;
}

void add_runs_between(const CapMesh& source, const std::vector<NodeId>& up,
                      const std::vector<NodeId>& down, int k_low, int k_high,
                      std::vector<ColumnId>& column_at, BoundaryMesh& mesh) {
  column_at.resize(mesh.surface.n_nodes());
  for (std::size_t n = 0; n < up.size(); ++n) {
    if (column_at[up[n].index].is_valid()) continue;
    ColumnNodes column{k_low, std::vector<NodeId>(k_high - k_low + 1)};
    column.nodes.front() = down[n];
    column.nodes.back() = up[n];
    for (const NodeId end : {down[n], up[n]}) column_at[end.index] = ColumnId{mesh.columns.size()};
    mesh.columns.push_back(std::move(column));
  }
  for (int c = 0; c < source.plane.n_cells(); ++c) {
    CellRun run{{}, k_low, k_high};
    for (const int n : source.plane.cell(c)) run.columns.push_back(column_at[up[n].index]);
    if (source.is_mirrored) std::reverse(run.columns.begin(), run.columns.end());
    mesh.runs.push_back(std::move(run));
  }
}

void drop_loose_nodes(BoundaryMesh& mesh) {
  SurfaceMesh& surface = mesh.surface;
  std::vector<char> is_used(surface.n_nodes(), 0);
  for (const int n : surface.cell_nodes) is_used[n] = 1;
  std::vector<int> number(surface.n_nodes(), -1);
  int n_used = 0;
  for (int n = 0; n < surface.n_nodes(); ++n) {
    if (!is_used[n]) continue;
    surface.points[n_used] = surface.points[n];
    surface.owner[n_used] = surface.owner[n];
    surface.k[n_used] = surface.k[n];
    number[n] = n_used++;
  }
  surface.points.resize(n_used);
  surface.owner.resize(n_used);
  surface.k.resize(n_used);
  for (int& n : surface.cell_nodes) n = number[n];
  for (ColumnNodes& column : mesh.columns)
    for (NodeId& n : column.nodes)
      if (n.is_valid()) n.index = number[n.index];
}

}  // namespace sweepmesh
