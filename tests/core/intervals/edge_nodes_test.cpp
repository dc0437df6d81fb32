#include "sweepmesh/intervals/edge_nodes.h"

#include <gtest/gtest.h>

#include "solids.h"

namespace sweepmesh {
namespace {

TEST(BiasedFractions, StepsGrowByTheRatio) {
  for (const double ratio : {0.5, 1.0, 1.3}) {
    const auto at = biased_fractions(6, {ratio, false});
    ASSERT_EQ(at.size(), 7u);
    EXPECT_EQ(at.front(), 0.0);
    EXPECT_EQ(at.back(), 1.0);
    for (int s = 1; s < 6; ++s)
      EXPECT_NEAR((at[s + 1] - at[s]) / (at[s] - at[s - 1]), ratio, 1e-12);
  }
}

TEST(BiasedFractions, SymmetricIsItsOwnMirrorImage) {
  for (const int n : {1, 2, 5, 8}) {
    const auto at = biased_fractions(n, {1.4, true});
    for (int s = 0; s <= n; ++s) EXPECT_NEAR(at[s] + at[n - s], 1.0, 1e-12);
  }
}

TEST(EdgeNodes, EqualStepsAlongACircle) {
  const Model model = testing::model_of(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape());
  Intervals intervals;
  intervals.edge.assign(model.n_edges(), 7);
  const EdgeNodes nodes = place_edge_nodes(model, intervals, {});
  for (const EdgeId e : model.edges()) {
    const auto& t = nodes.t[e.index];
    ASSERT_EQ(t.size(), 8u);
    EXPECT_EQ(t.front(), model.range(e).first);
    EXPECT_EQ(t.back(), model.range(e).second);
    const double first = (model.point(e, t[1]) - model.point(e, t[0])).norm();
    for (int s = 1; s < 7; ++s)
      EXPECT_NEAR((model.point(e, t[s + 1]) - model.point(e, t[s])).norm(), first, 1e-6);
  }
}

TEST(EdgeNodes, BiasOnOneEdgeLeavesTheOthersEven) {
  const Model model = testing::model_of(testing::box(4, 4, 4));
  Intervals intervals;
  intervals.edge.assign(model.n_edges(), 4);
  IntervalOptions options;
  const EdgeId graded = model.edges()[3];
  options.edge_bias[graded] = {2.0, false};
  const EdgeNodes nodes = place_edge_nodes(model, intervals, options);
  for (const EdgeId e : model.edges()) {
    const auto& t = nodes.t[e.index];
    const double ratio = (model.point(e, t[2]) - model.point(e, t[1])).norm() /
                         (model.point(e, t[1]) - model.point(e, t[0])).norm();
    EXPECT_NEAR(ratio, e == graded ? 2.0 : 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace sweepmesh
