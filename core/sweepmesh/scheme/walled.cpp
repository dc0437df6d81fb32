#include "sweepmesh/scheme/walled.h"

#include <algorithm>
#include <array>
#include <optional>

#include "sweepmesh/base/disjoint_sets.h"

namespace sweepmesh {
namespace {

/// Length of the mean of a face's unit normals, one where it is plane.
constexpr double kPlane = 0.9999;
/// A rim's edges are sharper than this, radians.
constexpr double kSharp = 5.0 / 3.0 * kQuarterTurn;

class Walls {
 public:
  explicit Walls(const SweepProblem& problem) : problem_(problem), lines_(problem.faces.size()) {
    for (std::size_t f = 0; f < problem.faces.size(); ++f)
      lines_[f] = lines_around(static_cast<int>(f));
  }

  /// By face: 0 for a rim, 1 or 2 for the side it is on; empty where there are no two sides.
  std::vector<int> sides() {
    find_rims();
    DisjointSets parts(static_cast<int>(problem_.faces.size()));
    for (const ProblemEdge& e : problem_.edges) {
      const int a = face_of(e.coedge[0]), b = face_of(e.coedge[1]);
      if (!is_rim_[a] && !is_rim_[b]) parts.join(a, b);
    }
    return coloured(parts);
  }

 private:
  int face_of(int coedge) const { return problem_.coedges[coedge].face; }
  bool is_plane(int face) const { return problem_.faces[face].normal.norm() > kPlane; }
  const ProblemEdge& edge_of(int coedge) const {
    return problem_.edges[problem_.coedges[coedge].edge];
  }
  int neighbour(int coedge) const { return face_of(problem_.coedges[coedge].partner); }

  /// The face's coedges by the closed lines that bound it, seams aside.
  std::vector<std::vector<int>> lines_around(int face) const {
    DisjointSets joined(problem_.n_vertices);
    const int first = problem_.first_coedge(face), last = first + problem_.n_coedges(face);
    for (int c = first; c < last; ++c)
      if (!edge_of(c).is_seam) joined.join(problem_.coedges[c].start, problem_.coedges[c].end);
    std::vector<std::vector<int>> out;
    std::vector<int> root;
    for (int c = first; c < last; ++c) {
      if (edge_of(c).is_seam) continue;
      const int r = joined.root(problem_.coedges[c].start);
      const auto at = std::ranges::find(root, r);
      if (at == root.end()) out.emplace_back();
      out[at - root.begin()].push_back(c);
      if (at == root.end()) root.push_back(r);
    }
    return out;
  }

  bool may_be_rim(int face) const {
    return lines_[face].size() == 2 && std::ranges::all_of(lines_[face], [&](const auto& line) {
             return std::ranges::all_of(line, [&](int c) { return edge_of(c).largest < kSharp; });
           });
  }

  void find_rims() {
    const int n = static_cast<int>(problem_.faces.size());
    is_rim_.assign(n, 0);
    for (int f = 0; f < n; ++f) is_rim_[f] = is_plane(f) && may_be_rim(f);
    const std::vector<char> is_plane_rim = is_rim_;
    for (int f = 0; f < n; ++f) {
      if (is_plane(f) || !may_be_rim(f)) continue;
      is_rim_[f] = std::ranges::none_of(lines_[f], [&](const auto& line) {
        return std::ranges::any_of(line, [&](int c) { return is_plane_rim[neighbour(c)]; });
      });
    }
  }

  /// The parts that lie beyond the two lines of a rim; empty where a line has several beyond it.
  std::optional<std::array<int, 2>> beyond(int rim, DisjointSets& parts) const {
    std::array<int, 2> out;
    for (int side = 0; side < 2; ++side) {
      const auto& line = lines_[rim][side];
      out[side] = parts.root(neighbour(line.front()));
      for (const int c : line)
        if (is_rim_[neighbour(c)] || parts.root(neighbour(c)) != out[side]) return {};
    }
    return out;
  }

  std::vector<int> coloured(DisjointSets& parts) const {
    const int n = static_cast<int>(problem_.faces.size());
    std::vector<std::array<int, 2>> across;
    for (int f = 0; f < n; ++f) {
      if (!is_rim_[f]) continue;
      const auto both = beyond(f, parts);
      if (!both) return {};
      across.push_back(*both);
    }
    if (across.empty()) return {};
    std::vector<int> side(n, 0);
    side[across.front()[0]] = 1;
    for (std::size_t pass = 0; pass < across.size(); ++pass)
      for (const auto& [a, b] : across) {
        if (side[a]) side[b] = side[b] ? side[b] : 3 - side[a];
        if (side[b]) side[a] = side[a] ? side[a] : 3 - side[b];
      }
    for (const auto& [a, b] : across)
      if (!side[a] || side[a] == side[b]) return {};
    std::vector<int> out(n, 0);
    for (int f = 0; f < n; ++f)
      if (!is_rim_[f] && !(out[f] = side[parts.root(f)])) return {};
    return out;
  }

  const SweepProblem& problem_;
  std::vector<std::vector<std::vector<int>>> lines_;  ///< by face
  std::vector<char> is_rim_;
};

}  // namespace

std::vector<Division> walled_divisions(const Network& network, Context& context) {
  const std::vector<int> side = Walls(network.problem).sides();
  if (side.empty()) return {};
  Choices start = open_choices(network);
  std::vector<int> touched;
  for (const int f : all_faces(network))
    set_role(network, start, f,
             side[f] == 0   ? kLinkingStates
             : side[f] == 1 ? kSourceStates
                            : kTargetStates,
             touched);
  SearchOptions options;
  options.max_effort /= 10;
  return search_states(network, start, options, context).divisions;
}

}  // namespace sweepmesh
