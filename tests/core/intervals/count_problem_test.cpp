// Counts: demands are met, deviations spread in proportion, even sums at least cost, conflicts
// minimal.
#include "sweepmesh/intervals/count_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sweepmesh/intervals/count_conflict.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;

int wished(CountProblem& p, double wish) {
  return p.add({1.0, unbounded, wish, 1.0});
}

void demand(CountProblem& p, Kind kind, std::vector<IntegerProgram::Term> terms,
            double right = 0.0) {
  p.demand({kind, std::move(terms), right, {}, "demand " + std::to_string(p.demands.size())});
}

CountSolution solved(const CountProblem& p) {
  Context context;
  return solve_counts(p, {}, context);
}

bool is_met(const CountProblem::Demand& d, const std::vector<long>& x) {
  double sum = 0.0;
  for (const auto& t : d.terms) sum += t.coefficient * static_cast<double>(x[t.variable]);
  switch (d.kind) {
    case Kind::equality:
      return sum == d.right;
    case Kind::at_most:
      return sum <= d.right;
    case Kind::at_least:
      return sum >= d.right;
    case Kind::even:
      return std::fmod(sum, 2.0) == 0.0;
    default:
      return true;
  }
}

void expect_met(const CountProblem& p, const CountSolution& s) {
  ASSERT_TRUE(s.is_feasible);
  for (const auto& d : p.demands) EXPECT_TRUE(is_met(d, s.values)) << d.text;
}

double cost_of(const CountProblem& p, const std::vector<long>& x, double odd_penalty) {
  double cost = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (const auto wish = p.unknowns[j].wish) cost += x[j] / *wish + *wish / x[j] - 2.0;
  for (const auto& d : p.demands) {
    double sum = 0.0;
    for (const auto& t : d.terms) sum += t.coefficient * static_cast<double>(x[t.variable]);
    if (d.kind == Kind::preferably_even && std::fmod(std::abs(sum), 2.0) == 1.0)
      cost += odd_penalty;
  }
  return cost;
}

TEST(CountProblem, EqualUnknownsMeetAtTheirGeometricMean) {
  CountProblem p;
  const int a = wished(p, 4.0), b = wished(p, 9.0);
  demand(p, Kind::equality, {{a, 1.0}, {b, -1.0}});
  EXPECT_EQ(solved(p).values, (std::vector<long>{6, 6}));
}

TEST(CountProblem, DeviationIsSpreadInProportion) {
  CountProblem p;  // 10 + 20 + 40 = 70 must become 84: each a fifth more
  const auto add = [&](double wish) { return p.add({1.0, unbounded, wish, wish}); };
  const int a = add(10.0), b = add(20.0), c = add(40.0);
  demand(p, Kind::equality, {{a, 1.0}, {b, 1.0}, {c, 1.0}}, 84.0);
  const auto s = solved(p);
  expect_met(p, s);
  EXPECT_EQ(s.values, (std::vector<long>{12, 24, 48}));
}

TEST(CountProblem, EvenSumMovesTheCheapestOnly) {
  CountProblem p;
  const int a = wished(p, 3.0), b = wished(p, 51.0), c = wished(p, 5.0);
  demand(p, Kind::even, {{a, 1.0}, {b, 1.0}, {c, 1.0}});
  const auto s = solved(p);
  expect_met(p, s);
  EXPECT_EQ(s.values[a], 3);
  EXPECT_EQ(std::abs(s.values[b] - 51), 1);
  EXPECT_EQ(s.values[c], 5);
}

TEST(CountProblem, PreferredEvenSumGivesWayToHardDemands) {
  CountProblem p;
  const int a = wished(p, 7.0);
  demand(p, Kind::preferably_even, {{a, 1.0}});
  EXPECT_EQ(solved(p).values[a] % 2, 0);
  demand(p, Kind::equality, {{a, 1.0}}, 7.0);
  EXPECT_EQ(solved(p).values[a], 7);
}

/// Demands of random signs over few unknowns, solvable by construction at a hidden point.
CountProblem random_problem(std::mt19937& random, int n, std::vector<long>& hidden) {
  CountProblem p;
  for (int j = 0; j < n; ++j) {
    hidden.push_back(1 + random() % 6);
    wished(p, 1.0 + (random() % 50) / 10.0);
  }
  for (int r = 0; r < 3; ++r) {
    std::vector<IntegerProgram::Term> terms;
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
      const double a = static_cast<double>(random() % 3) - 1.0;
      if (a == 0.0) continue;
      terms.push_back({j, a});
      sum += a * hidden[j];
    }
    const bool is_even = std::fmod(std::abs(sum), 2.0) == 0.0;
    const Kind kinds[] = {Kind::equality, is_even ? Kind::even : Kind::preferably_even,
                          Kind::at_least};
    demand(p, kinds[random() % 3], terms, sum);
  }
  return p;
}

/// All points of 1..8 in each unknown.
double best_by_enumeration(const CountProblem& p) {
  std::vector<long> x(p.unknowns.size(), 1);
  double best = unbounded;
  while (true) {
    bool met = true;
    for (const auto& d : p.demands) met = met && is_met(d, x);
    if (met) best = std::min(best, cost_of(p, x, CountOptions{}.odd_penalty));
    std::size_t j = 0;
    while (j < x.size() && ++x[j] == 9) x[j++] = 1;
    if (j == x.size()) return best;
  }
}

TEST(CountProblem, AgreesWithEnumeration) {
  std::mt19937 random(7);
  int n_best = 0;
  const int n_runs = 150;
  for (int run = 0; run < n_runs; ++run) {
    std::vector<long> hidden;
    const CountProblem p = random_problem(random, 4, hidden);
    const auto s = solved(p);
    expect_met(p, s);
    const double best = best_by_enumeration(p);
    const double cost = cost_of(p, s.values, CountOptions{}.odd_penalty);
    EXPECT_LE(cost, best + 0.6) << run;  // even sums are repaired near the optimum without them
    n_best += cost <= best + 1e-9;
    EXPECT_EQ(solved(p).values, s.values);
  }
  EXPECT_GE(n_best, n_runs * 9 / 10);
}

TEST(CountProblem, ConflictIsMinimal) {
  std::mt19937 random(3);
  for (int run = 0; run < 20; ++run) {
    CountProblem p;  // a chain of equal unknowns with two ends that differ, among harmless demands
    std::vector<int> x;
    for (int j = 0; j < 30; ++j) x.push_back(wished(p, 5.0));
    for (int j = 0; j + 1 < 30; ++j) demand(p, Kind::equality, {{x[j], 1.0}, {x[j + 1], -1.0}});
    const int a = random() % 30, b = (a + 1 + random() % 29) % 30;
    demand(p, Kind::equality, {{x[a], 1.0}}, 4.0);
    demand(p, Kind::equality, {{x[b], 1.0}}, 6.0);
    const auto s = solved(p);
    ASSERT_FALSE(s.is_feasible);
    EXPECT_EQ(static_cast<int>(s.conflict.size()), std::abs(a - b) + 2);
    Context context;
    for (std::size_t spared = 0; spared < s.conflict.size(); ++spared) {
      CountProblem part;
      part.unknowns = p.unknowns;
      for (std::size_t d = 0; d < s.conflict.size(); ++d)
        if (d != spared) part.demands.push_back(p.demands[s.conflict[d]]);
      EXPECT_TRUE(is_feasible(part, {}, context));
    }
  }
}

TEST(CountProblem, OddFixedSumIsAConflict) {
  CountProblem p;
  const int a = wished(p, 3.0), b = wished(p, 4.0);
  demand(p, Kind::equality, {{a, 1.0}}, 3.0);
  demand(p, Kind::equality, {{b, 1.0}}, 4.0);
  demand(p, Kind::even, {{a, 1.0}, {b, 1.0}});
  EXPECT_EQ(solved(p).conflict, (std::vector<int>{0, 1, 2}));
}

TEST(CountProblem, ManyLoopsAreNoCliff) {
  CountProblem p;  // a plate with 400 holes of three edges each, every loop and their sum even
  std::vector<IntegerProgram::Term> all;
  for (int loop = 0; loop < 400; ++loop) {
    std::vector<IntegerProgram::Term> around;
    for (int e = 0; e < 3; ++e) around.push_back({wished(p, 2.0 + (7 * loop + 3 * e) % 11), 1.0});
    demand(p, Kind::at_least, around, 4.0);
    demand(p, Kind::preferably_even, around);
    all.insert(all.end(), around.begin(), around.end());
  }
  demand(p, Kind::even, all);
  const auto s = solved(p);
  expect_met(p, s);
  EXPECT_TRUE(s.is_optimal);
  EXPECT_EQ(cost_of(p, s.values, 0.0), cost_of(p, s.values, 1.0)) << "some loop is odd";
}

TEST(CountProblem, Cancelled) {
  CountProblem p;
  const int a = wished(p, 3.0), b = wished(p, 4.0);
  demand(p, Kind::equality, {{a, 1.0}, {b, 1.0}}, 9.0);
  Context context;
  context.cancel();
  EXPECT_THROW(solve_counts(p, {}, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh
