#include "sweepmesh/scheme/loop_program.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace sweepmesh {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::array kTypes = {1, 0, -1, -2};

/// All directions tried one by one.
LoopMarginals brute_force(const LoopProgram& loop) {
  const int n = static_cast<int>(loop.type_cost.size());
  LoopMarginals out{kInf, 0, {}};
  out.marginal.assign(n, {kInf, kInf, kInf, kInf});
  long n_cases = 1;
  for (int i = 0; i <= n; ++i) n_cases *= 4;  // direction of the first coedge, then the types
  for (long number = 0; number < n_cases; ++number) {
    int direction = static_cast<int>(number % 4), sum = 0;
    long rest = number / 4;
    double cost = 0.0;
    std::vector<int> directions;
    for (int c = 0; c < n; ++c, rest /= 4) {
      directions.push_back(direction);
      cost += loop.direction_cost[c][direction] + loop.type_cost[c][rest % 4];
      sum += kTypes[rest % 4];
      direction = ((direction + kTypes[rest % 4]) % 4 + 4) % 4;
    }
    if (sum != loop.sum) continue;
    out.best = std::min(out.best, cost);
    for (int c = 0; c < n; ++c)
      out.marginal[c][directions[c]] = std::min(out.marginal[c][directions[c]], cost);
  }
  return out;
}

LoopProgram random_loop(std::mt19937& random, int n, int sum) {
  std::uniform_real_distribution<double> cost(0.0, 1.0);
  LoopProgram out;
  out.sum = sum;
  const auto entry = [&] { return cost(random) < 0.2 ? kInf : cost(random); };
  for (int c = 0; c < n; ++c) {
    out.direction_cost.push_back({entry(), entry(), entry(), entry()});
    out.type_cost.push_back({entry(), entry(), entry(), entry()});
  }
  return out;
}

TEST(LoopProgram, FindsWhatTryingEverythingFinds) {
  std::mt19937 random(7);
  int n_solved = 0;
  for (int round = 0; round < 300; ++round) {
    const int n = 1 + round % 6;
    const LoopProgram loop = random_loop(random, n, std::array{4, -4, 0}[round / 6 % 3]);
    const LoopMarginals expected = brute_force(loop), found = loop_marginals(loop);
    n_solved += expected.best < kInf;
    if (expected.best == kInf)
      EXPECT_EQ(found.best, kInf);
    else
      EXPECT_NEAR(found.best, expected.best, 1e-12);
    for (int c = 0; c < n; ++c)
      for (int d = 0; d < 4; ++d)
        if (expected.marginal[c][d] == kInf)
          EXPECT_EQ(found.marginal[c][d], kInf);
        else
          EXPECT_NEAR(found.marginal[c][d], expected.marginal[c][d], 1e-12);
  }
  EXPECT_GT(n_solved, 100);
}

TEST(LoopProgram, EmptyLoopCannotBe) {
  EXPECT_EQ(loop_marginals({}).best, kInf);
}

TEST(LoopProgram, RectangleHasFourEndsInAnyRotation) {
  LoopProgram loop;
  for (int c = 0; c < 4; ++c) {
    loop.direction_cost.push_back({0, 0, 0, 0});
    loop.type_cost.push_back(corner_costs(kQuarterTurn, {}));
  }
  const LoopMarginals found = loop_marginals(loop);
  EXPECT_NEAR(found.best, 0.0, 1e-12);
  for (const auto& marginal : found.marginal)
    for (double cost : marginal) EXPECT_NEAR(cost, 0.0, 1e-12);
}

/// A comb of many teeth: the cost of work must stay far from the square of the number of corners
/// times the types.
TEST(LoopProgram, LongLoopsAreCheap) {
  LoopProgram loop;
  for (int tooth = 0; tooth < 500; ++tooth)
    for (double angle : {1.0, 1.0, 3.0, 3.0}) {
      loop.direction_cost.push_back({0, 0, 0, 0});
      loop.type_cost.push_back(corner_costs(angle * kQuarterTurn, {}));
    }
  for (int corner = 0; corner < 4; ++corner) {
    loop.direction_cost.push_back({0, 0, 0, 0});
    loop.type_cost.push_back(corner_costs(kQuarterTurn, {}));
  }
  const LoopMarginals found = loop_marginals(loop);
  EXPECT_NEAR(found.best, 0.0, 1e-9);
  EXPECT_LT(found.work, 4'000'000);
}

}  // namespace
}  // namespace sweepmesh
