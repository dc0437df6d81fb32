#include "sweepmesh/imprint/base_mesh.h"

#include "sweepmesh/imprint/polyline.h"

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

void add_patch(int patch, const std::vector<std::vector<DirectedEdge>>& loops,
               const PlanarMeshOptions& options, const Context& context, BaseMesh& base) {
  std::vector<int> node;
  PlanarLoops points;
  for (const auto& loop : loops) {
    points.emplace_back();
    for (const int n : nodes_of(base, loop)) {
      node.push_back(n);
      points.back().push_back(base.points[n]);
    }
  }
  const PlanarMesh mesh = mesh_planar(points, options, context);
  for (int i = mesh.n_boundary; i < mesh.n_nodes(); ++i) {
    node.push_back(base.n_nodes());
    base.points.push_back(mesh.points[i]);
  }
  for (int c = 0; c < mesh.n_cells(); ++c) {
    for (const int n : mesh.cell(c)) base.cell_nodes.push_back(node[n]);
    base.cell_offset.push_back(static_cast<int>(base.cell_nodes.size()));
    base.cell_patch.push_back(patch);
  }
}

std::vector<std::string> caps_of(const Patch& patch) {
  std::vector<std::string> names;
  for (const Run& r : patch.runs)
    for (const FaceId f : {r.target, r.source}) names.push_back(name_of(f));
  return names;
}

}  // namespace

BaseMesh mesh_base(const Imprint& imprint, const std::vector<int>& counts, double size,
                   CellKind kind, Context& context) {
  BaseMesh base;
  add_edge_nodes(imprint, counts, base);
  PlanarMeshOptions options;
  options.size = size;
  options.kind = kind;
  for (std::size_t p = 0; p < imprint.patches.size(); ++p) {
    context.check("surface");
    const Patch& patch = imprint.patches[p];
    const auto sentence = [&](const Error& e) {
      return "The patch between " + name_of(patch.runs[0].target) + " and " +
             name_of(patch.runs[0].source) + ": " + e.what();
    };
    try {
      add_patch(static_cast<int>(p), patch.loops, options, context, base);
    } catch (const InvalidMeshError& e) {
      throw InvalidMeshError(e.stage(), sentence(e), caps_of(patch), e.elements());
    } catch (const InputError& e) {
      throw InputError(e.stage(), sentence(e), caps_of(patch));
    }
  }
  return base;
}

}  // namespace sweepmesh
