// The tree of boxes answers as the walk along the whole line does.
#include "sweepmesh/imprint/nearest_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace sweepmesh {
namespace {

Polyline random_line(int n, std::mt19937& random) {
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  Polyline line = {Point2(0, 0)};
  for (int i = 1; i < n; ++i) line.push_back(line.back() + Point2(step(random), step(random)));
  return line;
}

void expect_same(const Polyline& line, const Point2& p) {
  const NearestSearch nearest_on(line);
  const PolylinePoint found = nearest_on(p), expected = nearest(line, p);
  EXPECT_DOUBLE_EQ(found.position, expected.position) << p.transpose();
  EXPECT_DOUBLE_EQ(found.distance, expected.distance);
  EXPECT_NEAR((found.point - expected.point).norm(), 0.0, 1e-12);
  EXPECT_NEAR(found.arc, expected.arc, 1e-9);
}

TEST(NearestSearch, AgreesWithTheWalkOnLinesOfAllLengths) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  for (const int n : {2, 3, 5, 6, 17, 100, 1000}) {
    const Polyline line = random_line(n, random);
    for (int i = 0; i < 50; ++i) expect_same(line, {place(random), place(random)});
    for (const Point2& p : {line.front(), line[line.size() / 2], line.back()}) expect_same(line, p);
  }
}

TEST(NearestSearch, OfPlacesEquallyNearTheFirstCounts) {
  const Polyline there_and_back = {{0, 0}, {4, 0}, {8, 0}, {4, 0}, {0, 0}, {4, 0}, {8, 0}};
  for (const double x : {-1.0, 1.0, 4.0, 6.0, 9.0}) expect_same(there_and_back, {x, 1.0});
}

TEST(NearestSearch, SegmentsWithoutLengthDoNoHarm) {
  const Polyline line(20, Point2(1, 2));
  EXPECT_DOUBLE_EQ(NearestSearch(line)({4, 6}).distance, 5.0);
}

}  // namespace
}  // namespace sweepmesh
