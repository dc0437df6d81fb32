#include "sweepmesh/scheme/counts.h"

#include <algorithm>
#include <map>

#include "sweepmesh/numerics/lp/integer_program.h"

namespace sweepmesh {

namespace {

/// Edge (SweepProblem index) to the number of times that a loop runs along it, -i counted negative.
using Balance = std::map<int, int>;

struct LoopBalance {
  Balance balance;
  int turning = 0;  ///< sum of the types, in quarter turns
};

LoopBalance balance_of(const Network& n, const Choices& choices, const ProblemLoop& loop) {
  LoopBalance out;
  for (int c = loop.first; c < loop.first + loop.count; ++c) {
    const int d = first_state(choices.domain[c]),
              next = first_state(choices.domain[n.problem.next(c)]);
    const int turn = ((next - d) % 4 + 4) % 4;
    out.turning += turn >= 2 ? turn - 4 : turn;
    if (d == static_cast<int>(Direction::plus_i)) ++out.balance[n.problem.coedges[c].edge];
    if (d == static_cast<int>(Direction::minus_i)) --out.balance[n.problem.coedges[c].edge];
  }
  return out;
}

/// One balance a loop; those of the two loops of an annulus are one.
void add_balances(const Network& n, const Choices& choices, int face, std::vector<Balance>& out) {
  Balance around;
  for (const ProblemLoop& loop : n.problem.faces[face].loops) {
    const LoopBalance own = balance_of(n, choices, loop);
    if (own.turning != 0)
      out.push_back(own.balance);
    else
      for (const auto& [edge, times] : own.balance) around[edge] += times;
  }
  if (!around.empty()) out.push_back(around);
}

bool is_met_by_ones(const std::vector<Balance>& balances) {
  return std::ranges::all_of(balances, [](const Balance& balance) {
    int sum = 0;
    for (const auto& [edge, times] : balance) sum += times;
    return sum == 0;
  });
}

}  // namespace

bool do_counts_exist(const Network& network, const Choices& choices, Context& context) {
  std::vector<Balance> balances;
  for (int f : all_faces(network))
    if (choices.role[f] == kLinkingStates) add_balances(network, choices, f, balances);
  if (is_met_by_ones(balances)) return true;
  IntegerProgram program;
  std::map<int, int> variable;
  for (const Balance& balance : balances) {
    IntegerProgram::Row row{{}, Sense::equal, 0.0, {}};
    for (const auto& [edge, times] : balance) {
      if (!variable.contains(edge))
        variable[edge] = program.add_variable({1.0, unbounded, false, 1.0, {}});
      row.terms.push_back({variable[edge], static_cast<double>(times)});
    }
    program.add_row(row);
  }
  return solve(program, {}, context).status != SolveStatus::infeasible;
}

}  // namespace sweepmesh
