#include "sweepmesh/surface/quad_cleanup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <utility>

namespace sweepmesh {
namespace {

using Cell = std::vector<int>;
using Edge = std::pair<int, int>;

std::vector<Cell> cells_of(const PlanarMesh& mesh) {
  std::vector<Cell> out;
  for (int c = 0; c < mesh.n_cells(); ++c)
    out.emplace_back(mesh.cell(c).begin(), mesh.cell(c).end());
  return out;
}

/// The cell on the left of each directed edge.
std::map<Edge, int> left_cells(const std::vector<Cell>& cells) {
  std::map<Edge, int> out;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < cells[c].size(); ++i)
      out[{cells[c][i], cells[c][(i + 1) % cells[c].size()]}] = static_cast<int>(c);
  return out;
}

/// Cells from triangle `start` to the nearest other triangle, both included; empty where there is
/// none.
std::vector<int> path_to_triangle(const std::vector<Cell>& cells, const std::map<Edge, int>& left,
                                  int start) {
  std::vector<int> from(cells.size(), -1);
  std::deque<int> queue = {start};
  from[start] = start;
  while (!queue.empty()) {
    const int c = queue.front();
    queue.pop_front();
    if (c != start && cells[c].size() == 3) {
      std::vector<int> path = {c};
      while (path.back() != start) path.push_back(from[path.back()]);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (std::size_t i = 0; i < cells[c].size(); ++i) {
      const auto other = left.find({cells[c][(i + 1) % cells[c].size()], cells[c][i]});
      if (other == left.end() || from[other->second] >= 0) continue;
      from[other->second] = c;
      queue.push_back(other->second);
    }
  }
  return {};
}

/// The union of two cells that share one edge; empty where they share more.
Cell united(const Cell& a, const Cell& b) {
  const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      if (a[i] != b[(j + 1) % m] || a[(i + 1) % n] != b[j]) continue;
      Cell out;
      for (int s = 1; s <= n; ++s) out.push_back(a[(i + s) % n]);
      for (int s = 2; s < m; ++s) out.push_back(b[(j + s) % m]);
      Cell sorted = out;
      std::sort(sorted.begin(), sorted.end());
      return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() ? out : Cell{};
    }
  return {};
}

int shared_edge_start(const Cell& a, const Cell& b) {
  const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      if (a[i] == b[(j + 1) % m] && a[(i + 1) % n] == b[j]) return i;
  return -1;
}

/// Moves the triangle in slot `from` over the quad in slot `over`, to lie next to the cell in slot
/// `to`.
bool move_triangle(std::vector<Cell>& cells, const std::vector<Point2>& points, int from, int over,
                   int to) {
  const Cell five = united(cells[from], cells[over]);
  const int i = five.empty() ? -1 : shared_edge_start(five, cells[to]);
  if (i < 0) return false;
  const auto p = [&](int k) { return five[(i + k + 5) % 5]; };
  const std::array<Cell, 2> triangle = {Cell{p(0), p(1), p(2)}, Cell{p(-1), p(0), p(1)}};
  const std::array<Cell, 2> quad = {Cell{p(0), p(2), p(3), p(4)}, Cell{p(-1), p(1), p(2), p(3)}};
  std::array<double, 2> value;
  for (int s = 0; s < 2; ++s)
    value[s] = std::min(scaled_jacobian(points, triangle[s]), scaled_jacobian(points, quad[s]));
  const int s = value[1] > value[0] ? 1 : 0;
  cells[from] = quad[s];
  cells[over] = triangle[s];
  return true;
}

bool pair_along(std::vector<Cell>& cells, const std::vector<Point2>& points,
                const std::vector<int>& path) {
  for (std::size_t i = 0; i + 2 < path.size(); ++i)
    if (!move_triangle(cells, points, path[i], path[i + 1], path[i + 2])) return false;
  const Cell quad = united(cells[path[path.size() - 2]], cells[path.back()]);
  if (quad.empty()) return false;
  cells[path[path.size() - 2]] = quad;
  cells.erase(cells.begin() + path.back());
  return true;
}

PlanarMesh with_cells(const PlanarMesh& mesh, const std::vector<Cell>& cells) {
  PlanarMesh out;
  out.points = mesh.points;
  out.n_boundary = mesh.n_boundary;
  for (const Cell& c : cells) out.add_cell(c);
  return out;
}

/// Quads under change: which quads use a node, and what each node wishes.
class Editor {
 public:
  Editor(const PlanarMesh& mesh, const std::vector<std::vector<double>>& angles)
      : points_(mesh.points), n_boundary_(mesh.n_boundary), angles_(angles) {
    at_node_.resize(mesh.n_nodes());
    for (int c = 0; c < mesh.n_cells(); ++c) {
      std::array<int, 4> q;
      std::copy_n(mesh.cell(c).begin(), 4, q.begin());
      add(q);
    }
  }

  void run() {
    constexpr int max_passes = 30;
    for (int pass = 0; pass < max_passes; ++pass)
      if (!one_pass()) return;
  }

  PlanarMesh result() const {
    PlanarMesh out;
    std::vector<int> number(points_.size(), -1);
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      if (i >= n_boundary_ && at_node_[i].empty()) continue;
      number[i] = out.n_nodes();
      out.points.push_back(points_[i]);
    }
    out.n_boundary = n_boundary_;
    for (const auto& q : quads_) {
      if (q[0] < 0) continue;
      const std::array<int, 4> cell = {number[q[0]], number[q[1]], number[q[2]], number[q[3]]};
      out.add_cell(cell);
    }
    return out;
  }

 private:
  using Quad = std::array<int, 4>;

  void add(const Quad& q) {
    for (const int node : q) at_node_[node].push_back(static_cast<int>(quads_.size()));
    quads_.push_back(q);
  }
  void remove(int quad) {
    for (const int node : quads_[quad]) std::erase(at_node_[node], quad);
    quads_[quad] = {-1, -1, -1, -1};
  }

  int valence(int node) const { return static_cast<int>(at_node_[node].size()); }
  /// How far `n` quads at a node are from its wish; the boundary cannot give way, so it counts
  /// more, and most of all where a quad would have to open its corner almost flat.
  double cost(int node, int n) const {
    constexpr double boundary_weight = 3.0, flat_weight = 50.0, flat = 1.75;
    if (node >= n_boundary_) return (n - 4.0) * (n - 4.0);
    double most = 0.0;
    for (const auto& shape : angles_) {
      const double wish = shape[node] / (0.5 * std::numbers::pi);
      const double open = std::max(0.0, wish / n - flat);
      most = std::max(most, boundary_weight * (n - wish) * (n - wish) + flat_weight * open);
    }
    return most;
  }
  /// Change of the cost when `node` gets `change` more quads.
  double gain(int node, int change) const {
    return cost(node, valence(node) + change) - cost(node, valence(node));
  }
  /// A boundary node needs one quad, an inside node three.
  bool may_lose(int node) const { return valence(node) > (node < n_boundary_ ? 1 : 3); }

  bool one_pass() {
    bool has_changed = false;
    for (int q = 0; q < static_cast<int>(quads_.size()); ++q) {
      if (quads_[q][0] >= 0 && remove_doublet(q)) has_changed = true;
      if (quads_[q][0] >= 0 && collapse(q)) has_changed = true;
      if (quads_[q][0] >= 0 && rotate(q)) has_changed = true;
    }
    return has_changed;
  }

  bool remove_doublet(int q) {
    for (int i = 0; i < 4; ++i) {
      const int node = quads_[q][i];
      if (node < n_boundary_ || valence(node) != 2) continue;
      const int other = at_node_[node][0] == q ? at_node_[node][1] : at_node_[node][0];
      const int far = opposite(other, node);
      if (far == quads_[q][(i + 2) % 4]) continue;
      Quad merged = quads_[q];
      merged[i] = far;
      remove(q);
      remove(other);
      add(merged);
      return true;
    }
    return false;
  }

  int opposite(int quad, int node) const {
    for (int i = 0; i < 4; ++i)
      if (quads_[quad][i] == node) return quads_[quad][(i + 2) % 4];
    return -1;
  }

  bool collapse(int q) {
    const Quad quad = quads_[q];
    for (int i = 0; i < 2; ++i) {
      int kept = quad[i], gone = quad[i + 2];
      if (gone < n_boundary_) std::swap(kept, gone);
      if (gone < n_boundary_ || !is_collapse_good(quad, i, kept, gone)) continue;
      if (kept >= n_boundary_) points_[kept] = 0.5 * (points_[kept] + points_[gone]);
      remove(q);
      const std::vector<int> touched = at_node_[gone];
      for (const int other : touched) {
        Quad changed = quads_[other];
        std::replace(changed.begin(), changed.end(), gone, kept);
        remove(other);
        add(changed);
      }
      return true;
    }
    return false;
  }

  bool is_collapse_good(const Quad& quad, int i, int kept, int gone) const {
    const int left = quad[(i + 1) % 4], right = quad[(i + 3) % 4];
    if (!may_lose(left) || !may_lose(right)) return false;
    for (const int other : at_node_[gone])
      for (const int node : quads_[other])
        if (node == kept && quads_[other] != quad) return false;
    const double change = gain(kept, valence(gone) - 2) - cost(gone, valence(gone)) +
                          gain(left, -1) + gain(right, -1);
    return change < least_gain;
  }

  bool rotate(int q) {
    for (int i = 0; i < 4; ++i) {
      const int a = quads_[q][i], b = quads_[q][(i + 1) % 4];
      const int other = quad_across(q, a, b);
      if (other < q || !may_lose(a) || !may_lose(b)) continue;
      const Cell six = united(Cell(quads_[q].begin(), quads_[q].end()),
                              Cell(quads_[other].begin(), quads_[other].end()));
      if (six.size() == 6 && rotate_in(q, other, six, a)) return true;
    }
    return false;
  }

  int quad_across(int q, int a, int b) const {
    for (const int other : at_node_[a]) {
      if (other == q) continue;
      for (int j = 0; j < 4; ++j)
        if (quads_[other][j] == b && quads_[other][(j + 1) % 4] == a) return other;
    }
    return -1;
  }

  bool rotate_in(int q, int other, const Cell& six, int a) {
    const int at = static_cast<int>(std::find(six.begin(), six.end(), a) - six.begin());
    const auto p = [&](int k) { return six[(at + k + 6) % 6]; };
    const double lost = gain(p(0), -1) + gain(p(3), -1);
    const double forward = gain(p(1), 1) + gain(p(4), 1), backward = gain(p(-1), 1) + gain(p(2), 1);
    if (lost + std::min(forward, backward) >= least_gain) return false;
    const int s = forward <= backward ? 1 : 2;
    remove(q);
    remove(other);
    add({p(s), p(s + 1), p(s + 2), p(s + 3)});
    add({p(s + 3), p(s + 4), p(s + 5), p(s)});
    return true;
  }

  static constexpr double least_gain = -0.5;

  std::vector<Point2> points_;
  int n_boundary_;
  std::vector<Quad> quads_;
  std::vector<std::vector<int>> at_node_;
  const std::vector<std::vector<double>>& angles_;
};

}  // namespace

std::optional<PlanarMesh> with_triangles_paired(const PlanarMesh& mesh) {
  std::vector<Cell> cells = cells_of(mesh);
  for (;;) {
    const auto triangle =
        std::find_if(cells.begin(), cells.end(), [](const Cell& c) { return c.size() == 3; });
    if (triangle == cells.end()) return with_cells(mesh, cells);
    const auto path =
        path_to_triangle(cells, left_cells(cells), static_cast<int>(triangle - cells.begin()));
    if (path.empty() || !pair_along(cells, mesh.points, path)) return std::nullopt;
  }
}

PlanarMesh with_regular_valences(const PlanarMesh& mesh,
                                 const std::vector<std::vector<double>>& angles) {
  Editor editor(mesh, angles);
  editor.run();
  return editor.result();
}

}  // namespace sweepmesh
