#include "sweepmesh/surface/submap_boundary.h"

#include <cstdlib>
#include <limits>

#include "sweepmesh/intervals/face_layout.h"

namespace sweepmesh {
namespace {

class Gatherer {
 public:
  Gatherer(const Model& model, const Scheme& scheme, const Intervals& intervals,
           const EdgeMesh& edges, FaceId face, const SurfaceMesh& mesh)
      : model_(model),
        scheme_(scheme),
        intervals_(intervals),
        edges_(edges),
        face_(face),
        mesh_(mesh) {}

  SubmapBoundary gather() {
    const auto& loops = model_.loops(face_);
    const auto shift = unwrapping(model_, face_);
    for (std::size_t l = 0; l < loops.size(); ++l) add_loop(l, shift[l]);
    if (out_.period > 0) align_rims();
    return std::move(out_);
  }

 private:
  void add_loop(std::size_t l, const std::vector<Point2>& shift) {
    const Loop& loop = model_.loops(face_)[l];
    const int i = l == 0 ? 0 : intervals_.loop_i[face_.index][l];
    out_.loops.push_back({{i, intervals_.k[loop.front().start.index]}, {}});
    out_.nodes.emplace_back();
    out_.uv.emplace_back();
    for (std::size_t c = 0; c < loop.size(); ++c)
      add_coedge(loop[c], scheme_.face[face_.index].direction[l][c], shift[c]);
    GridPoint end = out_.loops.back().start;
    for (const Direction d : out_.loops.back().steps) end = stepped(end, d);
    if (end.i != i) {
      out_.period = std::abs(end.i - i);
      rims_.push_back(l);
    }
  }

  void add_coedge(const Coedge& c, Direction d, const Point2& shift) {
    const auto& t = edges_.parameters.t[c.edge.index];
    const auto& chain = edges_.edge[c.edge.index];
    const int n = static_cast<int>(t.size()) - 1;
    for (int s = 0; s < n; ++s) {
      out_.loops.back().steps.push_back(d);
      out_.nodes.back().push_back(chain[c.reversed ? n - s : s]);
      out_.uv.back().push_back(model_.uv(c, t[c.reversed ? n - s : s]) + shift);
    }
  }

  Point3 position(std::size_t loop, int step) const {
    const int n = static_cast<int>(out_.nodes[loop].size());
    return mesh_.points[out_.nodes[loop][((step % n) + n) % n].index];
  }

  /// Nothing ties the two rims of a tube without a seam to one another: the second is turned so
  /// that the squared distances between nodes of equal i are least.
  void align_rims() {
    if (rims_.size() != 2 || out_.nodes[rims_[0]].size() != out_.nodes[rims_[1]].size()) return;
    const std::size_t a = rims_[0], b = rims_[1];
    const int sign_a = out_.loops[a].steps.front() == Direction::plus_i ? 1 : -1;
    double least = std::numeric_limits<double>::max();
    const int first = out_.loops[a].start.i;
    for (int turn = 0; turn < out_.period; ++turn) {
      double sum =
          0.0;  // node j of a has i = first + sign_a j, node j of b has i = start - sign_a j
      for (int j = 0; j < out_.period; ++j)
        sum += (position(a, j) - position(b, sign_a * turn - j)).squaredNorm();
      if (sum >= least) continue;
      least = sum;
      out_.loops[b].start.i = first + turn;
    }
  }

  const Model& model_;
  const Scheme& scheme_;
  const Intervals& intervals_;
  const EdgeMesh& edges_;
  FaceId face_;
  const SurfaceMesh& mesh_;
  SubmapBoundary out_;
  std::vector<std::size_t> rims_;  ///< loops that wind around
};

}  // namespace

SubmapBoundary submap_boundary(const Model& model, const Scheme& scheme, const Intervals& intervals,
                               const EdgeMesh& edges, const SurfaceMesh& mesh, FaceId face) {
  return Gatherer(model, scheme, intervals, edges, face, mesh).gather();
}

}  // namespace sweepmesh
