#include "sweepmesh/scheme/reasons.h"

#include <gtest/gtest.h>

#include "scheme_solids.h"

namespace sweepmesh {
namespace {

SweepProblem problem_of(const Model& model) {
  Context context;
  return sweep_problem(model, context);
}

TEST(Reasons, EdgeOfOneFaceIsNamed) {
  SweepProblem problem = problem_of(test::box(1, 1, 1));
  EXPECT_TRUE(reasons_in_boundary(problem).empty());
  problem.coedges[problem.edges[4].coedge[0]].partner = -1;
  problem.edges[4].coedge[1] = -1;
  const auto reasons = reasons_in_boundary(problem);
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons.front().kind, ReasonKind::unsupported);
  EXPECT_EQ(reasons.front().entities, std::vector<std::string>{"Edge5"});
}

TEST(Reasons, SearchThatWasCutOffSaysSo) {
  Context context;
  const Network network = make_network(problem_of(test::box(1, 1, 1)), strict_limits());
  SearchOptions options;
  options.max_effort = 1;
  const SearchResult result = search_divisions(network, open_choices(network), options, context);
  EXPECT_FALSE(result.is_complete);
  ASSERT_TRUE(result.divisions.empty());
  const auto reasons = reasons_of_failure(network, result, context);
  ASSERT_FALSE(reasons.empty());
  EXPECT_EQ(reasons.front().kind, ReasonKind::unsupported);
}

TEST(Reasons, FaceWithoutARoleIsNamedWithItsNeighbours) {
  Context context;
  const Network network = make_network(problem_of(test::box(1, 1, 1)), strict_limits());
  SearchResult result;
  result.conflict = Conflict{0};
  const auto reasons = reasons_of_failure(network, result, context);
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons.front().kind, ReasonKind::topological);
  EXPECT_EQ(reasons.front().entities.front(), "Face1");
  EXPECT_EQ(reasons.front().entities.size(), 5u);
}

}  // namespace
}  // namespace sweepmesh
