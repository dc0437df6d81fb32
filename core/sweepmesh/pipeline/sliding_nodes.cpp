#include "sweepmesh/pipeline/sliding_nodes.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

namespace sweepmesh {
namespace {

/// Brings nodes back onto their faces, one at a time.
class Returner {
 public:
  Returner(const Model& model, std::vector<std::pair<long, FaceId>> face_of)
      : model_(model), face_of_(std::move(face_of)) {}

  CurvedNodes::Place operator()(long node, const Point3& wished) {
    const FaceId face =
        std::lower_bound(face_of_.begin(), face_of_.end(), node, [](const auto& f, long n) {
          return f.first < n;
        })->second;
    const std::lock_guard lock(mutex_);
    const Point2 uv = model_.project(face, wished);
    return {model_.point(face, uv), model_.normal(face, uv)};
  }

 private:
  const Model& model_;
  std::vector<std::pair<long, FaceId>> face_of_;
  std::mutex mutex_;
};

}  // namespace

MovableNodes movable_nodes(const Model& model, const SurfaceMesh& surface, const Assembly& assembly,
                           const std::set<FaceId>& held) {
  std::vector<std::optional<Point3>> normal_of(model.n_faces());
  for (const FaceId f : model.faces())
    if (model.is_planar(f)) normal_of[f.index] = model.normal(f, model.uv_bounds(f).first);
  MovableNodes out;
  std::vector<std::pair<long, FaceId>> face_of;
  for (int i = 0; i < surface.n_nodes(); ++i) {
    const Owner& owner = surface.owner[i];
    if (owner.kind != EntityKind::face || held.contains(FaceId{owner.index})) continue;
    if (normal_of[owner.index])
      out.sliding.push_back({assembly.volume_node[i], *normal_of[owner.index]});
    else
      face_of.emplace_back(assembly.volume_node[i], FaceId{owner.index});
  }
  std::sort(out.sliding.begin(), out.sliding.end(),
            [](const SlidingNode& a, const SlidingNode& b) { return a.node < b.node; });
  std::sort(face_of.begin(), face_of.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [node, face] : face_of) out.curved.nodes.push_back(node);
  const auto onto = std::make_shared<Returner>(model, std::move(face_of));
  out.curved.onto = [onto](long node, const Point3& p) { return (*onto)(node, p); };
  return out;
}

}  // namespace sweepmesh
