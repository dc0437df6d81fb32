// The excess of a scheme counts what is beyond the strict limits, and nothing else.
#include "sweepmesh/scheme/strain.h"

#include <gtest/gtest.h>

#include "scheme_solids.h"
#include "sweepmesh/scheme/graded_search.h"

namespace sweepmesh {
namespace {

double least_excess(const Model& model, const std::vector<Pick>& picks) {
  Context context;
  SearchBudget budget;
  const Network network = make_network(sweep_problem(model, context), lenient_limits());
  const auto found = graded_search(network, picks, budget, context).divisions;
  return found.empty() ? -1.0 : excess_of(model, network, found.front());
}

TEST(Strain, RightAnglesHaveNone) {
  EXPECT_DOUBLE_EQ(least_excess(test::box(1, 2, 3), {}), 0.0);
}

TEST(Strain, FacesForcedToBeSourcesHaveSomeOrNone) {
  const double least = 4.0 / 9.0;  // 60 degrees, squared, in quarter turns
  int n_strained = 0;
  for (const Model& model : {test::slanted_block(), test::dovetail(), test::mitred_tube()})
    for (const FaceId a : model.faces())
      for (const FaceId b : model.faces()) {
        if (a == b) continue;
        const double excess = least_excess(model, {{a, kSourceStates}, {b, kSourceStates}});
        if (excess <= 0.0) continue;
        EXPECT_GE(excess, least);
        ++n_strained;
      }
  EXPECT_GT(n_strained, 0);
}

}  // namespace
}  // namespace sweepmesh
