// Mean value interpolation: exact on the boundary, affine maps exact everywhere.
#include "sweepmesh/imprint/mean_value_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sweepmesh {
namespace {

const Polyline square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
const Polyline hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};

Point2 affine(const Point2& p) {
  return {1.0 + 2.0 * p.x() - p.y(), 0.5 * p.x() + 3.0 * p.y()};
}

TEST(MeanValueField, AffineMapsAreExactInsideAndOutside) {
  MeanValueField field(1e-9);
  for (const Polyline& line : {square, hole}) {
    Polyline to = line;
    for (Point2& p : to) p = affine(p);
    field.add(line, to);
  }
  for (const Point2& p : {Point2(0.5, 0.5), Point2(3, 3), Point2(1.5, 1.5), Point2(9, -4)})
    EXPECT_NEAR((field(p) - affine(p)).norm(), 0.0, 1e-9) << p.transpose();
  EXPECT_DOUBLE_EQ(field.double_area(), 30.0);
}

TEST(MeanValueField, TheBoundaryIsInterpolated) {
  MeanValueField field(1e-9);
  field.add(square, {{0, 0}, {4, 1}, {5, 5}, {-1, 4}, {0, 0}});
  EXPECT_NEAR((field({2, 0}) - Point2(2, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((field({2, 1e-7}) - Point2(2, 0.5)).norm(), 0.0, 1e-5);
  EXPECT_DOUBLE_EQ(field.distance({2, 1}), 1.0);
}

TEST(MeanValueField, WithoutABoundaryNothingMoves) {
  EXPECT_EQ(MeanValueField(1e-9)({3, 4}), Point2(3, 4));
}

}  // namespace
}  // namespace sweepmesh
