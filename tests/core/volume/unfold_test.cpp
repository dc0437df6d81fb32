#include "sweepmesh/volume/unfold.h"

#include <gtest/gtest.h>

#include <random>

#include "solids.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/volume/element_check.h"

namespace sweepmesh {
namespace {

using namespace testing;

struct Block {
  Solid solid = make_solid(make_grid(8, 8), 4,
                           [](double x, double y, double w) { return Point3(x, y, 4 * w); });
  std::vector<SlidingNode> sliding;  ///< inside the upper cap
  Points points = solid.exact;
  ThreadTeam team;

  Block() {
    for (int c = 0; c < solid.extrusion.n_columns(); ++c) {
      const long node = solid.extrusion.node(c, 4);
      if (!solid.fixed[node - 1]) sliding.push_back({node, Point3(0, 0, 1)});
    }
  }

  void unfold() {
    const BaseMetric metric = make_base_metric(solid.extrusion, solid.fixed, solid.exact, team);
    unfold_inverted(solid.extrusion, metric, solid.fixed, sliding, 5, inverted(), points, team, {});
  }
  std::vector<long> inverted() {
    return check_elements(solid.extrusion, points, kDegenerate, team).bad;
  }
};

TEST(Unfold, LeavesSlidingNodesWhereInnerNodesWillDo) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Block block;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-0.8, 0.8);
    for (long n = 0; n < block.points.rows(); ++n)
      if (!block.solid.fixed[n])
        for (int d = 0; d < 3; ++d) block.points(n, d) += uniform(random);
    EXPECT_FALSE(block.inverted().empty());
    block.unfold();
    EXPECT_TRUE(block.inverted().empty());
    for (const SlidingNode& s : block.sliding)
      EXPECT_EQ(Point3(block.points.row(s.node)), Point3(block.solid.exact.row(s.node)));
  }
}

TEST(Unfold, SlidesNodesWhereTheCapItselfIsFolded) {
  Block block;
  const long a = block.solid.extrusion.node(40, 4), b = block.solid.extrusion.node(41, 4);
  block.points.row(a).swap(block.points.row(b));
  block.unfold();
  EXPECT_TRUE(block.inverted().empty());
  for (const SlidingNode& s : block.sliding) EXPECT_NEAR(block.points(s.node, 2), 4.0, 1e-12);
}

TEST(Unfold, NamesElementsThatAFixedBoundaryInverts) {
  Block block;
  block.sliding.clear();
  const long a = block.solid.extrusion.node(40, 4), b = block.solid.extrusion.node(41, 4);
  block.points.row(a).swap(block.points.row(b));
  const std::vector<long> inverted = block.inverted();
  try {
    block.unfold();
    FAIL() << "No error.";
  } catch (const InvalidMeshError& e) {
    EXPECT_EQ(e.stage(), "place");
    EXPECT_FALSE(e.elements().empty());
    for (const long element : e.elements())
      EXPECT_TRUE(std::ranges::binary_search(inverted, element));
  }
}

}  // namespace
}  // namespace sweepmesh
