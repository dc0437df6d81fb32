#include "sweepmesh/pipeline/sliding_nodes.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

namespace sweepmesh {
namespace {

/// A node inside a curved face, and where it was at first.
struct CurvedNode {
  long node;
  FaceId face;
  Point3 start;
  std::optional<Point2> uv = {};  ///< of the start, once asked for
};

/// The foot of the perpendicular next to `near`, by Gauss and Newton's steps; empty where they do
/// not come to rest.
std::optional<Point2> foot_near(const Model& model, FaceId face, const Point3& p, Point2 uv) {
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const auto d = model.derivatives(face, uv);
    const Eigen::Matrix2d normal_matrix = d.transpose() * d;
    const Point2 move = normal_matrix.ldlt().solve(d.transpose() * (p - model.point(face, uv)));
    if (!move.allFinite()) return {};
    uv += move;
    if ((d * move).norm() <= model.tolerances().point) return uv;
  }
  return {};
}

/// Brings nodes back onto their faces, one at a time. A search over the whole surface is dear, so
/// each node's place is looked for from where the node began, whoever asks and however often: the
/// answer does not depend on the order.
class Returner {
 public:
  Returner(const Model& model, std::vector<CurvedNode> nodes)
      : model_(model), nodes_(std::move(nodes)) {}

  CurvedNodes::Place operator()(long node, const Point3& wished) {
    const auto at = std::ranges::lower_bound(nodes_, node, {}, &CurvedNode::node);
    const std::lock_guard lock(mutex_);
    const Point2 uv = foot(*at, wished);
    return {model_.point(at->face, uv), model_.normal(at->face, uv)};
  }

 private:
  Point2 foot(CurvedNode& at, const Point3& wished) const {
    if (!at.uv) at.uv = model_.project(at.face, at.start);
    const auto [low, high] = model_.uv_bounds(at.face);
    const auto near = foot_near(model_, at.face, wished, *at.uv);
    const bool is_inside =
        near && (near->array() >= low.array()).all() && (near->array() <= high.array()).all();
    return is_inside ? *near : model_.project(at.face, wished);
  }

  const Model& model_;
  std::vector<CurvedNode> nodes_;
  std::mutex mutex_;
};

}  // namespace

MovableNodes movable_nodes(const Model& model, const SurfaceMesh& surface, const Assembly& assembly,
                           const std::set<FaceId>& held) {
  std::vector<std::optional<Point3>> normal_of(model.n_faces());
  for (const FaceId f : model.faces())
    if (model.is_planar(f)) normal_of[f.index] = model.normal(f, model.uv_bounds(f).first);
  MovableNodes out;
  std::vector<CurvedNode> curved;
  for (int i = 0; i < surface.n_nodes(); ++i) {
    const Owner& owner = surface.owner[i];
    if (owner.kind != EntityKind::face || held.contains(FaceId{owner.index})) continue;
    if (normal_of[owner.index])
      out.sliding.push_back({assembly.volume_node[i], *normal_of[owner.index]});
    else
      curved.push_back({assembly.volume_node[i], FaceId{owner.index}, surface.points[i]});
  }
  std::sort(out.sliding.begin(), out.sliding.end(),
            [](const SlidingNode& a, const SlidingNode& b) { return a.node < b.node; });
  std::ranges::sort(curved, {}, &CurvedNode::node);
  for (const CurvedNode& c : curved) out.curved.nodes.push_back(c.node);
  const auto onto = std::make_shared<Returner>(model, std::move(curved));
  out.curved.onto = [onto](long node, const Point3& p) { return (*onto)(node, p); };
  return out;
}

}  // namespace sweepmesh
