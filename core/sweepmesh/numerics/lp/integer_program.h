// Linear and mixed-integer programs, solved by lp_solve: the one place that knows lp_solve.
//
//   minimise  sum_j objective_j x_j   subject to   lower_j <= x_j <= upper_j,
//             sum_j a_rj x_j  (<=, =, >=)  right_r,   x_j integer where it is marked so.
//
// The solver prints nothing and gives the same answer for the same program on every run and every
// machine, unless a limit of time cuts it short; the limit of effort does not depend on the clock.
// Reference: lp_solve 5.5 (Berkelaar, Eikland, Notebaert), branch and bound over the simplex
// method.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sweepmesh/base/context.h"

namespace sweepmesh {

constexpr double unbounded = std::numeric_limits<double>::infinity();

enum class Sense { less_equal, equal, greater_equal };

struct IntegerProgram {
  struct Variable {
    double lower = 0.0;  ///< -unbounded for none
    double upper = unbounded;
    bool is_integer = false;
    double objective = 0.0;
    std::string name;  ///< for messages only
  };
  struct Term {
    int variable;
    double coefficient;
  };
  struct Row {
    std::vector<Term> terms;  ///< a variable may occur more than once: the coefficients add up
    Sense sense = Sense::equal;
    double right = 0.0;
    std::string name;  ///< for messages only
  };

  std::vector<Variable> variables;
  std::vector<Row> rows;

  /// Each returns the index of what it adds.
  int add_variable(Variable v) {
    variables.push_back(std::move(v));
    return static_cast<int>(variables.size()) - 1;
  }
  int add_row(Row r) {
    rows.push_back(std::move(r));
    return static_cast<int>(rows.size()) - 1;
  }
};

struct SolveOptions {
  /// Work after which the best solution found by then is returned, > 0: iterations of the simplex
  /// method times the rows and columns of the program. A second of a machine of 2023 does about
  /// 2e7.
  double max_effort = 5e8;
  double time_limit_seconds = unbounded;  ///< > 0; the same for time
  /// Branch and bound ends when no better solution than by this absolute amount is left, >= 0.
  double gap = 1e-9;
  /// Look for any feasible integer solution and stop at the first.
  bool first_feasible = false;
};

enum class SolveStatus { optimal, feasible_at_limit, infeasible };

struct Solution {
  SolveStatus status = SolveStatus::infeasible;
  std::vector<double> values;  ///< of the variables (integers exactly so); empty where infeasible
  double objective = 0.0;
  double effort = 0.0;  ///< that it took, see SolveOptions
};

/// Throws InputError for a malformed program (index out of range, crossed bounds, not a number),
/// SolverError where the program is unbounded, where lp_solve fails numerically in every setting
/// tried or finds no solution within the limits, and Cancelled. With `first_feasible` the
/// status is `optimal` only where the program's objective is zero; otherwise `feasible_at_limit`.
Solution solve(const IntegerProgram& program, const SolveOptions& options, Context& context);

}  // namespace sweepmesh
