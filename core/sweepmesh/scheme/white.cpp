#include "sweepmesh/scheme/white.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "sweepmesh/scheme/vertex_types.h"

namespace sweepmesh {

namespace {

int modulo4(int x) {
  return (x % 4 + 4) % 4;
}

/// Unknown rotations by quarter turns, joined by known differences.
class Rotations {
 public:
  explicit Rotations(int n) : parent_(n), offset_(n, 0) {
    for (int i = 0; i < n; ++i) parent_[i] = i;
  }

  /// rotation(a) - rotation(b) = difference; false where that contradicts what is known.
  bool join(int a, int b, int difference) {
    const auto [ra, oa] = root(a);
    const auto [rb, ob] = root(b);
    if (ra == rb) return modulo4(oa - ob - difference) == 0;
    parent_[ra] = rb;
    offset_[ra] = modulo4(difference + ob - oa);
    return true;
  }

 private:
  /// The representative and the rotation relative to it.
  std::pair<int, int> root(int a) const {
    int offset = 0;
    while (parent_[a] != a) {
      offset += offset_[a];
      a = parent_[a];
    }
    return {a, modulo4(offset)};
  }

  std::vector<int> parent_, offset_;
};

class White {
 public:
  White(const SweepProblem& problem, const std::vector<FaceId>& caps)
      : problem_(problem),
        is_cap_(problem.faces.size()),
        direction_(problem.coedges.size(), 0),
        rotations_(static_cast<int>(problem.faces.size())) {
    for (std::size_t f = 0; f < problem.faces.size(); ++f)
      is_cap_[f] = std::ranges::find(caps, problem.faces[f].id) != caps.end();
  }

  WhiteConditions check() {
    out_ = {true, true, true, {}};
    const bool has_linking = std::ranges::find(is_cap_, false) != is_cap_.end();
    if (!has_linking) out_.has_chains = false;
    for (std::size_t f = 0; f < is_cap_.size(); ++f)
      if (!is_cap_[f] && !set_directions(problem_.faces[f]))
        fault(out_.has_chains, problem_.faces[f].id);
    if (!out_.has_chains) return out_;
    // Chains and caps first, so that what fails later is the caps' fault.
    for (const ProblemEdge& edge : problem_.edges) join_alike(edge);
    for (VertexType type : {VertexType::end, VertexType::corner})
      for (const ProblemEdge& edge : problem_.edges) join_cap(edge, type);
    return out_;
  }

 private:
  template <class Id>
  void fault(bool& condition, Id id) {
    condition = false;
    out_.entities.push_back(name_of(id));
  }

  int face_of(int coedge) const { return problem_.coedges[coedge].face; }

  /// Directions from the nearest types, up to a rotation of the whole face. False where a loop does
  /// not close.
  bool set_directions(const ProblemFace& face) {
    std::optional<double> frame;
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
      const ProblemLoop& loop = face.loops[l];
      int turning = 0;
      double x = 0.0, y = 0.0;  // of the heading that direction 0 has, on average
      for (int c = loop.first; c < loop.first + loop.count; ++c) {
        direction_[c] = modulo4(turning);
        const double zero = problem_.coedges[c].heading - turning * kQuarterTurn;
        x += problem_.coedges[c].length * std::cos(zero);
        y += problem_.coedges[c].length * std::sin(zero);
        turning += static_cast<int>(nearest_type(problem_.coedges[c].angle));
      }
      if (turning != (l == 0 ? 4 : -4) || face.is_degenerate) return false;
      const double own = std::atan2(y, x);
      if (!frame) frame = own;
      const int rotation = static_cast<int>(std::lround((own - *frame) / kQuarterTurn));
      for (int c = loop.first; c < loop.first + loop.count; ++c)
        direction_[c] = modulo4(direction_[c] + rotation);
    }
    return !face.loops.empty();
  }

  /// Two linking faces share their parameters, two caps are one set.
  void join_alike(const ProblemEdge& edge) {
    const auto [a, b] = edge.coedge;
    const bool is_cap = is_cap_[face_of(a)];
    if (is_cap != is_cap_[face_of(b)]) return;
    const int difference = is_cap ? 0 : direction_[b] + 2 - direction_[a];
    if (!rotations_.join(face_of(a), face_of(b), difference)) fault(out_.has_chains, edge.id);
  }

  /// A cap set's rotation is the direction that the linking coedge of an END edge has.
  void join_cap(const ProblemEdge& edge, VertexType wanted) {
    auto [cap, linking] = edge.coedge;
    if (is_cap_[face_of(linking)]) std::swap(cap, linking);
    if (!is_cap_[face_of(cap)] || is_cap_[face_of(linking)]) return;
    const VertexType type = nearest_type(edge.mean);
    if (type != wanted && !(wanted == VertexType::end && type == VertexType::side)) return;
    if (type == VertexType::side) return fault(out_.agrees_over_equal_edges, edge.id);
    const int turn = type == VertexType::end ? 0 : 2;
    if (rotations_.join(face_of(cap), face_of(linking), direction_[linking] - turn)) return;
    fault(type == VertexType::end ? out_.agrees_over_equal_edges : out_.opposes_over_unequal_edges,
          edge.id);
  }

  const SweepProblem& problem_;
  std::vector<bool> is_cap_;
  std::vector<int> direction_;  // by coedge of linking faces
  Rotations rotations_;         // by face: added to its directions; of caps see join_cap
  WhiteConditions out_;
};

}  // namespace

WhiteConditions white_conditions(const SweepProblem& problem, const std::vector<FaceId>& caps) {
  return White(problem, caps).check();
}

}  // namespace sweepmesh
