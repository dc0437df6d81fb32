// Which angles an edge may have for its type, by how its faces bend.
#include "sweepmesh/scheme/limits.h"

#include <gtest/gtest.h>

namespace sweepmesh {
namespace {

constexpr double kDegree = kQuarterTurn / 90;

bool allowed(double degrees, Bend bend, VertexType type, const AngleLimits& limits) {
  return is_edge_allowed(degrees * kDegree, degrees * kDegree, bend, type, limits);
}

TEST(Limits, strict_ones_take_no_tangent_rim) {
  for (const Bend bend : {Bend::none, Bend::outwards, Bend::inwards})
    for (const VertexType type : {VertexType::end, VertexType::corner})
      EXPECT_FALSE(allowed(180, bend, type, strict_limits()));
}

TEST(Limits, rims_may_be_tangent_where_the_boundary_bends_their_way) {
  const AngleLimits limits = tangent_limits();
  EXPECT_TRUE(allowed(180, Bend::outwards, VertexType::end, limits));
  EXPECT_TRUE(allowed(180, Bend::inwards, VertexType::corner, limits));
  EXPECT_FALSE(allowed(180, Bend::inwards, VertexType::end, limits));
  EXPECT_FALSE(allowed(180, Bend::outwards, VertexType::corner, limits));
  EXPECT_FALSE(allowed(180, Bend::none, VertexType::end, limits));
  EXPECT_FALSE(allowed(180, Bend::none, VertexType::corner, limits));
}

TEST(Limits, tangent_ones_are_strict_elsewhere) {
  for (int degrees = 6; degrees < 355; degrees += 4)
    EXPECT_EQ(allowed(degrees, Bend::none, VertexType::side, strict_limits()),
              allowed(degrees, Bend::none, VertexType::side, tangent_limits()))
        << degrees;
}

TEST(Limits, lenient_ones_take_more_than_any_others) {
  for (const Bend bend : {Bend::none, Bend::outwards, Bend::inwards})
    for (const VertexType type : {VertexType::end, VertexType::side, VertexType::corner})
      for (int degrees = 6; degrees < 355; degrees += 4)
        for (const AngleLimits& limits : {strict_limits(), tangent_limits(), radial_limits()})
          EXPECT_LE(allowed(degrees, bend, type, limits),
                    allowed(degrees, bend, type, lenient_limits()))
              << degrees;
}

}  // namespace
}  // namespace sweepmesh
