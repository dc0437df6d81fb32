#include "sweepmesh/numerics/lp/integer_program.h"

#include <lpsolve/lp_lib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

namespace sweepmesh {
namespace {

const char* const stage = "solve";

using Clock = std::chrono::steady_clock;

/// What ends a search before its end, over all runs of lp_solve for one program.
struct Limits {
  const Context* context;
  Clock::time_point end;
  double size;         ///< rows and columns
  double effort_left;  ///< iterations times size

  bool are_reached(lprec* lp) const {
    return static_cast<double>(get_total_iter(lp)) * size >= effort_left || Clock::now() >= end;
  }
};

int __WINAPI must_stop(lprec* lp, void* handle) {
  const auto* limits = static_cast<const Limits*>(handle);
  return limits->context->is_cancelled() || limits->are_reached(lp);
}

/// Limits from the options; times beyond what the clock counts mean none.
Limits limits_of(const IntegerProgram& program, const SolveOptions& options,
                 const Context& context) {
  constexpr double a_year = 3e7;
  const std::chrono::duration<double> time(std::min(options.time_limit_seconds, a_year));
  return {&context, Clock::now() + std::chrono::duration_cast<Clock::duration>(time),
          static_cast<double>(program.rows.size() + program.variables.size()), options.max_effort};
}

struct DeleteLp {
  void operator()(lprec* lp) const { delete_lp(lp); }
};
using Lp = std::unique_ptr<lprec, DeleteLp>;

void check_variable(const IntegerProgram::Variable& v) {
  if (std::isnan(v.lower) || std::isnan(v.upper) || !std::isfinite(v.objective))
    throw InputError(stage, "The variable '" + v.name + "' has a bound or cost that is no number.");
  if (v.lower > v.upper)
    throw InputError(stage, "The bounds of the variable '" + v.name + "' are crossed.");
}

void check_row(const IntegerProgram::Row& row, int n_variables) {
  bool good = std::isfinite(row.right);
  for (const auto& term : row.terms)
    good = good && term.variable >= 0 && term.variable < n_variables &&
           std::isfinite(term.coefficient);
  if (!good)
    throw InputError(stage,
                     "The row '" + row.name + "' has an unknown variable or no finite number.");
}

void check(const IntegerProgram& program, const SolveOptions& options) {
  if (!(options.time_limit_seconds > 0.0) || !(options.max_effort > 0.0) || !(options.gap >= 0.0))
    throw InputError(stage, "The solver's limits must be above zero and its gap not below.");
  for (const auto& v : program.variables) check_variable(v);
  for (const auto& row : program.rows) check_row(row, static_cast<int>(program.variables.size()));
}

int lp_sense(Sense s) {
  return s == Sense::equal ? EQ : s == Sense::less_equal ? LE : GE;
}

const double lp_infinity = 1e30;  // lp_solve's own

double lp_bound(double b) {
  return std::isinf(b) ? (b > 0 ? lp_infinity : -lp_infinity) : b;
}

bool is_finite(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [](double v) { return std::abs(v) < lp_infinity; });
}

void add_row_to(lprec* lp, const IntegerProgram::Row& row) {
  std::map<int, double> sum;
  for (const auto& term : row.terms) sum[term.variable + 1] += term.coefficient;
  std::vector<int> columns;
  std::vector<REAL> values;
  for (const auto& [column, value] : sum) {
    columns.push_back(column);
    values.push_back(value);
  }
  add_constraintex(lp, static_cast<int>(columns.size()), values.data(), columns.data(),
                   lp_sense(row.sense), row.right);
}

Lp build(const IntegerProgram& program) {
  const int n = static_cast<int>(program.variables.size());
  Lp lp(make_lp(0, n));
  if (!lp) throw SolverError(stage, "lp_solve could not be started (out of memory).");
  set_verbose(lp.get(), NEUTRAL);
  std::vector<REAL> costs(n + 1, 0.0);
  for (int j = 0; j < n; ++j) costs[j + 1] = program.variables[j].objective;
  set_add_rowmode(lp.get(), TRUE);
  set_obj_fn(lp.get(), costs.data());
  for (const auto& row : program.rows) add_row_to(lp.get(), row);
  set_add_rowmode(lp.get(), FALSE);
  for (int j = 0; j < n; ++j) {
    const auto& v = program.variables[j];
    set_bounds(lp.get(), j + 1, lp_bound(v.lower), lp_bound(v.upper));
    set_int(lp.get(), j + 1, v.is_integer ? TRUE : FALSE);
  }
  set_minim(lp.get());
  return lp;
}

/// Rounds integers and says whether bounds and rows hold, to what the solver's own tolerance
/// allows.
bool polish(const IntegerProgram& program, std::vector<double>& x) {
  const double slack =
      1e-6;  // lp_solve's integer tolerance is 1e-7, its feasibility tolerance 1e-9
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto& v = program.variables[j];
    if (v.is_integer) x[j] = std::round(x[j]);
    const double room = slack * (1.0 + std::abs(x[j]));
    if (x[j] < v.lower - room || x[j] > v.upper + room) return false;
  }
  for (const auto& row : program.rows) {
    double sum = 0.0, scale = 1.0 + std::abs(row.right);
    for (const auto& term : row.terms) {
      sum += term.coefficient * x[term.variable];
      scale += std::abs(term.coefficient * x[term.variable]);
    }
    const double over = sum - row.right;
    if (over > slack * scale && row.sense != Sense::greater_equal) return false;
    if (over < -slack * scale && row.sense != Sense::less_equal) return false;
  }
  return true;
}

enum class Attempt { solved, cut_short, infeasible, unbounded, failed };

Attempt attempt_of(int code) {
  switch (code) {
    case OPTIMAL:
    case PRESOLVED:
      return Attempt::solved;
    case SUBOPTIMAL:
      return Attempt::cut_short;
    case INFEASIBLE:
      return Attempt::infeasible;
    case UNBOUNDED:
      return Attempt::unbounded;
    default:
      return Attempt::failed;
  }
}

/// One run of lp_solve. The settings differ in scaling and simplex type: a program that stalls or
/// loses its digits in one of them is solved by the next.
Attempt run(const IntegerProgram& program, const SolveOptions& options, Limits& limits, int setting,
            std::vector<double>& values) {
  const Lp lp = build(program);
  put_abortfunc(lp.get(), must_stop, &limits);
  set_mip_gap(lp.get(), TRUE, options.gap);
  set_mip_gap(lp.get(), FALSE, options.gap);
  set_break_at_first(lp.get(), options.first_feasible ? TRUE : FALSE);
  if (setting == 1) set_scaling(lp.get(), SCALE_NONE);
  if (setting == 2) set_simplextype(lp.get(), SIMPLEX_PRIMAL_PRIMAL);
  const Attempt result = attempt_of(solve(lp.get()));
  limits.effort_left -= static_cast<double>(get_total_iter(lp.get())) * limits.size;
  if (result != Attempt::solved && result != Attempt::cut_short) return result;
  values.assign(program.variables.size(), 0.0);
  if (!get_variables(lp.get(), values.data())) return Attempt::failed;
  if (!is_finite(values)) return Attempt::unbounded;  // so it answers where there are no rows
  return polish(program, values) ? result : Attempt::failed;
}

double cost(const IntegerProgram& program, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) sum += program.variables[j].objective * x[j];
  return sum;
}

/// lp_solve wants at least one column.
Solution solve_empty(const IntegerProgram& program) {
  std::vector<double> none;
  return {polish(program, none) ? SolveStatus::optimal : SolveStatus::infeasible, {}, 0.0, 0.0};
}

}  // namespace

Solution solve(const IntegerProgram& program, const SolveOptions& options, Context& context) {
  check(program, options);
  context.check(stage);
  if (program.variables.empty()) return solve_empty(program);
  Limits limits = limits_of(program, options, context);
  const int n_settings = 3;
  for (int setting = 0; setting < n_settings; ++setting) {
    std::vector<double> values;
    const Attempt result = run(program, options, limits, setting, values);
    context.check(stage);
    if (result == Attempt::infeasible) return {SolveStatus::infeasible, {}, 0.0, 0.0};
    if (result == Attempt::unbounded)
      throw SolverError(stage, "The linear program has no finite optimum.");
    if (result != Attempt::failed) {
      const bool cut = result == Attempt::cut_short;
      const double objective = cost(program, values);
      return {cut ? SolveStatus::feasible_at_limit : SolveStatus::optimal, values, objective,
              options.max_effort - limits.effort_left};
    }
    if (limits.effort_left <= 0.0 || Clock::now() >= limits.end)
      throw SolverError(stage, "lp_solve found no solution within its limits.");
  }
  throw SolverError(stage, "lp_solve failed numerically.");
}

}  // namespace sweepmesh
