#include "sweepmesh/surface/submap_boundary.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

const char* const stage = "surface";

/// Whole periods to add to `from` so that it comes nearest to `to`.
Point2 period_shift(const Point2& from, const Point2& to, const Point2& periods) {
  Point2 shift = Point2::Zero();
  for (int d = 0; d < 2; ++d)
    if (periods[d] > 0.0) shift[d] = periods[d] * std::round((to[d] - from[d]) / periods[d]);
  return shift;
}

Point2 centre_of(const std::vector<Point2>& points) {
  Point2 low = points.front(), high = points.front();
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 0.5 * (low + high);
}

class Gatherer {
 public:
  Gatherer(const Model& model, const Scheme& scheme, const Intervals& intervals,
           const EdgeMesh& edges, FaceId face)
      : model_(model), scheme_(scheme), intervals_(intervals), edges_(edges), face_(face) {}

  SubmapBoundary gather() {
    const auto& loops = model_.loops(face_);
    for (std::size_t l = 0; l < loops.size(); ++l) add_loop(l);
    for (std::size_t l = 1; l < loops.size(); ++l) bring_near(out_.uv[l]);
    return std::move(out_);
  }

 private:
  void add_loop(std::size_t l) {
    const Loop& loop = model_.loops(face_)[l];
    const int i = l == 0 ? 0 : intervals_.loop_i[face_.index][l];
    out_.loops.push_back({{i, intervals_.k[loop.front().start.index]}, {}});
    out_.nodes.emplace_back();
    out_.uv.emplace_back();
    has_last_ = false;
    for (std::size_t c = 0; c < loop.size(); ++c)
      add_coedge(loop[c], scheme_.face[face_.index].direction[l][c]);
    GridPoint end = out_.loops.back().start;
    for (const Direction d : out_.loops.back().steps) end = stepped(end, d);
    if (end.i != i) out_.period = std::abs(end.i - i);
  }

  void add_coedge(const Coedge& c, Direction d) {
    if (!c.edge.is_valid())
      throw InputError(stage,
                       name_of(face_) +
                           " is a linking face with a pole, where a structured grid would "
                           "collapse to a point.",
                       {name_of(face_)});
    const auto& t = edges_.parameters.t[c.edge.index];
    const auto& chain = edges_.edge[c.edge.index];
    const int n = static_cast<int>(t.size()) - 1;
    std::vector<Point2> uv;
    for (int s = 0; s <= n; ++s) uv.push_back(model_.uv(c, t[c.reversed ? n - s : s]));
    const Point2 shift =
        has_last_ ? period_shift(uv.front(), last_, model_.periods(face_)) : Point2(0.0, 0.0);
    for (int s = 0; s < n; ++s) {
      out_.loops.back().steps.push_back(d);
      out_.nodes.back().push_back(chain[c.reversed ? n - s : s]);
      out_.uv.back().push_back(uv[s] + shift);
    }
    last_ = uv.back() + shift;
    has_last_ = true;
  }

  /// A hole on a periodic face may be given a period away from the outer loop.
  void bring_near(std::vector<Point2>& hole) const {
    const Point2 shift =
        period_shift(centre_of(hole), centre_of(out_.uv.front()), model_.periods(face_));
    for (auto& p : hole) p += shift;
  }

  const Model& model_;
  const Scheme& scheme_;
  const Intervals& intervals_;
  const EdgeMesh& edges_;
  FaceId face_;
  SubmapBoundary out_;
  Point2 last_ = Point2::Zero();
  bool has_last_ = false;
};

}  // namespace

SubmapBoundary submap_boundary(const Model& model, const Scheme& scheme, const Intervals& intervals,
                               const EdgeMesh& edges, FaceId face) {
  return Gatherer(model, scheme, intervals, edges, face).gather();
}

}  // namespace sweepmesh
