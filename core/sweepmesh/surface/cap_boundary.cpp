#include "sweepmesh/surface/cap_boundary.h"

#include <algorithm>

namespace sweepmesh {
namespace {

bool bounds(const Coedge& c) {
  return c.edge.is_valid() && !c.seam;
}

int other_use(const Loop& loop, int i) {
  for (int j = 0; j < static_cast<int>(loop.size()); ++j)
    if (j != i && loop[j].edge == loop[i].edge) return j;
  return i;
}

/// The coedge that bounds the face after coedge i, once its seams are sewn up.
int next_in_boundary(const Loop& loop, int i) {
  const int n = static_cast<int>(loop.size());
  int k = (i + 1) % n;
  for (int passed = 0; passed < n && !bounds(loop[k]); ++passed)
    k = ((loop[k].seam ? other_use(loop, k) : k) + 1) % n;
  return k;
}

/// All nodes of a coedge but its last, in the direction of the loop.
void append(const Model& model, const Coedge& c, const std::vector<NodeId>& nodes,
            const std::vector<double>& t, std::vector<CapNode>& out) {
  const int n = static_cast<int>(nodes.size());
  for (int s = 0; s + 1 < n; ++s) {
    const int i = c.reversed ? n - 1 - s : s;
    out.push_back({nodes[i], model.point(c.edge, t[i]), model.uv(c, t[i])});
  }
}

}  // namespace

std::vector<Loop> bounding_loops(const Model& model, FaceId face) {
  std::vector<Loop> out;
  for (const Loop& loop : model.loops(face)) {
    std::vector<char> is_done(loop.size(), 0);
    for (int first = 0; first < static_cast<int>(loop.size()); ++first) {
      if (!bounds(loop[first]) || is_done[first]) continue;
      out.emplace_back();
      for (int i = first; !is_done[i]; i = next_in_boundary(loop, i)) {
        is_done[i] = 1;
        out.back().push_back(loop[i]);
      }
    }
  }
  return out;
}

CapLoops cap_loops(const Model& model, FaceId face,
                   const std::vector<std::vector<NodeId>>& edge_nodes,
                   const std::vector<std::vector<double>>& edge_t) {
  CapLoops out;
  for (const Loop& loop : bounding_loops(model, face)) {
    out.emplace_back();
    for (const Coedge& c : loop)
      append(model, c, edge_nodes[c.edge.index], edge_t[c.edge.index], out.back());
  }
  return out;
}

}  // namespace sweepmesh
