// The cheapest directions around one loop: a shortest path whose state is the turning so far.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "sweepmesh/scheme/limits.h"

namespace sweepmesh {

/// One loop of a linking face. Entry c is coedge c and the corner where it ends.
struct LoopProgram {
  /// Cost of each direction (index: static_cast<int>(Direction)) of a coedge; infinite: not
  /// possible.
  std::vector<std::array<double, 4>> direction_cost;
  /// Cost of the types END, SIDE, CORNER, REVERSAL (in that order) of a corner; infinite: not
  /// allowed.
  std::vector<std::array<double, 4>> type_cost;
  /// What the types must add up to: 4 for an outer loop, -4 for a hole, 0 around an annulus.
  int sum = 4;
  /// Paths that cost more are not looked at: their marginals may be infinite instead.
  double limit = std::numeric_limits<double>::infinity();
};

/// `marginal[c][d]`: least cost of the loop when coedge c has direction d; infinite where it
/// cannot.
struct LoopMarginals {
  double best = 0.0;
  long work = 0;  ///< steps of the path that were looked at
  std::vector<std::array<double, 4>> marginal;
};

/// Exact. Cost: n times the range that the turning can take (a few values where the sum is tight),
/// which is never beyond 48 quarter turns either way: no face spirals that far. An empty loop
/// cannot be.
LoopMarginals loop_marginals(const LoopProgram& loop);

/// Type costs of a corner from its interior angle (limits.h); infinite for types outside the
/// limits.
std::array<double, 4> corner_costs(double angle, const AngleLimits& limits);

}  // namespace sweepmesh
