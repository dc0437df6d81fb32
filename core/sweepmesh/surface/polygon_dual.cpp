#include "sweepmesh/surface/polygon_dual.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "sweepmesh/surface/plane_graph.h"

namespace sweepmesh {
namespace {

/// The triangles around a boundary node and the directions of their sides.
struct Fan {
  std::vector<int> triangles;   ///< counterclockwise, from the edge to the next boundary node
  std::vector<double> turning;  ///< per triangle: the angle from that edge to its far side
};

class DualMaker {
 public:
  DualMaker(const PlanarMesh& triangles, const std::vector<int>& wished)
      : mesh_(triangles),
        wished_(wished),
        next_(triangles.n_boundary, -1),
        slots_(6 * triangles.n_cells(), -1),
        points_(triangles.points.begin(), triangles.points.begin() + triangles.n_boundary) {
    for (int t = 0; t < mesh_.n_cells(); ++t)
      points_.push_back(
          (mesh_.points[corner(t, 0)] + mesh_.points[corner(t, 1)] + mesh_.points[corner(t, 2)]) /
          3.0);
    for (int t = 0; t < mesh_.n_cells(); ++t)
      for (int i = 0; i < 3; ++i) triangle_at_[{corner(t, i), corner(t, i + 1)}] = t;
    for (const auto& [edge, t] : triangle_at_)
      if (!triangle_at_.contains({edge.second, edge.first})) next_[edge.first] = edge.second;
  }

  std::optional<PlanarMesh> run() {
    choose_links();
    PlaneGraph graph = make_graph();
    for (bool is_done = false; !is_done;) {
      graph.simplify();
      graph.clear_unreached(graph.reached_from(boundary_nodes()));
      graph.simplify();
      is_done = !remove_useless_edges(graph);
    }
    if (!is_connected(graph)) return std::nullopt;
    contract_triangles(graph);
    return cells_of(graph);
  }

 private:
  int corner(int t, int i) const { return mesh_.cell(t)[i % 3]; }
  int triangle_at(int from, int to) const {
    const auto at = triangle_at_.find({from, to});
    return at == triangle_at_.end() ? -1 : at->second;
  }
  int place_of(int node, int t) const {
    return static_cast<int>(std::ranges::find(mesh_.cell(t), node) - mesh_.cell(t).begin());
  }
  std::vector<int> boundary_nodes() const {
    std::vector<int> out(mesh_.n_boundary);
    std::iota(out.begin(), out.end(), 0);
    return out;
  }

  // --- links -------------------------------------------------------------------------------------

  Fan fan_of(int node) const {
    Fan fan;
    double turned = 0.0;
    for (int to = next_[node], t = triangle_at(node, to); t >= 0; t = triangle_at(node, to)) {
      const Point2 along = mesh_.points[to] - mesh_.points[node];
      to = corner(t, place_of(node, t) + 2);
      const Point2 back = mesh_.points[to] - mesh_.points[node];
      turned += std::atan2(cross2(along, back), along.dot(back));
      fan.triangles.push_back(t);
      fan.turning.push_back(turned);
    }
    return fan;
  }

  /// The triangles in the directions that divide the fan into n parts.
  static std::vector<int> middles(const Fan& fan, int n) {
    constexpr double noise = 1e-6;  // radians; a direction along a side is the side before's
    std::vector<int> out;
    for (int i = 1; i < n; ++i) {
      const double direction = fan.turning.back() * i / n - noise;
      const auto at = std::ranges::lower_bound(fan.turning, direction) - fan.turning.begin();
      const int t = fan.triangles[std::min<std::ptrdiff_t>(at, std::ssize(fan.triangles) - 1)];
      if (out.empty() || out.back() != t) out.push_back(t);
    }
    return out;
  }

  void choose_links() {
    links_.resize(mesh_.n_boundary);
    for (int n = 0; n < mesh_.n_boundary; ++n) links_[n] = middles(fan_of(n), wished_[n]);
    const std::vector<std::vector<int>> loops = loops_of_boundary();
    if (loops.size() > 1)
      for (const auto& loop : loops) hold(loop);
  }

  std::vector<std::vector<int>> loops_of_boundary() const {
    std::vector<std::vector<int>> out;
    std::vector<char> is_seen(mesh_.n_boundary, 0);
    for (int first = 0; first < mesh_.n_boundary; ++first) {
      if (is_seen[first]) continue;
      out.emplace_back();
      for (int n = first; !std::exchange(is_seen[n], 1); n = next_[n]) out.back().push_back(n);
    }
    return out;
  }

  /// Three links at least, the missing ones at the widest corners.
  void hold(const std::vector<int>& loop) {
    constexpr int enough = 3;
    auto n_linked = std::ranges::count_if(loop, [&](int n) { return !links_[n].empty(); });
    std::vector<std::pair<double, int>> others;
    for (const int n : loop)
      if (links_[n].empty()) others.emplace_back(-fan_of(n).turning.back(), n);
    std::ranges::sort(others);
    for (const auto& [angle, n] : others) {
      if (n_linked >= enough) return;
      links_[n] = middles(fan_of(n), 2);
      ++n_linked;
    }
  }

  // --- the graph ---------------------------------------------------------------------------------

  /// Around a centre links to the triangle's corners and edges through its sides take turns.
  int& slot_of_corner(int t, int i) { return slots_[6 * t + 2 * (i % 3)]; }
  int& slot_of_side(int t, int i) { return slots_[6 * t + 2 * (i % 3) + 1]; }
  int centre(int t) const { return mesh_.n_boundary + t; }

  PlaneGraph make_graph() {
    PlaneGraph graph(mesh_.n_boundary + mesh_.n_cells(), mesh_.n_boundary);
    std::vector<int> along(mesh_.n_boundary);
    for (int n = 0; n < mesh_.n_boundary; ++n) along[n] = graph.add_edge(n, next_[n]);
    for (int t = 0; t < mesh_.n_cells(); ++t)
      for (int i = 0; i < 3; ++i) add_edge_through(t, i, graph);
    for (int n = 0; n < mesh_.n_boundary; ++n) {
      graph.place(along[n]);
      for (const int t : links_[n]) {
        const int link = graph.add_edge(n, centre(t));
        graph.place(link);
        slot_of_corner(t, place_of(n, t)) = graph.twin(link);
      }
    }
    for (int n = 0; n < mesh_.n_boundary; ++n) graph.place(graph.twin(along[n]));
    for (const int dart : slots_)
      if (dart >= 0) graph.place(dart);
    return graph;
  }

  void add_edge_through(int t, int i, PlaneGraph& graph) {
    const int a = corner(t, i), b = corner(t, i + 1), other = triangle_at(b, a);
    if (other < t) return;  // none, or made from the other side
    slot_of_side(t, i) = graph.add_edge(centre(t), centre(other));
    slot_of_side(other, place_of(b, other)) = graph.twin(slot_of_side(t, i));
  }

  bool is_boundary(int dart) const { return dart < 2 * mesh_.n_boundary; }
  /// Of a boundary edge the dart that has the domain on its right.
  bool is_outer(int dart) const { return is_boundary(dart) && dart % 2 == 1; }

  /// The faces as rows of darts.
  std::vector<std::vector<int>> faces_of(const PlaneGraph& graph) const {
    std::vector<std::vector<int>> out;
    std::vector<char> is_seen(graph.n_darts(), 0);
    for (int first = 0; first < graph.n_darts(); ++first) {
      if (is_seen[first] || is_outer(first) || !graph.is_alive(first)) continue;
      out.emplace_back();
      for (int d = first; !std::exchange(is_seen[d], 1); d = graph.next(d)) out.back().push_back(d);
    }
    return out;
  }

  /// By dart: the face on its left, -1 outside.
  static std::vector<int> face_at_darts(const PlaneGraph& graph,
                                        const std::vector<std::vector<int>>& faces) {
    std::vector<int> out(graph.n_darts(), -1);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const int d : faces[f]) out[d] = static_cast<int>(f);
    return out;
  }

  /// Edges with the same face on both sides, and one of each two that bound a face by themselves.
  bool remove_useless_edges(PlaneGraph& graph) const {
    std::vector<int> useless;
    const auto faces = faces_of(graph);
    const std::vector<int> face = face_at_darts(graph, faces);
    for (const auto& darts : faces) {
      for (const int d : darts)
        if (face[d] == face[graph.twin(d)] && d < graph.twin(d)) useless.push_back(d);
      if (darts.size() == 2) useless.push_back(is_boundary(darts[0]) ? darts[1] : darts[0]);
    }
    for (const int d : useless)
      if (graph.is_alive(d)) graph.remove(d);
    return !useless.empty();
  }

  /// Cells of three corners inside become nodes, where the cells around are left four corners.
  void contract_triangles(PlaneGraph& graph) {
    constexpr std::size_t enough = 5;
    const auto faces = faces_of(graph);
    const std::vector<int> face = face_at_darts(graph, faces);
    std::vector<char> is_touched(faces.size(), 0);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto& darts = faces[f];
      const bool is_inside =
          std::ranges::all_of(darts, [&](int d) { return graph.origin(d) >= mesh_.n_boundary; });
      if (darts.size() != 3 || !is_inside || is_touched[f]) continue;
      const auto beyond = [&](int d) { return face[graph.twin(d)]; };
      if (!std::ranges::all_of(darts, [&](int d) {
            return !is_touched[beyond(d)] && faces[beyond(d)].size() >= enough;
          }))
        continue;
      for (const int d : darts) is_touched[beyond(d)] = 1;
      Point2 middle = Point2::Zero();
      for (const int d : darts) middle += points_[graph.origin(d)] / 3.0;
      points_[graph.origin(darts[0])] = middle;
      graph.contract(darts);
    }
  }

  bool is_connected(const PlaneGraph& graph) const {
    const auto is_reached = graph.reached_from({0});
    return std::all_of(is_reached.begin(), is_reached.begin() + mesh_.n_boundary,
                       [](char r) { return r; });
  }

  std::optional<PlanarMesh> cells_of(const PlaneGraph& graph) const {
    PlanarMesh out;
    out.n_boundary = mesh_.n_boundary;
    out.points.assign(points_.begin(), points_.begin() + mesh_.n_boundary);
    std::vector<int> number(graph.n_nodes(), -1);
    std::iota(number.begin(), number.begin() + mesh_.n_boundary, 0);
    for (int t = 0; t < mesh_.n_cells(); ++t) {
      if (graph.valence(centre(t)) == 0) continue;
      number[centre(t)] = out.n_nodes();
      out.points.push_back(points_[centre(t)]);
    }
    for (const auto& darts : faces_of(graph)) {
      std::vector<int> cell;
      for (const int d : darts) cell.push_back(number[graph.origin(d)]);
      std::vector<int> sorted = cell;
      std::ranges::sort(sorted);
      if (cell.size() < 3 || std::ranges::adjacent_find(sorted) != sorted.end())
        return std::nullopt;
      out.add_cell(cell);
    }
    return out;
  }

  const PlanarMesh& mesh_;
  const std::vector<int>& wished_;
  std::map<std::pair<int, int>, int> triangle_at_;  ///< by directed side
  std::vector<int> next_;                           ///< along the boundary
  std::vector<std::vector<int>> links_;             ///< by boundary node: triangles
  std::vector<int> slots_;
  std::vector<Point2> points_;  ///< of the boundary nodes, then of the centres
};

struct Cut {
  double worse_part = -1.0;
  int from = -1, to = -1;
};

/// Of the cuts from one corner the one that leaves the better parts.
Cut best_cut(const std::vector<Point2>& points, std::span<const int> cell, int from,
             const Metric& metric) {
  const int n = static_cast<int>(cell.size());
  Cut best;
  for (int i = 2; i + 1 < n; ++i) {
    const int to = (from + i) % n;
    double worse = 1.0;
    for (const auto& [a, b] : {std::pair(from, to), std::pair(to, from)}) {
      std::vector<int> part;
      for (int j = a; j != b; j = (j + 1) % n) part.push_back(cell[j]);
      part.push_back(cell[b]);
      worse = std::min(worse, scaled_jacobian(points, part, metric));
    }
    if (best.from < 0 || worse > best.worse_part) best = {worse, from, to};
  }
  return best;
}

/// The corner with the widest angle, as seen through the metric at the cell's centre.
int widest_corner(const std::vector<Point2>& points, std::span<const int> cell,
                  const Metric& metric) {
  const int n = static_cast<int>(cell.size());
  const Eigen::Matrix2d root = metric_at(metric, points, cell);
  std::vector<double> turn;
  for (int i = 0; i < n; ++i) {
    const Point2 in = root * (points[cell[i]] - points[cell[(i + n - 1) % n]]);
    const Point2 out = root * (points[cell[(i + 1) % n]] - points[cell[i]]);
    turn.push_back(std::atan2(cross2(in, out), in.dot(out)));
  }
  return static_cast<int>(std::ranges::min_element(turn) - turn.begin());
}

}  // namespace

std::vector<int> polygons_at_nodes(const std::vector<std::vector<double>>& angles) {
  constexpr double degree = std::numbers::pi / 180.0;
  constexpr double one = 130.0 * degree, two = 250.0 * degree;
  std::vector<int> out(angles.front().size(), 1);
  for (std::size_t n = 0; n < out.size(); ++n)
    for (const auto& row : angles)
      out[n] = std::max(out[n], 1 + (row[n] > one ? 1 : 0) + (row[n] > two ? 1 : 0));
  return out;
}

std::optional<PlanarMesh> polygon_dual(const PlanarMesh& triangles,
                                       const std::vector<int>& wished) {
  return DualMaker(triangles, wished).run();
}

PlanarMesh with_reflex_corners_cut(const PlanarMesh& mesh, const Metric& metric) {
  PlanarMesh out;
  out.points = mesh.points;
  out.n_boundary = mesh.n_boundary;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const int n = static_cast<int>(cell.size());
    if (n == 3 || scaled_jacobian(mesh.points, cell, metric) > 0.0) {
      out.add_cell(cell);
      continue;
    }
    const Cut cut = best_cut(mesh.points, cell, widest_corner(mesh.points, cell, metric), metric);
    for (const auto& [a, b] : {std::pair(cut.from, cut.to), std::pair(cut.to, cut.from)}) {
      std::vector<int> part;
      for (int j = a; j != b; j = (j + 1) % n) part.push_back(cell[j]);
      part.push_back(cell[b]);
      out.add_cell(part);
    }
  }
  return out;
}

}  // namespace sweepmesh
