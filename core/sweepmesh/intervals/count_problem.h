// Whole numbers that meet linear demands and stay close to wished values: the interval problem
// without its geometry.
//
//   find whole x_j in [lower_j, upper_j] with  sum a_rj x_j (<=, =, >=) b_r  and, for parity
//   demands, sum a_rj x_j even, that minimise  sum_j weight_j (x_j / wish_j + wish_j / x_j - 2) +
//   penalties.
//
// The cost of an unknown is the same for half as many as for twice as many; near its wish it is
// weight ((x - wish) / wish)^2. With weight = wish, what has to give is spread in proportion: each
// by the same part of itself. The cost is convex, and tabulated at whole numbers only: the linear
// relaxation then has whole corners wherever the demands are network-like.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/lattice.h"
#include "sweepmesh/numerics/lp/integer_program.h"

namespace sweepmesh {

struct CountProblem {
  struct Unknown {
    double lower = 1.0;  ///< -unbounded for a free number (a level, an offset)
    double upper = unbounded;
    std::optional<double> wish;  ///< > 0; empty: any value is as good as another
    double weight = 1.0;
  };
  enum class Kind { equality, at_most, at_least, even, preferably_even };
  struct Demand {
    Kind kind = Kind::equality;
    std::vector<IntegerProgram::Term> terms;  ///< whole coefficients
    double right = 0.0;                       ///< unused for the even kinds
    std::vector<std::string> entities;        ///< CAD names, for the message of a conflict
    std::string text;  ///< what is demanded, as "... must ..." without a period
  };

  std::vector<Unknown> unknowns;
  std::vector<Demand> demands;

  /// Wishes and weights are rounded to far more than lengths differ by where a solid is turned or
  /// scaled, and to far less than what counts.
  int add(Unknown u) {
    constexpr double step = 1.0 / (1 << 12);
    if (u.wish) u.wish = std::max(step, on_lattice(*u.wish, step));
    u.weight = on_lattice(u.weight, step);
    unknowns.push_back(u);
    return static_cast<int>(unknowns.size()) - 1;
  }
  void demand(Demand d) { demands.push_back(std::move(d)); }
};

struct CountOptions {
  /// Work for each independent part of the problem, as SolveOptions counts it, > 0.
  double max_effort = 1e8;
  double time_limit_seconds = unbounded;  ///< the same for time, > 0
  /// Cost of an odd sum where an even one is preferred, in the unit of the cost above.
  double odd_penalty = 0.5;
  bool any_will_do = false;  ///< the first counts found, not those of least cost
  bool explain = true;       ///< look for the smallest conflict where there is no solution
};

struct CountSolution {
  bool is_feasible = false;
  std::vector<long> values;  ///< empty where infeasible
  bool is_optimal = true;    ///< false: a limit was reached, the best so far is used
  double cost = 0.0;
  std::vector<int> conflict;  ///< infeasible: demands that contradict each other, as few as found
};

/// Solves by merging unknowns that must be equal, fixing those that only an even sum could move
/// (the cheapest of each kind is kept), splitting into independent parts and branch and bound on
/// what remains. An infeasible problem is answered by a smallest set of demands: dropping any one
/// of them would make that set feasible (QuickXplain, Junker 2004; a few dozen solver runs), as far
/// as the limits allow. Throws SolverError and Cancelled as `solve` does. Values beyond 1e9
/// are not represented.
CountSolution solve_counts(const CountProblem& problem, const CountOptions& options,
                           Context& context);

}  // namespace sweepmesh
