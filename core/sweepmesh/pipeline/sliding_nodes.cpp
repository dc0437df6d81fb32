#include "sweepmesh/pipeline/sliding_nodes.h"

#include <algorithm>
#include <optional>

namespace sweepmesh {

std::vector<SlidingNode> sliding_nodes(const Model& model, const SurfaceMesh& surface,
                                       const Assembly& assembly, const std::set<FaceId>& held) {
  std::vector<std::optional<Point3>> normal_of(model.n_faces());
  for (const FaceId f : model.faces())
    if (model.is_planar(f) && !held.contains(f))
      normal_of[f.index] = model.normal(f, model.uv_bounds(f).first);
  std::vector<SlidingNode> out;
  for (int i = 0; i < surface.n_nodes(); ++i)
    if (const Owner& owner = surface.owner[i];
        owner.kind == EntityKind::face && normal_of[owner.index])
      out.push_back({assembly.volume_node[i], *normal_of[owner.index]});
  std::sort(out.begin(), out.end(),
            [](const SlidingNode& a, const SlidingNode& b) { return a.node < b.node; });
  return out;
}

}  // namespace sweepmesh
