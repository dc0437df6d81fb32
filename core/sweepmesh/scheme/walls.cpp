#include "sweepmesh/scheme/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sweepmesh/scheme/levels.h"

namespace sweepmesh {

namespace {

constexpr double kMaxAngle = 100.0 * std::numbers::pi / 180.0;
constexpr double kMinShellCosine = 0.5;  // 60 degrees
constexpr double kParallel = 0.866;      // 30 degrees
/// Length of the mean of unit tangents, one where the edge is straight.
constexpr double kStraight = 0.999;

/// +1 where coedge[0] of an edge runs up, -1 where down, 0 where the edge is not axial.
int rise(const Choices& choices, const ProblemEdge& edge) {
  const int state = first_state(choices.domain[edge.coedge[0]]);
  if (state == static_cast<int>(Direction::plus_k)) return 1;
  return state == static_cast<int>(Direction::minus_k) ? -1 : 0;
}

Point3 mean_tangent(const ProblemEdge& edge) {
  Point3 sum = Point3::Zero();
  for (const Point3& t : edge.tangents) sum += t;
  return sum / edge.tangents.size();
}

bool is_straight(const ProblemEdge& edge) {
  return mean_tangent(edge).norm() > kStraight;
}

/// The straight edges of a bundle, empty where two of them differ in direction.
std::vector<int> straight_edges(const Network& n, const Choices& choices,
                                const std::vector<int>& bundle) {
  std::vector<int> out;
  for (int e : bundle) {
    const ProblemEdge& edge = n.problem.edges[e];
    if (!is_straight(edge)) continue;
    out.push_back(e);
    const ProblemEdge& first = n.problem.edges[out.front()];
    const double cosine =
        rise(choices, edge) * rise(choices, first) * mean_tangent(edge).dot(mean_tangent(first));
    if (cosine < kParallel) return {};
  }
  return out;
}

/// The longest way between two of an edge's points against a direction of the edge's own way.
double way_back(const ProblemEdge& edge, const Point3& up) {
  double longest = 0.0, highest = edge.points.front().dot(up);
  for (const Point3& p : edge.points) {
    highest = std::max(highest, p.dot(up));
    longest = std::max(longest, highest - p.dot(up));
  }
  return longest;
}

/// The least distance of an edge from a line.
double gap_between(const ProblemEdge& edge, const Point3& on_line, const Point3& along) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point3& p : edge.points) least = std::min(least, along.cross(p - on_line).norm());
  return least;
}

OpposedWalls compare(const Network& n, const Choices& choices, int straight, int other) {
  const ProblemEdge &a = n.problem.edges[straight], &b = n.problem.edges[other];
  const Point3 up = mean_tangent(a).normalized() * rise(choices, a) * rise(choices, b);
  double least_cosine = 1.0;
  for (const Point3& t : b.tangents) least_cosine = std::min(least_cosine, t.dot(up));
  return {straight, other, std::acos(std::clamp(least_cosine, -1.0, 1.0)), way_back(b, up),
          gap_between(b, a.points.front(), up)};
}

bool runs_back(const OpposedWalls& walls) {
  return walls.angle > kMaxAngle && walls.way_back > kMostWayBack * walls.gap;
}

}  // namespace

std::optional<OpposedWalls> opposed_walls(const Network& network, const Choices& choices) {
  const auto levels = level_groups(network, choices);
  if (!levels) return {};
  const auto& edges = network.problem.edges;
  std::map<std::pair<int, int>, std::vector<int>> between;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int up = rise(choices, edges[e]);
    if (up == 0) continue;
    const ProblemCoedge& c = network.problem.coedges[edges[e].coedge[0]];
    const int a = levels->group[c.start], b = levels->group[c.end];
    between[std::minmax(a, b)].push_back(static_cast<int>(e));
  }
  OpposedWalls worst;
  for (const auto& [pair, bundle] : between)
    for (const int straight : straight_edges(network, choices, bundle))
      for (const int other : bundle) {
        const OpposedWalls walls = compare(network, choices, straight, other);
        if (runs_back(walls) && walls.angle > worst.angle) worst = walls;
      }
  if (worst.straight < 0) return {};
  return worst;
}

bool do_shells_agree(const Network& network, const Choices& choices) {
  std::map<int, Point3> axis;
  for (const ProblemEdge& edge : network.problem.edges) {
    const int up = rise(choices, edge);
    if (up == 0) continue;
    const int shell = network.problem.faces[network.problem.coedges[edge.coedge[0]].face].shell;
    axis.try_emplace(shell, Point3::Zero()).first->second += up * edge.chord;
  }
  for (const auto& [i, a] : axis)
    for (const auto& [j, b] : axis)
      if (a.dot(b) < kMinShellCosine * a.norm() * b.norm()) return false;
  return true;
}

}  // namespace sweepmesh
