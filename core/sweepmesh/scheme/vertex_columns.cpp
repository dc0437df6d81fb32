#include "sweepmesh/scheme/vertex_columns.h"

#include <algorithm>
#include <vector>

namespace sweepmesh {
namespace {

constexpr int kUp = static_cast<int>(Direction::plus_k);
constexpr int kDown = static_cast<int>(Direction::minus_k);

/// A quad at a vertex, and whether the mesh edge after it leaves the vertex along k.
struct Quad {
  bool is_below = false;
  bool is_at_column = false;
};

bool is_axial_edge(int state) {
  return state == kUp || state == kDown;
}

/// The quads of the corner where coedge c ends, clockwise as seen from outside.
void add_quads(const Network& n, const Choices& choices, int c, std::vector<Quad>& ring) {
  const int in = first_state(choices.domain[c]);
  const int out = first_state(choices.domain[n.problem.next(c)]);
  if (in >= kSourceState) return ring.push_back({in == kSourceState, false});
  const int turn = (out - in + 4) % 4;  // END 1, SIDE 0, CORNER 3, REVERSAL 2
  const int n_quads = turn <= 1 ? 2 - turn : 6 - turn;
  for (int i = n_quads - 1; i >= 0; --i) {
    const int right = (out + i) % 4, left = (right + 1) % 4;  // what the quad lies between
    ring.push_back({right == kDown || left == kDown, is_axial_edge(right)});
  }
}

/// Whether two columns leave the quads of one side of the layer that follow each other.
bool is_torn(std::vector<Quad> ring) {
  const auto change = std::ranges::adjacent_find(
      ring, [](const Quad& a, const Quad& b) { return a.is_below != b.is_below; });
  if (change != ring.end()) std::ranges::rotate(ring, change + 1);
  int n_columns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0 && ring[i].is_below != ring[i - 1].is_below) n_columns = 0;
    n_columns += ring[i].is_at_column;
    if (n_columns > 1) return true;
  }
  return false;
}

}  // namespace

std::optional<int> torn_vertex(const Network& network, const Choices& choices) {
  const SweepProblem& problem = network.problem;
  std::vector<char> is_seen(problem.coedges.size(), 0);
  for (std::size_t first = 0; first < problem.coedges.size(); ++first) {
    if (is_seen[first]) continue;
    std::vector<Quad> ring;
    for (int c = static_cast<int>(first); !is_seen[c];) {
      is_seen[c] = 1;
      add_quads(network, choices, c, ring);
      c = problem.coedges[problem.next(c)].partner;
    }
    if (is_torn(std::move(ring))) return problem.coedges[first].end;
  }
  return {};
}

}  // namespace sweepmesh
