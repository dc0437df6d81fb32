// The search against an integer program for the same rules, and the conditions that single faces
// cannot tell.
#include <gtest/gtest.h>

#include <cmath>

#include "scheme_solids.h"
#include "sweepmesh/numerics/lp/integer_program.h"
#include "sweepmesh/scheme/counts.h"
#include "sweepmesh/scheme/levels.h"
#include "sweepmesh/scheme/prismatic.h"
#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/walled.h"

namespace sweepmesh {
namespace {

constexpr std::array kTypes = {1, 0, -1, -2};

/// The cheapest states for given roles as one integer program: a binary for each state of a coedge,
/// each meeting of two states at an edge and each type at a corner. For solids whose faces have one
/// loop (no frames, no annuli).
class StateProgram {
 public:
  StateProgram(const Network& n, const std::vector<StateSet>& roles) : n_(n), roles_(roles) {
    for (std::size_t c = 0; c < n.problem.coedges.size(); ++c) add_states(static_cast<int>(c));
    for (std::size_t e = 0; e < n.problem.edges.size(); ++e) add_edge(static_cast<int>(e));
    for (std::size_t f = 0; f < n.problem.faces.size(); ++f)
      if (roles[f] == kLinkingStates) add_corners(static_cast<int>(f));
  }

  double least_cost() const {
    Context context;
    const Solution solution = solve(program_, {}, context);
    if (solution.status == SolveStatus::infeasible) return kImpossible;
    double out = solution.objective;
    for (StateSet role : roles_) out += role == kLinkingStates ? 0.0 : n_.preferences.per_cap;
    return out;
  }

 private:
  int binary(double cost) { return program_.add_variable({0.0, 1.0, true, cost, {}}); }

  void add_states(int c) {
    IntegerProgram::Row one{{}, Sense::equal, 1.0, {}};
    state_.push_back({-1, -1, -1, -1, -1, -1});
    for (int s = 0; s < kStates; ++s)
      if (has(roles_[n_.problem.coedges[c].face], s))
        one.terms.push_back({state_[c][s] = binary(0.0), 1.0});
    program_.add_row(one);
  }

  void add_edge(int e) {
    const auto [c0, c1] = n_.problem.edges[e].coedge;
    IntegerProgram::Row one{{}, Sense::equal, 1.0, {}};
    for (int a = 0; a < kStates; ++a)
      for (int b = 0; b < kStates; ++b) {
        if (state_[c0][a] < 0 || state_[c1][b] < 0 || n_.pair[e][a][b] == kImpossible) continue;
        const int meeting = binary(n_.pair[e][a][b]);
        one.terms.push_back({meeting, 1.0});
        program_.add_row({{{meeting, 1.0}, {state_[c0][a], -1.0}}, Sense::less_equal, 0.0, {}});
        program_.add_row({{{meeting, 1.0}, {state_[c1][b], -1.0}}, Sense::less_equal, 0.0, {}});
      }
    program_.add_row(one);
  }

  void add_corners(int f) {
    const ProblemLoop& loop = n_.problem.faces[f].loops.front();
    IntegerProgram::Row sum{{}, Sense::equal, 4.0, {}};
    for (int c = loop.first; c < loop.first + loop.count; ++c) {
      IntegerProgram::Row one{{}, Sense::equal, 1.0, {}};
      for (int t = 0; t < 4; ++t) {
        if (n_.corner[c][t] == kImpossible) continue;
        const int type = binary(n_.corner[c][t]);
        one.terms.push_back({type, 1.0});
        sum.terms.push_back({type, static_cast<double>(kTypes[t])});
        for (int d = 0; d < 4; ++d) {  // state d here and type t: state d + t at the next
          const int next = state_[n_.problem.next(c)][((d + kTypes[t]) % 4 + 4) % 4];
          program_.add_row(
              {{{type, 1.0}, {state_[c][d], 1.0}, {next, -1.0}}, Sense::less_equal, 1.0, {}});
        }
      }
      program_.add_row(one);
    }
    program_.add_row(sum);
  }

  const Network& n_;
  const std::vector<StateSet>& roles_;
  IntegerProgram program_;
  std::vector<std::array<int, kStates>> state_;
};

Network network_of(const Model& model) {
  Context context;
  return make_network(sweep_problem(model, context), lenient_limits());
}

TEST(Network, SearchAgreesWithTheIntegerProgram) {
  std::vector<test::NamedModel> solids = test::general_one_to_one();
  for (auto& solid : test::prisms()) solids.push_back(solid);
  for (auto& solid : test::many_to_one()) solids.push_back(solid);
  int n_compared = 0;
  for (const auto& [name, model] : solids) {
    const Network network = network_of(model);
    SearchOptions options;
    options.max_cost = 12.0;
    Context context;
    for (const Division& d :
         search_divisions(network, open_choices(network), options, context).divisions) {
      const bool is_simple = std::ranges::all_of(all_faces(network), [&](int f) {
        return d.choices.role[f] != kLinkingStates || network.problem.faces[f].loops.size() == 1;
      });
      if (!is_simple || network.problem.faces.size() > 10) continue;
      EXPECT_NEAR(StateProgram(network, d.choices.role).least_cost(), d.cost, 1e-6) << name;
      ++n_compared;
    }
  }
  EXPECT_GT(n_compared, 15);
}

TEST(Network, BoundNeverExceedsTheCost) {
  for (const auto& [name, model] : test::many_to_one()) {
    const Network network = network_of(model);
    Choices choices = open_choices(network);
    long effort = 0;
    Context context;
    ASSERT_FALSE(propagate(network, kImpossible, all_faces(network), choices, effort, context));
    SearchOptions options;
    options.max_cost = 12.0;
    for (const Division& d :
         search_divisions(network, open_choices(network), options, context).divisions) {
      EXPECT_LE(choices.bound, d.cost + 1e-9) << name;
      for (std::size_t c = 0; c < d.choices.domain.size(); ++c)
        EXPECT_EQ(d.choices.domain[c] & ~choices.domain[c], 0) << name;
    }
  }
}

Division best_of(const Network& network) {
  Context context;
  SearchOptions options;
  options.max_cost = 4.0;
  auto result = search_divisions(network, open_choices(network), options, context);
  EXPECT_FALSE(result.divisions.empty());
  return result.divisions.front();
}

TEST(Prismatic, GuessesTheAxisOfEveryPrism) {
  for (const auto& [name, model] : test::prisms()) {
    const Network network = network_of(model);
    Context context;
    const auto guessed = prismatic_divisions(network, context);
    ASSERT_FALSE(guessed.empty()) << name;
    EXPECT_NEAR(guessed.front().cost, best_of(network).cost, 1e-9) << name;
    for (const Division& d : guessed) EXPECT_TRUE(level_groups(network, d.choices)) << name;
  }
}

TEST(Walled, SidesOfAWallNeverMeet) {
  int n_found = 0;
  for (const auto& family : {test::prisms(), test::many_to_one(), test::drilled_across()})
    for (const auto& [name, model] : family) {
      const Network network = make_network(sweep_problem(model, {}), radial_limits());
      Context context;
      for (const Division& d : walled_divisions(network, context)) {
        ++n_found;
        EXPECT_TRUE(level_groups(network, d.choices)) << name;
        for (const ProblemEdge& e : network.problem.edges) {
          const auto role = [&](int side) {
            return d.choices.role[network.problem.coedges[e.coedge[side]].face];
          };
          EXPECT_NE(role(0) | role(1), kSourceStates | kTargetStates) << name;
        }
      }
    }
  EXPECT_GT(n_found, 0);
}

TEST(Levels, AxialCycleIsFound) {
  const Network network = network_of(test::box(1, 1, 1));
  Choices choices = best_of(network).choices;
  ASSERT_TRUE(level_groups(network, choices));
  EXPECT_EQ(level_groups(network, choices)->n_groups, 2);
  // One wall upside down: it rises where its neighbours fall.
  const auto wall = std::ranges::find(choices.role, kLinkingStates) - choices.role.begin();
  const int first = network.problem.first_coedge(static_cast<int>(wall));
  for (int c = first; c < first + 4; ++c) {
    const int s = first_state(choices.domain[c]);
    choices.domain[c] = StateSet(1 << (s + 2) % 4);
  }
  EXPECT_FALSE(level_groups(network, choices));
}

TEST(Levels, ShellsThatAreCapsMustBeTwoOppositeOnes) {
  const Network two = network_of(test::hollow_ball(2));
  Choices choices = open_choices(two);
  choices.role = {kSourceStates, kTargetStates, kTargetStates};
  EXPECT_FALSE(has_both_ends(two, choices));
  const Network one = network_of(test::hollow_ball(1));
  choices = open_choices(one);
  choices.role = {kSourceStates, kTargetStates};
  EXPECT_TRUE(has_both_ends(one, choices));
  choices.role = {kSourceStates, kSourceStates};
  EXPECT_FALSE(has_both_ends(one, choices));
}

TEST(Levels, EulerCharacteristicsOfSourcesAndTargetsBalance) {
  for (const auto& [name, model] : test::many_to_one()) {
    const Network network = network_of(model);
    Division best = best_of(network);
    EXPECT_TRUE(is_euler_balanced(network, best.choices)) << name;
  }
  // A ball and a torus for its inner wall: spheres and rings do not balance. Taken from a ring,
  // where a source lost its hole.
  const auto prisms = test::prisms();
  const Model& ring = std::ranges::find(prisms, "ring", &test::NamedModel::name)->model;
  Network network = network_of(ring);
  Choices choices = best_of(network).choices;
  ASSERT_TRUE(is_euler_balanced(network, choices));
  const auto source = std::ranges::find(choices.role, kSourceStates) - choices.role.begin();
  network.problem.faces[source].loops.resize(1);
  EXPECT_FALSE(is_euler_balanced(network, choices));
}

TEST(Counts, ExistForEveryDivisionThatIsFound) {
  Context context;
  for (const auto& [name, model] : test::many_to_one()) {
    const Network network = network_of(model);
    EXPECT_TRUE(do_counts_exist(network, best_of(network).choices, context)) << name;
  }
}

/// A face whose two long sides are one edge each way, but which shares them crosswise with itself:
/// n = n + m.
TEST(Counts, AreDeniedWhereEdgesWouldNeedNone) {
  Network network;
  SweepProblem& p = network.problem;
  p.faces.resize(1);
  p.faces[0].loops = {{0, 5}};
  p.edges.resize(4);
  const std::vector<std::pair<int, Direction>> sides = {{0, Direction::plus_i},
                                                        {1, Direction::plus_i},
                                                        {2, Direction::plus_k},
                                                        {0, Direction::minus_i},
                                                        {3, Direction::minus_k}};
  Choices choices;
  choices.role = {kLinkingStates};
  for (const auto& [edge, direction] : sides) {
    ProblemCoedge coedge;
    coedge.face = coedge.loop = 0;
    coedge.edge = edge;
    p.coedges.push_back(coedge);
    choices.domain.push_back(StateSet(1 << static_cast<int>(direction)));
  }
  Context context;
  EXPECT_FALSE(do_counts_exist(network, choices, context));
}

}  // namespace
}  // namespace sweepmesh
