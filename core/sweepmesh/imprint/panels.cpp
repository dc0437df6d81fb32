#include "sweepmesh/imprint/panels.h"

#include <algorithm>
#include <optional>
#include <set>

#include "sweepmesh/imprint/leaning_face.h"
#include "sweepmesh/imprint/stepped_panels.h"

namespace sweepmesh {
namespace {

class PanelFinder {
 public:
  PanelFinder(const Walls& walls, const Reference& seen)
      : walls_(walls), seen_(seen), curve_(walls.level.size()) {
    for (const ReferenceCurve& c : seen.curves) curve_[c.edge.index] = &c;
  }

  std::vector<Panel> upright(FaceId f) const {
    std::vector<Panel> out;
    for (const EdgeId e : walls_.bottoms[f.index]) {
      const std::vector<double> cuts = cuts_of(e, f);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        Polyline part_of_edge = part(line(e), cuts[i], cuts[i + 1]);
        const Point2 middle = at_arc(part_of_edge, length(part_of_edge) / 2).point;
        const auto top = first_top(f, walls_.level[e.index], middle);
        if (!top) continue;
        if (!walls_.solid_left_above[e.index])
          std::reverse(part_of_edge.begin(), part_of_edge.end());
        out.push_back({f, walls_.level[e.index], *top, {0.0, 1.0}, {part_of_edge, part_of_edge}});
      }
    }
    return out;
  }

 private:
  const Polyline& line(EdgeId e) const { return curve_[e.index]->points; }

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

  const Walls& walls_;
  const Reference& seen_;
  std::vector<const ReferenceCurve*> curve_;
};

/// By lengths all along the face, or, where that is refused (holes), from level to level.
std::vector<Panel> leaning(const Model& model, const Scheme& scheme, const Walls& walls,
                           const Reference& seen, const LevelHeights& height, FaceId face) {
  try {
    return leaning_panels(model, scheme, walls, seen, height, face);
  } catch (const ImprintError&) {
    auto panels = stepped_panels(model, scheme, walls, seen, height, face);
    if (panels.empty()) throw;
    return panels;
  }
}

}  // namespace

Polyline Panel::at(double where) const {
  const auto above = std::upper_bound(share.begin() + 1, share.end() - 1, where);
  const std::size_t i = above - share.begin() - 1;
  const double f = (where - share[i]) / (share[i + 1] - share[i]);
  Polyline out = line[i];
  for (std::size_t p = 0; p < out.size(); ++p) out[p] += f * (line[i + 1][p] - line[i][p]);
  return out;
}

std::vector<Panel> find_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                               const Reference& seen, const LevelHeights& height) {
  const PanelFinder finder(walls, seen);
  std::vector<Panel> out;
  for (const FaceId f : scheme.faces_with(FaceRole::linking)) {
    if (walls.bottoms[f.index].empty() && walls.tops[f.index].empty()) continue;
    const auto panels = is_upright(walls, seen, f) ? finder.upright(f)
                                                   : leaning(model, scheme, walls, seen, height, f);
    out.insert(out.end(), panels.begin(), panels.end());
  }
  return out;
}

}  // namespace sweepmesh
