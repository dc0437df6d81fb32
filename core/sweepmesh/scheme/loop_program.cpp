#include "sweepmesh/scheme/loop_program.h"

#include <algorithm>
#include <limits>

namespace sweepmesh {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr int kMaxTurning = 48;
constexpr std::array kTypes = {VertexType::end, VertexType::side, VertexType::corner,
                               VertexType::reversal};

int direction_after(int first, int turning) {
  return ((first + turning) % 4 + 4) % 4;
}

/// Costs by (coedge, turning since coedge 0), for one direction of coedge 0. Only turnings are kept
/// from which the sum can still be met: few where the sum is tight, so the table is as narrow.
class TurningTable {
 public:
  TurningTable(int n, int sum) : n_(n), sum_(sum) {
    for (int c = 0; c <= n; ++c) width_ = std::max(width_, highest(c) - lowest(c) + 1);
    cost_.resize((n + 1) * width_);
    clear();
  }
  void clear() { std::ranges::fill(cost_, kInf); }
  int lowest(int c) const { return std::max({-2 * c, sum_ - (n_ - c), -kMaxTurning}); }
  int highest(int c) const { return std::min({c, sum_ + 2 * (n_ - c), kMaxTurning}); }
  bool has(int c, int turning) const { return turning >= lowest(c) && turning <= highest(c); }
  double& at(int c, int turning) { return cost_[c * width_ + turning - lowest(c)]; }

 private:
  int n_, sum_, width_ = 0;
  std::vector<double> cost_;
};

/// A range of turnings, empty at first.
struct Reach {
  int low = 1, high = 0;
  void add(int turning) {
    const bool is_empty = low > high;
    low = is_empty ? turning : std::min(low, turning);
    high = is_empty ? turning : std::max(high, turning);
  }
};

class LoopSolver {
 public:
  explicit LoopSolver(const LoopProgram& loop)
      : loop_(loop),
        n_(static_cast<int>(loop.type_cost.size())),
        ahead_(n_, loop.sum),
        behind_(n_, loop.sum) {
    out_.best = kInf;
    out_.marginal.assign(n_, {kInf, kInf, kInf, kInf});
  }

  LoopMarginals solve() {
    if (!ahead_.has(0, 0) || !ahead_.has(n_, loop_.sum)) return std::move(out_);
    for (int first = 0; first < 4; ++first)
      if (loop_.direction_cost[0][first] <= loop_.limit) solve_from(first);
    return std::move(out_);
  }

 private:
  /// Cost of arriving at coedge `c` (coedge n is coedge 0 again, at no further cost).
  double arrival(int first, int c, int turning) const {
    if (c == n_) return 0.0;
    return loop_.direction_cost[c][direction_after(first, turning)];
  }

  void solve_from(int first) {
    ahead_.clear();
    behind_.clear();
    reach_.assign(n_ + 1, {});
    ahead_.at(0, 0) = arrival(first, 0, 0);
    behind_.at(n_, loop_.sum) = 0.0;
    reach_[0].add(0);
    for (int c = 0; c < n_; ++c) sweep_forward(first, c);
    for (int c = n_ - 1; c >= 0; --c) sweep_backward(first, c);
    for (int c = 0; c < n_; ++c)
      for (int h = reach_[c].low; h <= reach_[c].high; ++h) {
        double& best = out_.marginal[c][direction_after(first, h)];
        best = std::min(best, ahead_.at(c, h) + behind_.at(c, h));
        out_.best = std::min(out_.best, best);
      }
  }

  void sweep_forward(int first, int c) {
    for (int h = reach_[c].low; h <= reach_[c].high; ++h) {
      const double here = ahead_.at(c, h);
      if (here == kInf) continue;
      out_.work += 4;
      for (int t = 0; t < 4; ++t) {
        const int next = h + static_cast<int>(kTypes[t]);
        if (!ahead_.has(c + 1, next)) continue;
        const double cost = here + loop_.type_cost[c][t] + arrival(first, c + 1, next);
        if (!(cost <= loop_.limit && cost < kInf)) continue;
        double& there = ahead_.at(c + 1, next);
        there = std::min(there, cost);
        reach_[c + 1].add(next);
      }
    }
  }

  /// behind(c, h): cost of everything after coedge c, its own corner included.
  void sweep_backward(int first, int c) {
    for (int h = reach_[c].low; h <= reach_[c].high; ++h) {
      if (ahead_.at(c, h) == kInf) continue;
      double& here = behind_.at(c, h);
      for (int t = 0; t < 4; ++t) {
        const int next = h + static_cast<int>(kTypes[t]);
        if (!ahead_.has(c + 1, next)) continue;
        const double cost =
            behind_.at(c + 1, next) + loop_.type_cost[c][t] + arrival(first, c + 1, next);
        here = std::min(here, cost);
      }
    }
  }

  const LoopProgram& loop_;
  int n_;
  TurningTable ahead_, behind_;
  std::vector<Reach> reach_;  ///< by coedge: turnings with a path from coedge 0 below the limit
  LoopMarginals out_;
};

}  // namespace

LoopMarginals loop_marginals(const LoopProgram& loop) {
  if (loop.type_cost.empty()) return {kInf, 0, {}};
  return LoopSolver(loop).solve();
}

std::array<double, 4> corner_costs(double angle, const AngleLimits& limits) {
  std::array<double, 4> out;
  for (int t = 0; t < 4; ++t)
    out[t] = is_vertex_allowed(angle, kTypes[t], limits) ? angle_cost(angle, kTypes[t]) : kInf;
  return out;
}

}  // namespace sweepmesh
