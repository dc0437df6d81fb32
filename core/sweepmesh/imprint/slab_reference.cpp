#include "sweepmesh/imprint/slab_reference.h"

#include <algorithm>
#include <map>
#include <set>

#include "sweepmesh/imprint/mean_value_field.h"

namespace sweepmesh {
namespace {

class SlabWalker {
 public:
  SlabWalker(const Model& model, const Scheme& scheme, const Walls& walls, const Point3& direction,
             const Reference& seen)
      : model_(model),
        walls_(walls),
        direction_(direction),
        seen_(seen),
        panels_(find_panels(model, scheme, walls, seen)),
        in_r_(panels_.size()),
        out_(seen) {}

  Reference run() {
    find_heights();
    const int n = static_cast<int>(height_.size());
    const int base = base_level();
    for (std::size_t p = 0; p < panels_.size(); ++p)
      if (panels_[p].low <= base && base <= panels_[p].high) in_r_[p] = seen_at(panels_[p], base);
    for (int level = base + 1; level < n; ++level) carry(level - 1, level, level);
    for (int level = base - 1; level >= 0; --level) carry(level, level + 1, level);
    for (const ReferenceCurve& c : out_.curves) {
      out_.vertex[model_.start(c.edge).index] = c.points.front();
      out_.vertex[model_.end(c.edge).index] = c.points.back();
    }
    return std::move(out_);
  }

 private:
  /// Mean height of every level; levels are numbered without gaps.
  void find_heights() {
    std::map<int, std::pair<double, int>> sums;
    for (const EdgeId e : walls_.edges) {
      auto& [sum, n] = sums[walls_.level[e.index]];
      sum += direction_.dot(model_.point(model_.start(e)));
      ++n;
    }
    for (const auto& [level, sum] : sums) height_[level] = sum.first / sum.second;
    for (std::size_t i = 0; i < walls_.vertex_level.size(); ++i)
      if (const int l = walls_.vertex_level[i]; l >= 0 && !height_.contains(l))
        height_[l] = direction_.dot(model_.point(VertexId{i}));
  }

  Polyline seen_at(const Panel& p, int level) const {
    const double low = height_.at(p.low), high = height_.at(p.high);
    const double share = (height_.at(level) - low) / (high - low);
    return p.at(std::clamp(share, 0.0, 1.0));
  }

  /// The lower level of the slab with the largest section.
  int base_level() const {
    int best = 0;
    double most = 0.0;
    for (int level = 0; level + 1 < static_cast<int>(height_.size()); ++level) {
      MeanValueField outline(seen_.coincidence);
      for (const Panel& p : panels_)
        if (p.low <= level && level + 1 <= p.high) outline.add(seen_at(p, level), seen_at(p, level));
      if (outline.double_area() > most) {
        most = outline.double_area();
        best = level;
      }
    }
    return best;
  }

  /// Brings the curves of a level to R by the outline of the slab between low and high.
  void carry(int low, int high, int level) {
    MeanValueField field(seen_.coincidence);
    for (std::size_t p = 0; p < panels_.size(); ++p)
      if (panels_[p].low <= low && high <= panels_[p].high)
        field.add(seen_at(panels_[p], level), in_r_[p]);
    for (ReferenceCurve& c : out_.curves)
      if (walls_.level[c.edge.index] == level) carry(field, low, high, level, c);
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      const bool begins = level == high ? panels_[p].low == level : panels_[p].high == level;
      if (!begins) continue;
      in_r_[p] = seen_at(panels_[p], level);
      for (Point2& x : in_r_[p]) x = field(x);
    }
  }

  void carry(const MeanValueField& field, int low, int high, int level, ReferenceCurve& c) const {
    std::set<double> positions;
    for (std::size_t i = 0; i < c.points.size(); ++i) positions.insert(static_cast<double>(i));
    // Where the linking faces' curves bend in R, the edge over them must bend too.
    for (const Panel& p : panels_)
      if (p.low <= low && high <= p.high)
        for (const Point2& x : seen_at(p, level)) {
          const PolylinePoint foot = nearest(c.points, x);
          if (foot.distance <= seen_.coincidence) positions.insert(foot.position);
        }
    ReferenceCurve in_r{c.edge, {}, {}};
    for (const double at : positions) {
      const std::size_t i = std::min(static_cast<std::size_t>(at), c.points.size() - 2);
      in_r.points.push_back(field(at_position(c.points, at).point));
      in_r.t.push_back(c.t[i] + (at - i) * (c.t[i + 1] - c.t[i]));
    }
    if (c.points.front() == c.points.back()) in_r.points.back() = in_r.points.front();
    c = std::move(in_r);
  }

  const Model& model_;
  const Walls& walls_;
  const Point3 direction_;
  const Reference& seen_;
  const std::vector<Panel> panels_;
  std::vector<Polyline> in_r_;  ///< by panel, once known
  std::map<int, double> height_;
  Reference out_;
};

}  // namespace

Reference slab_reference(const Model& model, const Scheme& scheme, const Walls& walls,
                         const Point3& direction, const Reference& seen) {
  return SlabWalker(model, scheme, walls, direction, seen).run();
}

}  // namespace sweepmesh
