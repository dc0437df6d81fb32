#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sweepmesh/intervals/count_conflict.h"
#include "sweepmesh/intervals/count_problem.h"
#include "sweepmesh/intervals/count_reduction.h"
#include "sweepmesh/intervals/count_repair.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Demand = CountProblem::Demand;

bool is_parity(Kind k) {
  return k == Kind::even || k == Kind::preferably_even;
}
bool is_odd(double coefficient) {
  return std::fmod(std::abs(coefficient), 2.0) == 1.0;
}

/// Demands of each class.
std::vector<std::vector<int>> demands_of_classes(const CountClasses& c) {
  std::vector<std::vector<int>> out(c.classes.size());
  for (std::size_t d = 0; d < c.demands.size(); ++d)
    for (const auto& t : c.demands[d].terms) out[t.variable].push_back(static_cast<int>(d));
  return out;
}

double coefficient_in(const Demand& d, int variable) {
  for (const auto& t : d.terms)
    if (t.variable == variable) return t.coefficient;
  return 0.0;
}

/// Cost of moving a class from its best count to the nearest whole number of other parity.
double flip_cost(const CountClasses::Class& c) {
  const double n = best_count(c);
  double cost = unbounded;
  if (n + 1.0 <= c.upper) cost = class_cost(c, n + 1.0) - class_cost(c, n);
  if (n - 1.0 >= c.lower) cost = std::min(cost, class_cost(c, n - 1.0) - class_cost(c, n));
  return cost;
}

/// Classes that appear in parity demands only, and in the same ones with an odd coefficient, can
/// stand in for one another: an optimum moves at most one of them, the cheapest. All others stay at
/// their best.
std::vector<bool> fixed_classes(const CountClasses& c) {
  const auto demands = demands_of_classes(c);
  std::vector<bool> fixed(c.classes.size(), false);
  std::map<std::vector<int>, int> cheapest;
  for (int v = 0; v < static_cast<int>(c.classes.size()); ++v) {
    std::vector<int> signature;
    bool only_parity = true;
    for (const int d : demands[v]) {
      only_parity = only_parity && is_parity(c.demands[d].kind);
      if (is_odd(coefficient_in(c.demands[d], v))) signature.push_back(d);
    }
    if (!only_parity) continue;
    fixed[v] = true;
    if (signature.empty()) continue;
    const auto [at, is_new] = cheapest.emplace(signature, v);
    if (!is_new && flip_cost(c.classes[v]) < flip_cost(c.classes[at->second])) at->second = v;
  }
  for (const auto& [signature, v] : cheapest) fixed[v] = false;
  return fixed;
}

/// Sum demands over two or more classes that hold whatever the classes do within a step of their
/// best count bind nothing that parity could break; at_least rows with this room are dropped.
void drop_slack_demands(CountClasses& c) {
  const auto demands = demands_of_classes(c);
  const auto others_hold = [&](int v) {
    return std::all_of(demands[v].begin(), demands[v].end(), [&](int d) {
      return is_parity(c.demands[d].kind) || c.demands[d].kind == Kind::at_least;
    });
  };
  std::vector<Demand> kept;
  for (const auto& d : c.demands) {
    double least = 0.0;
    bool has_room = d.kind == Kind::at_least;
    for (const auto& t : d.terms) {
      has_room = has_room && t.coefficient > 0.0 && others_hold(t.variable);
      const auto& k = c.classes[t.variable];
      if (has_room) least += t.coefficient * std::max(k.lower, best_count(k) - 1.0);
    }
    if (!has_room || least < d.right) kept.push_back(d);
  }
  c.demands = std::move(kept);
}

/// Parts of the problem that share no free class: demands by part.
std::vector<std::vector<int>> independent_parts(const CountClasses& c,
                                                const std::vector<bool>& fixed) {
  const int n = static_cast<int>(c.classes.size());
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int x) {
    while (parent[x] != x) x = parent[x] = parent[parent[x]];
    return x;
  };
  const auto first_free = [&](const Demand& d) {
    for (const auto& t : d.terms)
      if (!fixed[t.variable]) return t.variable;
    return -1;
  };
  for (const auto& d : c.demands)
    for (const auto& t : d.terms)
      if (!fixed[t.variable]) parent[find(t.variable)] = find(first_free(d));
  std::map<int, std::vector<int>> parts;
  for (std::size_t d = 0; d < c.demands.size(); ++d) {
    const int v = first_free(c.demands[d]);
    parts[v < 0 ? -1 - static_cast<int>(d) : find(v)].push_back(static_cast<int>(d));
  }
  std::vector<std::vector<int>> out;
  for (auto& [root, members] : parts) out.push_back(std::move(members));
  return out;
}

/// Length of the next linear piece at distance `at` from the best count: one near it, a third
/// further out.
double piece_length(double at) {
  return std::max(1.0, std::floor(at / 3.0));
}

/// One independent part as an integer program.
class PartProgram {
 public:
  PartProgram(const CountClasses& c, const std::vector<double>& start,
              const std::vector<bool>& fixed, const CountOptions& options)
      : classes_(c), start_(start), fixed_(fixed), options_(options) {}

  void add(const Demand& d) {
    IntegerProgram::Row row{{}, sense(d.kind), is_parity(d.kind) ? 0.0 : d.right, d.text};
    for (const auto& t : d.terms) {
      if (fixed_[t.variable])
        row.right -= t.coefficient * start_[t.variable];
      else
        row.terms.push_back({variable(t.variable), t.coefficient});
    }
    if (is_parity(d.kind)) add_parity(d.kind, row);
    program_.add_row(std::move(row));
  }

  const IntegerProgram& program() const { return program_; }
  const std::map<int, int>& variables() const { return variable_; }

 private:
  static Sense sense(Kind k) {
    return k == Kind::at_most    ? Sense::less_equal
           : k == Kind::at_least ? Sense::greater_equal
                                 : Sense::equal;
  }

  void add_parity(Kind kind, IntegerProgram::Row& row) {
    row.terms.push_back({program_.add_variable({-unbounded, unbounded, true, 0.0, "half"}), -2.0});
    if (kind == Kind::preferably_even)
      row.terms.push_back(
          {program_.add_variable({0.0, 1.0, true, options_.odd_penalty, "odd"}), -1.0});
  }

  int variable(int c) {
    const auto at = variable_.find(c);
    if (at != variable_.end()) return at->second;
    const auto& k = classes_.classes[c];
    const int v = program_.add_variable({k.lower, k.upper, true, 0.0, "n"});
    variable_[c] = v;
    if (!k.wishes.empty()) add_cost(c, v);
    return v;
  }

  /// n = start + sum of up pieces - sum of down pieces, with growing slopes.
  void add_cost(int c, int v) {
    IntegerProgram::Row row{{{v, 1.0}}, Sense::equal, start_[c], "deviation"};
    add_pieces(c, +1.0, classes_.classes[c].upper, row);
    add_pieces(c, -1.0, classes_.classes[c].lower, row);
    program_.add_row(std::move(row));
  }

  /// Pieces up to three times the start; the last goes on as far as the bound allows.
  void add_pieces(int c, double sign, double bound, IntegerProgram::Row& row) {
    const double room = std::abs(bound - start_[c]), far = 4.0 + 2.0 * start_[c];
    for (double at = 0.0; at < room;) {
      const double length = std::min(piece_length(at), room - at);
      const double rise = cost_at(c, sign * (at + length)) - cost_at(c, sign * at);
      const double upper = at >= far ? room - at : length;
      row.terms.push_back({program_.add_variable({0.0, upper, false, rise / length, "d"}), -sign});
      at += upper;
    }
  }

  double cost_at(int c, double away) const {
    return class_cost(classes_.classes[c], start_[c] + away);
  }

  const CountClasses& classes_;
  const std::vector<double>& start_;
  const std::vector<bool>& fixed_;
  const CountOptions& options_;
  IntegerProgram program_;
  std::map<int, int> variable_;
};

bool bounds_cross(const CountClasses& c) {
  return std::any_of(c.classes.begin(), c.classes.end(),
                     [](const auto& k) { return k.lower > k.upper; });
}

/// Solves parts one after the other; the values of classes in no part are those of least cost.
class PartSolver {
 public:
  PartSolver(const CountClasses& c, const CountOptions& options, Context& context)
      : classes_(c), options_(options), context_(context), fixed_(fixed_classes(c)) {
    for (const auto& k : c.classes) start_.push_back(best_count(k));
    value_ = start_;
  }

  bool solve_all() {
    for (const auto& part : independent_parts(classes_, fixed_)) {
      if (!solve_part(part)) return false;
    }
    return true;
  }

  const std::vector<double>& values() const { return value_; }
  bool is_optimal() const { return is_optimal_; }

 private:
  enum class Outcome { solved, infeasible, no_answer };
  /// Part of the effort after which branch and bound mostly finds nothing better.
  static constexpr double short_part = 0.05;

  /// First without even sums, which leaves a program with (nearly) whole corners; these are then
  /// repaired within a step or two. Where that fails branch and bound sees the even sums, at first
  /// for a short while only, and the wide repair competes with what it found: neither way is the
  /// better one on every solid.
  bool solve_part(const std::vector<int>& part) {
    if (solve_program(part, false, options_.max_effort) != Outcome::solved) return false;
    const std::size_t few = 500;  // states: they decide most problems at once
    const std::size_t many = 400'000 / part.size();
    const bool is_wide = many > 2 * few;  // else it would fail again
    if (!has_parity(part) || repair(part, 1, few)) return true;
    const std::vector<double> without_parity = value_;
    const double a_few_relaxations = 4.0 * last_effort_;
    const Outcome quick =
        try_program(part, std::max(short_part * options_.max_effort, a_few_relaxations));
    if (quick == Outcome::infeasible) return false;
    if (quick == Outcome::solved) {
      if (!is_optimal_ && is_wide && !options_.any_will_do)
        improve_by_repair(part, many, without_parity);
      return true;
    }
    return (is_wide && (repair(part, 1, many) || repair(part, 2, many))) ||
           solve_program(part, true, options_.max_effort) == Outcome::solved;
  }

  /// Repairs `start`; the values stay where that is no better.
  void improve_by_repair(const std::vector<int>& part, std::size_t max_states,
                         const std::vector<double>& start) {
    const std::vector<double> found = value_;
    const double cost = cost_of(part);
    value_ = start;
    if (!repair(part, 1, max_states) || cost_of(part) > cost) value_ = found;
  }

  /// Of the classes' values, and of the preferred even sums of a part that are odd.
  double cost_of(const std::vector<int>& part) const {
    double cost = 0.0;
    for (std::size_t k = 0; k < value_.size(); ++k)
      cost += class_cost(classes_.classes[k], value_[k]);
    for (const int d : part) {
      if (classes_.demands[d].kind != Kind::preferably_even) continue;
      double sum = 0.0;
      for (const auto& t : classes_.demands[d].terms) sum += t.coefficient * value_[t.variable];
      if (is_odd(sum)) cost += options_.odd_penalty;
    }
    return cost;
  }

  bool has_parity(const std::vector<int>& part) const {
    return std::any_of(part.begin(), part.end(),
                       [&](int d) { return is_parity(classes_.demands[d].kind); });
  }

  Outcome try_program(const std::vector<int>& part, double effort) {
    try {
      return solve_program(part, true, effort);
    } catch (const SolverError&) {
      return Outcome::no_answer;
    }
  }

  Outcome solve_program(const std::vector<int>& part, bool with_parity, double effort) {
    PartProgram p(classes_, start_, fixed_, options_);
    for (const int d : part)
      if (with_parity || !is_parity(classes_.demands[d].kind)) p.add(classes_.demands[d]);
    SolveOptions how{.max_effort = effort, .time_limit_seconds = options_.time_limit_seconds};
    if (with_parity)
      how.gap = 0.05;  // the relaxation sees no parity: the last bit cannot be proven
    how.first_feasible = with_parity && options_.any_will_do;
    const Solution s = solve(p.program(), how, context_);
    if (s.status == SolveStatus::infeasible) return Outcome::infeasible;
    is_optimal_ = is_optimal_ && s.status == SolveStatus::optimal;
    last_effort_ = s.effort;
    for (const auto& [k, v] : p.variables()) value_[k] = s.values[v];
    return Outcome::solved;
  }

  bool repair(const std::vector<int>& part, int max_step, std::size_t max_states) {
    const RepairOptions how{max_step, options_.odd_penalty, max_states};
    auto repaired = repair_parity(classes_, part, fixed_, value_, how);
    if (repaired) value_ = std::move(*repaired);
    return repaired.has_value();
  }

  const CountClasses& classes_;
  const CountOptions& options_;
  Context& context_;
  std::vector<bool> fixed_;
  std::vector<double> start_, value_;
  bool is_optimal_ = true;
  double last_effort_ = 0.0;
};

/// Class values, or nothing where infeasible. `is_optimal` is cleared when a part reached a limit.
std::optional<std::vector<double>> solve_classes(const CountClasses& c, const CountOptions& options,
                                                 Context& context, bool& is_optimal) {
  if (bounds_cross(c)) return std::nullopt;
  PartSolver solver(c, options, context);
  if (!solver.solve_all()) return std::nullopt;
  is_optimal = solver.is_optimal();
  return solver.values();
}

std::optional<std::vector<double>> reduce_and_solve(const CountProblem& problem, CountClasses& c,
                                                    const CountOptions& options, Context& context,
                                                    bool& is_optimal) {
  c = merge_equal(problem);
  drop_slack_demands(c);
  return solve_classes(c, options, context, is_optimal);
}

}  // namespace

bool is_feasible(const CountProblem& problem, const CountOptions& options, Context& context) {
  CountClasses c;
  bool is_optimal = true;
  return reduce_and_solve(problem, c, options, context, is_optimal).has_value();
}

CountSolution solve_counts(const CountProblem& problem, const CountOptions& options,
                           Context& context) {
  CountSolution out;
  CountClasses c;
  const auto value = reduce_and_solve(problem, c, options, context, out.is_optimal);
  if (!value) {
    if (options.explain) out.conflict = smallest_conflict(problem, options, context);
    return out;
  }
  out.is_feasible = true;
  for (const int k : c.class_of) out.values.push_back(std::lround((*value)[k]));
  for (std::size_t k = 0; k < c.classes.size(); ++k)
    out.cost += class_cost(c.classes[k], (*value)[k]);
  return out;
}

}  // namespace sweepmesh
