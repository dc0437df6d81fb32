#include "sweepmesh/surface/linking_edges.h"

namespace sweepmesh {
namespace {

/// Layer of the node `s` steps after the start of an edge.
int layer_on(int k_start, int k_end, int s) {
  if (k_start < 0 || k_end < 0) return -1;
  if (k_start == k_end) return k_start;
  return k_start + (k_end > k_start ? s : -s);
}

}  // namespace

EdgeMesh mesh_edges(const Model& model, const Intervals& intervals, const EdgeNodes& nodes,
                    SurfaceMesh& mesh) {
  EdgeMesh out{std::vector<NodeId>(model.n_vertices()),
               std::vector<std::vector<NodeId>>(model.n_edges()), nodes};
  for (const VertexId v : model.vertices())
    out.vertex[v.index] =
        mesh.add_node(model.point(v), {EntityKind::vertex, v.index}, intervals.k[v.index]);
  for (const EdgeId e : model.edges()) {
    const auto& t = nodes.t[e.index];
    const int k_start = intervals.k[model.start(e).index], k_end = intervals.k[model.end(e).index];
    auto& chain = out.edge[e.index];
    chain.push_back(out.vertex[model.start(e).index]);
    for (std::size_t s = 1; s + 1 < t.size(); ++s)
      chain.push_back(mesh.add_node(model.point(e, t[s]), {EntityKind::edge, e.index},
                                    layer_on(k_start, k_end, static_cast<int>(s))));
    chain.push_back(out.vertex[model.end(e).index]);
  }
  return out;
}

}  // namespace sweepmesh
