#include "sweepmesh/scheme/states.h"

#include <bit>

namespace sweepmesh {

namespace {

constexpr int state(Direction d) {
  return static_cast<int>(d);
}

double edge_cost(const ProblemEdge& edge, Bend bend, VertexType type, const AngleLimits& limits) {
  if (!is_edge_allowed(edge.least, edge.largest, bend, type, limits)) return kImpossible;
  return angle_cost(edge.mean, type);
}

void set_both(PairCosts& costs, int a, int b, double cost) {
  costs[a][b] = cost;
  costs[b][a] = cost;
}

}  // namespace

int first_state(StateSet set) {
  return std::countr_zero(set);
}

PairCosts pair_costs(const ProblemEdge& edge, const AngleLimits& limits,
                     const Preferences& preferences) {
  const double side = edge_cost(edge, edge.bend, VertexType::side, limits);
  PairCosts costs;
  for (auto& row : costs) row.fill(kImpossible);
  set_both(costs, state(Direction::plus_i), state(Direction::minus_i), side);
  if (!edge.is_closed) set_both(costs, state(Direction::plus_k), state(Direction::minus_k), 0.0);
  for (std::size_t linking = 0; linking < 2; ++linking) {
    const Bend bend = limits.needs_facing_caps ? edge.face_bend[linking] : edge.bend;
    const double end = edge_cost(edge, bend, VertexType::end, limits);
    const double corner = edge_cost(edge, bend, VertexType::corner, limits);
    const auto set = [&](Direction d, int cap, double cost) {
      (linking == 0 ? costs[state(d)][cap] : costs[cap][state(d)]) = cost;
    };
    set(Direction::minus_i, kSourceState, end);
    set(Direction::plus_i, kSourceState, corner);
    set(Direction::plus_i, kTargetState, end);
    set(Direction::minus_i, kTargetState, corner);
  }
  const double seam = edge.is_seam ? preferences.per_cap_seam : 0.0;
  costs[kSourceState][kSourceState] = side + seam;
  costs[kTargetState][kTargetState] = side + seam;
  return costs;
}

std::vector<PairCosts> pair_costs(const SweepProblem& problem, const AngleLimits& limits,
                                  const Preferences& preferences) {
  std::vector<PairCosts> out;
  for (const ProblemEdge& edge : problem.edges)
    out.push_back(pair_costs(edge, limits, preferences));
  return out;
}

}  // namespace sweepmesh
