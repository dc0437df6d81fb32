#include "sweepmesh/surface/quad_templates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace sweepmesh {
namespace {

/// Four sides of a loop: side lengths in edges are a, b, a, b from node `start`.
struct Sides {
  int start = 0, a = 0, b = 0;
  double cost = std::numeric_limits<double>::infinity();
};

const Point2& at(const std::vector<Point2>& loop, int i) {
  const int n = static_cast<int>(loop.size());
  return loop[((i % n) + n) % n];
}

double turn(const std::vector<Point2>& loop, int i) {
  const Point2 in = at(loop, i) - at(loop, i - 1), out = at(loop, i + 1) - at(loop, i);
  return std::atan2(cross2(in, out), in.dot(out));
}

template <class Cost>
Sides best_sides(int n, const Cost& cost) {
  Sides best;
  for (int a = 1; a < n / 2; ++a)
    for (int start = 0; start < n / 2; ++start) {
      const Sides trial{start, a, n / 2 - a};
      const double c = cost(trial);
      if (c < best.cost) best = {trial.start, trial.a, trial.b, c};
    }
  return best;
}

std::array<int, 4> corners(const Sides& s) {
  return {s.start, s.start + s.a, s.start + s.a + s.b, s.start + 2 * s.a + s.b};
}

/// Four corners that turn by about a right angle, everything else straight.
std::optional<Sides> logical_corners(const std::vector<Point2>& loop) {
  constexpr double least_turn = std::numbers::pi / 6.0;
  const int n = static_cast<int>(loop.size());
  std::vector<double> turns(n);
  for (int i = 0; i < n; ++i) turns[i] = turn(loop, i);
  const Sides best = best_sides(n, [&](const Sides& s) {
    double cost = 0.0;
    for (const int c : corners(s)) {
      const double off = turns[c % n] - std::numbers::pi / 2.0;
      cost += off * off;
    }
    return cost;
  });
  for (const int c : corners(best))
    if (turns[c % n] < least_turn) return std::nullopt;
  return best;
}

/// No corner: a sharp one would be cut in two by the O-grid's rings.
bool is_smooth(const std::vector<Point2>& loop) {
  constexpr double sharpest = 55.0 / 180.0 * std::numbers::pi;
  constexpr int least_count = 8;
  const int n = static_cast<int>(loop.size());
  if (n < least_count) return false;
  for (int i = 0; i < n; ++i)
    if (turn(loop, i) > sharpest) return false;
  return true;
}

/// Four points of a smooth loop that make a rectangle whose sides are as long as their counts.
Sides inscribed_rectangle(const std::vector<Point2>& loop) {
  const int n = static_cast<int>(loop.size());
  return best_sides(n, [&](const Sides& s) {
    const auto c = corners(s);
    std::array<Point2, 4> side;
    for (int i = 0; i < 4; ++i) side[i] = at(loop, c[(i + 1) % 4]) - at(loop, c[i]);
    double cost = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double angle =
          std::atan2(cross2(side[i], side[(i + 1) % 4]), side[i].dot(side[(i + 1) % 4]));
      cost += std::pow(angle - std::numbers::pi / 2.0, 2);
    }
    const double along = (side[0].norm() + side[2].norm()) / s.a;
    const double across = (side[1].norm() + side[3].norm()) / s.b;
    return cost + std::pow(std::log(along / across), 2);
  });
}

/// A grid of nodes (i, j), 0 <= i <= a, 0 <= j <= b, whose rim is a closed row of a + b + a + b
/// nodes.
struct Grid {
  int a, b;
  std::vector<int> node;
  Grid(int a_, int b_) : a(a_), b(b_), node((a_ + 1) * (b_ + 1), -1) {}
  int& operator()(int i, int j) { return node[j * (a + 1) + i]; }
  int& rim(int r) {
    if (r <= a) return (*this)(r, 0);
    if (r <= a + b) return (*this)(a, r - a);
    if (r <= 2 * a + b) return (*this)(2 * a + b - r, b);
    return (*this)(0, 2 * a + 2 * b - r);
  }
};

/// Inside nodes of a grid from its rim by transfinite interpolation (Gordon and Hall), and its
/// quads.
void fill(Grid& grid, PlanarMesh& mesh) {
  const int a = grid.a, b = grid.b;
  const auto p = [&](int i, int j) -> Point2 { return mesh.points[grid(i, j)]; };
  for (int j = 1; j < b; ++j)
    for (int i = 1; i < a; ++i) {
      const double x = static_cast<double>(i) / a, y = static_cast<double>(j) / b;
      const Point2 q = (1 - x) * p(0, j) + x * p(a, j) + (1 - y) * p(i, 0) + y * p(i, b) -
                       (1 - x) * (1 - y) * p(0, 0) - x * (1 - y) * p(a, 0) - x * y * p(a, b) -
                       (1 - x) * y * p(0, b);
      grid(i, j) = mesh.n_nodes();
      mesh.points.push_back(q);
    }
  for (int j = 0; j < b; ++j)
    for (int i = 0; i < a; ++i) {
      const std::array<int, 4> quad = {grid(i, j), grid(i + 1, j), grid(i + 1, j + 1),
                                       grid(i, j + 1)};
      mesh.add_cell(quad);
    }
}

/// Rings of quads between two closed rows of nodes, both counterclockwise, `outer` outside.
void add_rings(const std::vector<int>& outer, const std::vector<int>& inner, int n_rings,
               PlanarMesh& mesh) {
  const int n = static_cast<int>(outer.size());
  std::vector<int> row = outer;
  for (int r = 1; r <= n_rings; ++r) {
    std::vector<int> next = inner;
    const double share = static_cast<double>(r) / n_rings;
    for (int i = 0; i < n && r < n_rings; ++i) {
      next[i] = mesh.n_nodes();
      mesh.points.push_back((1 - share) * mesh.points[outer[i]] + share * mesh.points[inner[i]]);
    }
    for (int i = 0; i < n; ++i) {
      const std::array<int, 4> quad = {row[i], row[(i + 1) % n], next[(i + 1) % n], next[i]};
      mesh.add_cell(quad);
    }
    row = next;
  }
}

PlanarMesh with_boundary(const PlanarLoops& loops) {
  PlanarMesh mesh;
  mesh.points = flattened(loops);
  mesh.n_boundary = mesh.n_nodes();
  return mesh;
}

PlanarMesh mapped(const PlanarLoops& loops, const Sides& sides) {
  PlanarMesh mesh = with_boundary(loops);
  const int n = mesh.n_boundary;
  Grid grid(sides.a, sides.b);
  for (int r = 0; r < n; ++r) grid.rim(r) = (sides.start + r) % n;
  fill(grid, mesh);
  return mesh;
}

/// The rim of the core lies between a rectangle on the four points and the loop itself, drawn in.
PlanarMesh o_grid(const PlanarLoops& loops, const Sides& sides) {
  constexpr double core_scale = 0.62, roundness = 0.35, ring_share = 0.26;
  PlanarMesh mesh = with_boundary(loops);
  const auto& loop = loops[0];
  const int n = mesh.n_boundary;
  Point2 centre = Point2::Zero();
  for (const Point2& p : loop) centre += p / n;
  Grid core(sides.a, sides.b);
  std::vector<int> outer(n), inner(n);
  const auto c = corners(sides);
  for (int side = 0; side < 4; ++side) {
    const int from = c[side], to = side < 3 ? c[side + 1] : c[0] + n;
    for (int i = from; i < to; ++i) {
      const double share = static_cast<double>(i - from) / (to - from);
      const Point2 chord = (1 - share) * at(loop, from) + share * at(loop, to);
      const Point2 p = roundness * at(loop, i) + (1 - roundness) * chord;
      const int r = i - sides.start;
      outer[r] = i % n;
      core.rim(r) = inner[r] = mesh.n_nodes();
      mesh.points.push_back(centre + core_scale * (p - centre));
    }
  }
  add_rings(outer, inner,
            std::max(1, static_cast<int>(std::lround(ring_share * std::min(sides.a, sides.b)))),
            mesh);
  fill(core, mesh);
  return mesh;
}

/// Nodes of the hole (turned counterclockwise) so that spokes to the outer loop are shortest.
std::vector<int> aligned_hole(const PlanarLoops& loops) {
  const int n = static_cast<int>(loops[0].size());
  int best_shift = 0;
  double best = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < n; ++shift) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += (loops[0][i] - at(loops[1], shift - i)).squaredNorm();
    if (sum < best) best = sum, best_shift = shift;
  }
  std::vector<int> hole(n);
  for (int i = 0; i < n; ++i) hole[i] = n + ((best_shift - i) % n + n) % n;
  return hole;
}

PlanarMesh ring(const PlanarLoops& loops, double size) {
  PlanarMesh mesh = with_boundary(loops);
  const int n = static_cast<int>(loops[0].size());
  const std::vector<int> inner = aligned_hole(loops);
  std::vector<int> outer(n);
  double gap = 0.0;
  for (int i = 0; i < n; ++i) {
    outer[i] = i;
    gap += (mesh.points[i] - mesh.points[inner[i]]).norm() / n;
  }
  add_rings(outer, inner, std::max(1, static_cast<int>(std::lround(gap / size))), mesh);
  return mesh;
}

}  // namespace

std::vector<PlanarMesh> structured_candidates(const PlanarLoops& loops, double size) {
  std::vector<PlanarMesh> out;
  if (loops.size() == 2 && loops[0].size() == loops[1].size()) out.push_back(ring(loops, size));
  if (loops.size() != 1 || loops[0].size() % 2 != 0 || loops[0].size() < 4) return out;
  if (const auto sides = logical_corners(loops[0])) out.push_back(mapped(loops, *sides));
  if (is_smooth(loops[0])) out.push_back(o_grid(loops, inscribed_rectangle(loops[0])));
  return out;
}

}  // namespace sweepmesh
