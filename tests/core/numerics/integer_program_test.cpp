#include "sweepmesh/numerics/lp/integer_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sweepmesh {
namespace {

IntegerProgram::Variable integer(double lower, double upper, double objective) {
  return {lower, upper, true, objective, "x"};
}

double value(const IntegerProgram& p, const std::vector<int>& x) {
  double sum = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) sum += p.variables[j].objective * x[j];
  return sum;
}

bool holds(const IntegerProgram& p, const std::vector<int>& x) {
  for (const auto& row : p.rows) {
    double sum = 0.0;
    for (const auto& term : row.terms) sum += term.coefficient * x[term.variable];
    if (row.sense == Sense::equal && sum != row.right) return false;
    if (row.sense == Sense::less_equal && sum > row.right) return false;
    if (row.sense == Sense::greater_equal && sum < row.right) return false;
  }
  return true;
}

/// Smallest value over all points of the box 0..4 in each variable, or infinity.
double by_enumeration(const IntegerProgram& p) {
  const int n = static_cast<int>(p.variables.size());
  std::vector<int> x(n, 0);
  double best = unbounded;
  while (true) {
    if (holds(p, x)) best = std::min(best, value(p, x));
    int j = 0;
    while (j < n && ++x[j] == 5) x[j++] = 0;
    if (j == n) return best;
  }
}

IntegerProgram random_program(std::mt19937& random) {
  const auto draw = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % (high - low + 1)));
  };
  IntegerProgram p;
  for (int j = 0; j < 4; ++j) p.add_variable(integer(0, 4, draw(-5, 5)));
  const int n_rows = 1 + random() % 4;
  for (int r = 0; r < n_rows; ++r) {
    IntegerProgram::Row row{{}, static_cast<Sense>(random() % 3), draw(-3, 9), "r"};
    for (int j = 0; j < 4; ++j) row.terms.push_back({j, draw(-3, 3)});
    p.add_row(row);
  }
  return p;
}

TEST(IntegerProgram, AgreesWithEnumeration) {
  std::mt19937 random(1);
  int n_infeasible = 0;
  for (int run = 0; run < 200; ++run) {
    const IntegerProgram p = random_program(random);
    Context context;
    const Solution s = solve(p, {}, context);
    const double best = by_enumeration(p);
    if (std::isinf(best)) {
      EXPECT_EQ(s.status, SolveStatus::infeasible);
      ++n_infeasible;
      continue;
    }
    ASSERT_EQ(s.status, SolveStatus::optimal) << run;
    EXPECT_NEAR(s.objective, best, 1e-9) << run;
    EXPECT_EQ(solve(p, {}, context).values, s.values);
  }
  EXPECT_GT(n_infeasible, 5);
  EXPECT_LT(n_infeasible, 195);
}

TEST(IntegerProgram, FreeAndContinuousVariables) {
  IntegerProgram p;  // minimise |x - 2.5| with x below 1: x free, d >= |x - 2.5|
  const int x = p.add_variable({-unbounded, unbounded, false, 0.0, "x"});
  const int d = p.add_variable({0.0, unbounded, false, 1.0, "d"});
  p.add_row({{{d, 1.0}, {x, 1.0}}, Sense::greater_equal, 2.5, "below"});
  p.add_row({{{d, 1.0}, {x, -1.0}}, Sense::greater_equal, -2.5, "above"});
  p.add_row({{{x, 1.0}}, Sense::less_equal, -1.0, "limit"});
  Context context;
  const Solution s = solve(p, {}, context);
  ASSERT_EQ(s.status, SolveStatus::optimal);
  EXPECT_NEAR(s.values[x], -1.0, 1e-9);
  EXPECT_NEAR(s.objective, 3.5, 1e-9);
}

TEST(IntegerProgram, RepeatedTermsAddUp) {
  IntegerProgram p;
  p.add_variable(integer(0, 10, 1.0));
  p.add_row({{{0, 1.0}, {0, 1.0}}, Sense::equal, 6.0, "twice"});
  Context context;
  EXPECT_EQ(solve(p, {}, context).values, std::vector<double>{3.0});
}

TEST(IntegerProgram, NoVariables) {
  IntegerProgram p;
  Context context;
  EXPECT_EQ(solve(p, {}, context).status, SolveStatus::optimal);
  p.add_row({{}, Sense::equal, 1.0, "impossible"});
  EXPECT_EQ(solve(p, {}, context).status, SolveStatus::infeasible);
}

TEST(IntegerProgram, RefusesWhatIsMalformed) {
  Context context;
  IntegerProgram crossed;
  crossed.add_variable(integer(3, 2, 1.0));
  EXPECT_THROW(solve(crossed, {}, context), InputError);
  IntegerProgram unknown;
  unknown.add_variable(integer(0, 2, 1.0));
  unknown.add_row({{{1, 1.0}}, Sense::equal, 1.0, "r"});
  EXPECT_THROW(solve(unknown, {}, context), InputError);
  IntegerProgram nan;
  nan.add_variable(integer(0, 2, std::nan("")));
  EXPECT_THROW(solve(nan, {}, context), InputError);
  IntegerProgram fine;
  fine.add_variable(integer(0, 2, 1.0));
  EXPECT_THROW(solve(fine, {.time_limit_seconds = 0.0}, context), InputError);
}

TEST(IntegerProgram, UnboundedIsAnError) {
  IntegerProgram p;
  p.add_variable({0.0, unbounded, false, -1.0, "x"});
  Context context;
  EXPECT_THROW(solve(p, {}, context), SolverError);
}

/// Equal-weight subset sums with an odd right side: branch and bound must visit very many nodes.
IntegerProgram hard_program() {
  IntegerProgram p;
  IntegerProgram::Row even{{}, Sense::equal, 45.0, "even"};
  for (int j = 0; j < 44; ++j) even.terms.push_back({p.add_variable(integer(0, 1, 1.0)), 2.0});
  even.terms.push_back({p.add_variable({0.0, 1.0, false, 1e6, "slack"}), 1.0});
  even.terms.push_back({p.add_variable({0.0, 0.5, false, 1e3, "half"}), 1.0});
  p.add_row(even);
  return p;
}

TEST(IntegerProgram, TimeLimitReturnsBestSoFar) {
  Context context;
  const Solution s = solve(hard_program(), {.time_limit_seconds = 0.3}, context);
  EXPECT_EQ(s.status, SolveStatus::feasible_at_limit);
  EXPECT_EQ(s.values.size(), 46u);
}

TEST(IntegerProgram, LimitOfEffortReturnsTheSameEachTime) {
  Context context;
  const SolveOptions few = {.max_effort = 1e5}, none = {.max_effort = 1.0};
  const Solution a = solve(hard_program(), few, context), b = solve(hard_program(), few, context);
  EXPECT_EQ(a.status, SolveStatus::feasible_at_limit);
  EXPECT_EQ(a.values, b.values);
  EXPECT_THROW(solve(hard_program(), none, context), SolverError);
  EXPECT_THROW(solve(hard_program(), {.max_effort = 0.0}, context), InputError);
}

TEST(IntegerProgram, CancelledBeforeItStarts) {
  Context context;
  context.cancel();
  EXPECT_THROW(solve(hard_program(), {}, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh
