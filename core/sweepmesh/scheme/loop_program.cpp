#include "sweepmesh/scheme/loop_program.h"

#include <algorithm>
#include <limits>

namespace sweepmesh {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr int kMaxTurning = 48;
constexpr std::array kTypes = {VertexType::end, VertexType::side, VertexType::corner,
                               VertexType::reversal};

int direction_after(int first, int turning) { return ((first + turning) % 4 + 4) % 4; }

/// Costs by (coedge, turning since coedge 0), for one direction of coedge 0.
class TurningTable {
 public:
  TurningTable(int n, int reach) : reach_(reach), cost_((n + 1) * (2 * reach + 1), kInf) {}
  int reach() const { return reach_; }
  double& at(int c, int turning) { return cost_[c * (2 * reach_ + 1) + turning + reach_]; }

 private:
  int reach_;
  std::vector<double> cost_;
};

class LoopSolver {
 public:
  explicit LoopSolver(const LoopProgram& loop)
      : loop_(loop), n_(static_cast<int>(loop.type_cost.size())) {
    out_.best = kInf;
    out_.marginal.assign(n_, {kInf, kInf, kInf, kInf});
  }

  LoopMarginals solve() {
    const int reach = std::min(2 * n_ + 4, kMaxTurning);
    for (int first = 0; first < 4; ++first)
      if (loop_.direction_cost[0][first] < kInf) solve_from(first, reach);
    return out_;
  }

 private:
  /// Cost of arriving at coedge `c` (coedge n is coedge 0 again, at no further cost).
  double arrival(int first, int c, int turning) const {
    if (c == n_) return 0.0;
    return loop_.direction_cost[c][direction_after(first, turning)];
  }

  void solve_from(int first, int reach) {
    TurningTable ahead(n_, reach), behind(n_, reach);
    ahead.at(0, 0) = arrival(first, 0, 0);
    behind.at(n_, loop_.sum) = 0.0;
    for (int c = 0; c < n_; ++c) sweep_forward(first, c, ahead);
    for (int c = n_ - 1; c >= 0; --c) sweep_backward(first, c, behind);
    for (int c = 0; c < n_; ++c)
      for (int h = -reach; h <= reach; ++h) {
        double& best = out_.marginal[c][direction_after(first, h)];
        best = std::min(best, ahead.at(c, h) + behind.at(c, h));
        out_.best = std::min(out_.best, best);
      }
  }

  void sweep_forward(int first, int c, TurningTable& ahead) {
    for (int h = -ahead.reach(); h <= ahead.reach(); ++h) {
      if (ahead.at(c, h) == kInf) continue;
      for (int t = 0; t < 4; ++t) {
        const int next = h + static_cast<int>(kTypes[t]);
        if (std::abs(next) > ahead.reach()) continue;
        const double cost = ahead.at(c, h) + loop_.type_cost[c][t] + arrival(first, c + 1, next);
        ahead.at(c + 1, next) = std::min(ahead.at(c + 1, next), cost);
      }
    }
  }

  /// behind(c, h): cost of everything after coedge c, its own corner included.
  void sweep_backward(int first, int c, TurningTable& behind) {
    for (int h = -behind.reach(); h <= behind.reach(); ++h)
      for (int t = 0; t < 4; ++t) {
        const int next = h + static_cast<int>(kTypes[t]);
        if (std::abs(next) > behind.reach()) continue;
        const double cost =
            behind.at(c + 1, next) + loop_.type_cost[c][t] + arrival(first, c + 1, next);
        behind.at(c, h) = std::min(behind.at(c, h), cost);
      }
  }

  const LoopProgram& loop_;
  int n_;
  LoopMarginals out_;
};

}  // namespace

LoopMarginals loop_marginals(const LoopProgram& loop) {
  if (loop.type_cost.empty()) return {kInf, {}};
  return LoopSolver(loop).solve();
}

std::array<double, 4> corner_costs(double angle, const AngleLimits& limits) {
  std::array<double, 4> out;
  for (int t = 0; t < 4; ++t)
    out[t] = is_vertex_allowed(angle, kTypes[t], limits) ? angle_cost(angle, kTypes[t]) : kInf;
  return out;
}

}  // namespace sweepmesh
