#include "sweepmesh/imprint/stepped_panels.h"

#include <algorithm>
#include <set>

namespace sweepmesh {
namespace {

/// A place on a linking face, in its parameters and as it is seen along the sweep.
struct Spot {
  Point2 uv, seen;
};

/// A chain of axial coedges of a face, from a vertex with a level to the next one.
struct Side {
  int low, high;
  std::vector<Spot> spots;  ///< from the lower to the upper end
  bool is_left;             ///< the face is on its right, at larger i
};

/// A transverse edge of the face, along +i.
struct Rim {
  int level;
  bool is_bottom;
  Spot start, end;
  Polyline line;
};

class StepCutter {
 public:
  StepCutter(const Model& model, const Scheme& scheme, const Walls& walls, const Reference& seen,
             const Heights& height, FaceId face)
      : model_(model),
        directions_(scheme.face[face.index].direction),
        walls_(walls),
        seen_(seen),
        height_(height),
        face_(face) {}

  std::vector<Panel> run() {
    for (std::size_t l = 0; l < directions_.size(); ++l) {
      add_rims(l);
      if (!add_sides(l)) return {};
    }
    std::set<int> levels;
    for (const Rim& rim : rims_) {
      along_ += rim.end.uv - rim.start.uv;
      levels.insert(rim.level);
    }
    for (const Side& side : sides_) levels.insert({side.low, side.high});
    if (along_.norm() == 0.0) return {};
    for (auto it = levels.begin(); it != levels.end() && std::next(it) != levels.end(); ++it)
      if (!add_strips(*it, *std::next(it))) return {};
    return std::move(out_);
  }

 private:
  Spot spot_of(const Coedge& c, double fraction) const {
    const auto [first, last] = model_.range(c.edge);
    const double t =
        c.reversed ? last + fraction * (first - last) : first + fraction * (last - first);
    return {model_.uv(c, t), seen_.project(model_.point(c.edge, t))};
  }

  void add_rims(std::size_t l) {
    const Loop& loop = model_.loops(face_)[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Direction d = directions_[l][i];
      const Coedge& c = loop[i];
      if (!c.edge.is_valid() || is_axial(d) || walls_.level[c.edge.index] < 0) continue;
      const auto curve = std::find_if(seen_.curves.begin(), seen_.curves.end(),
                                      [&](const ReferenceCurve& r) { return r.edge == c.edge; });
      const bool is_bottom = d == Direction::plus_i;
      Rim rim{walls_.level[c.edge.index], is_bottom, spot_of(c, 0.0), spot_of(c, 1.0),
              curve->points};
      if (!is_bottom) std::swap(rim.start, rim.end);
      if (c.reversed == is_bottom) std::reverse(rim.line.begin(), rim.line.end());
      rims_.push_back(std::move(rim));
    }
  }

  /// False where an axial chain does not run from level to level.
  bool add_sides(std::size_t l) {
    const Loop& loop = model_.loops(face_)[l];
    const std::size_t n = loop.size();
    const auto level = [&](const Coedge& c) { return walls_.vertex_level[c.start.index]; };
    for (std::size_t first = 0; first < n; ++first) {
      const Direction d = directions_[l][first];
      if (!is_axial(d) || level(loop[first]) < 0) continue;
      std::vector<Spot> spots;
      std::size_t i = first;
      do {
        if (directions_[l][i % n] != d || i > first + n) return false;
        add_spots(loop[i % n], spots);
        ++i;
      } while (level(loop[i % n]) < 0);
      Side side{level(loop[first]), level(loop[i % n]), std::move(spots), d == Direction::minus_k};
      if (side.is_left) {
        std::swap(side.low, side.high);
        std::reverse(side.spots.begin(), side.spots.end());
      }
      if (side.low >= side.high) return false;
      sides_.push_back(std::move(side));
    }
    return true;
  }

  void add_spots(const Coedge& c, std::vector<Spot>& spots) const {
    constexpr int n_parts = 16;
    for (int i = spots.empty() ? 0 : 1; i <= n_parts; ++i)
      spots.push_back(spot_of(c, static_cast<double>(i) / n_parts));
  }

  /// Seen, a side is taken as straight, as its neighbours on the other face do.
  Spot spot_at(const Side& side, double height) const {
    const double low = height_.at(side.low), high = height_.at(side.high);
    const double share = std::clamp((height - low) / (high - low), 0.0, 1.0);
    const auto at = static_cast<std::size_t>(std::lround(share * (side.spots.size() - 1)));
    const Point2 first = side.spots.front().seen, last = side.spots.back().seen;
    return {side.spots[at].uv, first + share * (last - first)};
  }

  double i_of(const Spot& spot) const { return spot.uv.dot(along_); }

  bool add_strips(int low, int high) {
    const double middle = (height_.at(low) + height_.at(high)) / 2;
    std::vector<const Side*> sides;
    for (const Side& side : sides_)
      if (side.low <= low && side.high >= high) sides.push_back(&side);
    std::stable_sort(sides.begin(), sides.end(), [&](const Side* a, const Side* b) {
      return i_of(spot_at(*a, middle)) < i_of(spot_at(*b, middle));
    });
    if (sides.empty() || sides.size() % 2 != 0) return false;
    for (std::size_t s = 0; s < sides.size(); s += 2) {
      if (!sides[s]->is_left || sides[s + 1]->is_left) return false;
      const Polyline bottom = end_of_strip(*sides[s], *sides[s + 1], low, true);
      const Polyline top = end_of_strip(*sides[s], *sides[s + 1], high, false);
      if (length(bottom) == 0.0 || length(top) == 0.0) return false;
      out_.push_back(ruled_panel(face_, low, high, bottom, top));
    }
    return true;
  }

  /// The edges between two sides at a level, and where there are none lines in the face.
  Polyline end_of_strip(const Side& left, const Side& right, int level, bool is_bottom) const {
    const Spot first = spot_at(left, height_.at(level)), last = spot_at(right, height_.at(level));
    std::vector<const Rim*> rims;
    for (const Rim& rim : rims_) {
      const double middle = (i_of(rim.start) + i_of(rim.end)) / 2;
      if (rim.level == level && rim.is_bottom == is_bottom && middle > i_of(first) &&
          middle < i_of(last))
        rims.push_back(&rim);
    }
    std::stable_sort(rims.begin(), rims.end(), [&](const Rim* a, const Rim* b) {
      return i_of(a->start) + i_of(a->end) < i_of(b->start) + i_of(b->end);
    });
    Polyline out = {first.seen};
    Spot here = first;
    for (const Rim* rim : rims) {
      add_gap(here, rim->start, out);
      out.insert(out.end(), rim->line.begin() + 1, rim->line.end());
      here = rim->end;
    }
    add_gap(here, last, out);
    return out;
  }

  void add_gap(const Spot& from, const Spot& to, Polyline& out) const {
    constexpr int n_parts = 24;
    if ((from.seen - to.seen).norm() <= seen_.coincidence &&
        (from.uv - to.uv).norm() <= 0.5 * along_.norm() / std::max<std::size_t>(1, rims_.size()))
      return;
    Polyline line;
    for (int i = 0; i <= n_parts; ++i) {
      const double f = static_cast<double>(i) / n_parts;
      line.push_back(seen_.project(model_.point(face_, Point2(from.uv + f * (to.uv - from.uv)))));
    }
    line = with_ends(line, from.seen, to.seen);
    out.insert(out.end(), line.begin() + 1, line.end());
  }

  const Model& model_;
  const std::vector<std::vector<Direction>>& directions_;
  const Walls& walls_;
  const Reference& seen_;
  const Heights& height_;
  FaceId face_;
  std::vector<Side> sides_;
  std::vector<Rim> rims_;
  Point2 along_ = Point2::Zero();  ///< the direction of +i in the parameters
  std::vector<Panel> out_;
};

}  // namespace

std::vector<Panel> stepped_panels(const Model& model, const Scheme& scheme, const Walls& walls,
                                  const Reference& seen, const Heights& height, FaceId face) {
  return StepCutter(model, scheme, walls, seen, height, face).run();
}

}  // namespace sweepmesh
