#include "sweepmesh/imprint/axial_edges.h"

namespace sweepmesh {

std::vector<AxialEdge> axial_edges(const Model& model, const Scheme& scheme) {
  std::vector<AxialEdge> out;
  for (const FaceId f : model.faces()) {
    if (scheme.face_role[f.index] != FaceRole::linking) continue;
    const auto& loops = model.loops(f);
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        const Direction d = scheme.face[f.index].direction[l][c];
        const Coedge& e = loops[l][c];
        if (d == Direction::plus_k) out.push_back({e.edge, e.start, e.end});
        if (d == Direction::minus_k) out.push_back({e.edge, e.end, e.start});
      }
  }
  return out;
}

}  // namespace sweepmesh
