#include "sweepmesh/imprint/panels.h"

#include <algorithm>
#include <optional>
#include <set>

#include "sweepmesh/imprint/stepped_panels.h"

namespace sweepmesh {
namespace {

class PanelFinder {
 public:
  PanelFinder(const Model& model, const Scheme& scheme, const Walls& walls, const Reference& seen,
              const Heights& height)
      : model_(model),
        scheme_(scheme),
        walls_(walls),
        seen_(seen),
        height_(height),
        curve_(walls.level.size()) {
    for (const ReferenceCurve& c : seen.curves) curve_[c.edge.index] = &c;
  }

  std::vector<Panel> run() {
    for (const FaceId f : scheme_.faces_with(FaceRole::linking)) {
      if (walls_.bottoms[f.index].empty() && walls_.tops[f.index].empty()) continue;
      if (is_upright(walls_, seen_, f))
        add_upright(f);
      else
        add_ruled(f);
    }
    return std::move(out_);
  }

 private:
  const Polyline& line(EdgeId e) const { return curve_[e.index]->points; }

  // --- upright faces -----------------------------------------------------------------------------

  void add_upright(FaceId f) {
    for (const EdgeId e : walls_.bottoms[f.index]) {
      const std::vector<double> cuts = cuts_of(e, f);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        Polyline part_of_edge = part(line(e), cuts[i], cuts[i + 1]);
        const Point2 middle = at_arc(part_of_edge, length(part_of_edge) / 2).point;
        const auto top = first_top(f, walls_.level[e.index], middle);
        if (!top) continue;
        if (!walls_.solid_left_above[e.index])
          std::reverse(part_of_edge.begin(), part_of_edge.end());
        out_.push_back({f, walls_.level[e.index], *top, part_of_edge, part_of_edge});
      }
    }
  }

  /// Positions on an edge of its ends and of the ends of all other edges of the face that lie on
  /// it.
  std::vector<double> cuts_of(EdgeId e, FaceId f) const {
    const double last = static_cast<double>(line(e).size() - 1);
    std::set<double> cuts = {0.0, last};
    for (const auto* edges : {&walls_.bottoms[f.index], &walls_.tops[f.index]})
      for (const EdgeId other : *edges)
        for (const Point2& end : {line(other).front(), line(other).back()}) {
          const PolylinePoint foot = nearest(line(e), end);
          const double rest = length(line(e)) - foot.arc;
          if (foot.distance <= seen_.coincidence && foot.arc > seen_.coincidence &&
              rest > seen_.coincidence)
            cuts.insert(foot.position);
        }
    return {cuts.begin(), cuts.end()};
  }

  std::optional<int> first_top(FaceId f, int above, const Point2& p) const {
    std::optional<int> level;
    for (const EdgeId e : walls_.tops[f.index]) {
      const int l = walls_.level[e.index];
      if (l <= above || (level && l >= *level)) continue;
      if (nearest(line(e), p).distance <= 2 * seen_.coincidence) level = l;
    }
    return level;
  }

  // --- other faces -------------------------------------------------------------------------------

  void add_ruled(FaceId f) {
    const Polyline low = chain(f, Direction::plus_i), high = chain(f, Direction::minus_i);
    const auto &bottoms = walls_.bottoms[f.index], &tops = walls_.tops[f.index];
    const auto is_level = [&](const std::vector<EdgeId>& edges) {
      return std::all_of(edges.begin(), edges.end(), [&](EdgeId e) {
        return walls_.level[e.index] == walls_.level[edges.front().index];
      });
    };
    if (low.empty() || high.empty() || !is_level(bottoms) || !is_level(tops)) return add_stepped(f);
    out_.push_back(ruled_panel(f, walls_.level[bottoms.front().index],
                               walls_.level[tops.front().index], low, high));
  }

  void add_stepped(FaceId f) {
    const auto panels = stepped_panels(model_, scheme_, walls_, seen_, height_, f);
    if (panels.empty())
      throw ImprintError(ImprintFailure::unreachable,
                         name_of(f) +
                             " leans along the sweep and has steps in its outline, so its "
                             "columns cannot be followed.",
                         {name_of(f)});
    out_.insert(out_.end(), panels.begin(), panels.end());
  }

  /// The edges along +i, or against it, as one line along +i (the solid on its left); empty where
  /// they are not one chain.
  Polyline chain(FaceId f, Direction d) const {
    const auto& loops = model_.loops(f);
    if (loops.size() != 1) return {};
    const auto& directions = scheme_.face[f.index].direction[0];
    const std::size_t n = loops[0].size();
    std::size_t first = n;
    for (std::size_t i = 0; i < n; ++i)
      if (directions[i] == d && directions[(i + n - 1) % n] != d) {
        if (first != n) return {};
        first = i;
      }
    Polyline out;
    for (std::size_t i = 0; first != n && i < n && directions[(first + i) % n] == d; ++i) {
      const Coedge& c = loops[0][(first + i) % n];
      Polyline points = line(c.edge);
      if (c.reversed) std::reverse(points.begin(), points.end());
      out.insert(out.end(), points.begin() + (out.empty() ? 0 : 1), points.end());
    }
    if (d == Direction::minus_i) std::reverse(out.begin(), out.end());
    return out;
  }

  const Model& model_;
  const Scheme& scheme_;
  const Walls& walls_;
  const Reference& seen_;
  const Heights& height_;
  std::vector<const ReferenceCurve*> curve_;
  std::vector<Panel> out_;
};

/// Inclined caps may have their means in another order than their levels.
void keep_growing(Heights& height) {
  constexpr double least_share = 0.01;  // of the mean distance between levels
  if (height.empty()) return;
  double low = height.begin()->second, high = low;
  for (const auto& [level, h] : height) {
    low = std::min(low, h);
    high = std::max(high, h);
  }
  const double least = least_share * (high - low) / static_cast<double>(height.size());
  for (auto it = std::next(height.begin()); it != height.end(); ++it)
    it->second = std::max(it->second, std::prev(it)->second + least);
}

}  // namespace

Heights level_heights(const Model& model, const Walls& walls, const Point3& direction,
                      const Reference& seen) {
  const auto height = [&](VertexId v) {
    return on_lattice(direction.dot(seen.straightened(model.point(v)) - seen.origin) / seen.unit,
                      seen.lattice);
  };
  std::map<int, std::pair<double, int>> sums;
  for (const EdgeId e : walls.edges) {
    auto& [sum, n] = sums[walls.level[e.index]];
    sum += height(model.start(e));
    ++n;
  }
  Heights out;
  for (const auto& [level, sum] : sums) out[level] = sum.first / sum.second;
  for (std::size_t i = 0; i < walls.vertex_level.size(); ++i)
    if (const int l = walls.vertex_level[i]; l >= 0 && !out.contains(l))
      out[l] = height(VertexId{i});
  keep_growing(out);
  return out;
}

Panel ruled_panel(FaceId face, int low, int high, const Polyline& bottom, const Polyline& top) {
  std::set<double> shares;  // of the length, at which either line has a point
  for (const Polyline* l : {&bottom, &top})
    for (const double arc : arc_lengths(*l)) shares.insert(arc / length(*l));
  Panel panel{face, low, high, {}, {}};
  for (const double share : shares) {
    panel.bottom.push_back(at_arc(bottom, share * length(bottom)).point);
    panel.top.push_back(at_arc(top, share * length(top)).point);
  }
  return panel;
}

std::vector<Panel> find_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                               const Reference& seen, const Heights& height) {
  return PanelFinder(model, scheme, walls, seen, height).run();
}

}  // namespace sweepmesh
