// Measures on plane polylines.
#include "sweepmesh/imprint/polyline.h"

#include <gtest/gtest.h>

namespace sweepmesh {
namespace {

const Polyline corner = {{0, 0}, {3, 0}, {3, 4}};

TEST(Polyline, ArcAndPositionAgree) {
  EXPECT_DOUBLE_EQ(length(corner), 7.0);
  for (const double arc : {0.0, 1.5, 3.0, 5.0, 7.0}) {
    const PolylinePoint p = at_arc(corner, arc);
    EXPECT_DOUBLE_EQ(p.arc, arc);
    EXPECT_DOUBLE_EQ(at_position(corner, p.position).arc, arc);
    EXPECT_NEAR((nearest(corner, p.point).point - p.point).norm(), 0.0, 1e-12);
  }
}

TEST(Polyline, PartsAddUp) {
  for (const double cut : {0.3, 1.0, 1.6})
    EXPECT_NEAR(length(part(corner, 0.0, cut)) + length(part(corner, cut, 2.0)), 7.0, 1e-12);
}

TEST(Polyline, MovedEndsKeepAStraightLineStraight) {
  const Polyline moved = with_ends({{0, 0}, {1, 0}, {2, 0}, {4, 0}}, {0, 1}, {4, 3});
  for (const Point2& p : moved) EXPECT_NEAR(p.y(), 1.0 + p.x() / 2, 1e-12);
}

TEST(Polyline, ResamplingKeepsCornersAndSpacing) {
  const auto points = resampled(corner, 0.4);
  bool has_corner = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    has_corner |= points[i].point == corner[1];
    if (i > 0) {
      EXPECT_LE(points[i].arc - points[i - 1].arc, 0.4 + 1e-12);
    }
  }
  EXPECT_TRUE(has_corner);
}

}  // namespace
}  // namespace sweepmesh
