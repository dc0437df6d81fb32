// Points inside a section are carried to another shape of its outline without folds, or not at all.
#include "sweepmesh/imprint/section_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

const Polyline square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}};
const Polyline hole = {{3, 3}, {3, 5}, {5, 5}, {5, 3}, {3, 3}};

Polyline moved(Polyline line, const std::function<Point2(const Point2&)>& map) {
  for (Point2& p : line) p = map(p);
  return line;
}

Point2 turned(const Point2& p, double angle) {
  const Point2 centre(4, 4), d = p - centre;
  return centre + Point2(std::cos(angle) * d.x() - std::sin(angle) * d.y(),
                         std::sin(angle) * d.x() + std::cos(angle) * d.y());
}

std::vector<OutlinePart> with_hole_turned(double angle) {
  return {{square, square}, {hole, moved(hole, [&](const Point2& p) { return turned(p, angle); })}};
}

const std::vector<Point2> inside = {{1, 1}, {6, 2}, {2, 6.5}, {4, 2}};

TEST(SectionMap, AffineMapsAreExact) {
  const auto affine = [](const Point2& p) {
    return Point2(1 + 2 * p.x() - 0.5 * p.y(), 0.3 * p.x() + 1.5 * p.y());
  };
  const std::vector<OutlinePart> loops = {{square, moved(square, affine)},
                                          {hole, moved(hole, affine)}};
  Context context;
  const auto harmonic = carried_harmonically(loops, inside, 1.0);
  ASSERT_TRUE(harmonic.has_value());
  const auto unfolded = carried_inside(loops, inside, 1.0, context);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_NEAR(((*harmonic)[i] - affine(inside[i])).norm(), 0.0, 1e-6);
    EXPECT_NEAR((unfolded[i] - affine(inside[i])).norm(), 0.0, 1e-6);
  }
}

TEST(SectionMap, TheHarmonicMapIsRefusedWhereItFolds) {
  EXPECT_TRUE(carried_harmonically(with_hole_turned(0.1), inside, 1.0).has_value());
  EXPECT_FALSE(carried_harmonically(with_hole_turned(1.2), inside, 1.0).has_value());
}

TEST(SectionMap, AnEarOfTheOutlineMayTurnInwards) {
  // Its tip has no neighbours but those on the outline: only a node on the chord can make way.
  const Polyline from = {{0, 0}, {2, -1.5}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
  const Polyline to = {{0, 0}, {2, 0.4}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
  Context context;
  EXPECT_NO_THROW(carried_inside({{from, to}}, {Point2(2, 3.5)}, 4.0, context));
}

TEST(SectionMap, CrossedOutlinesAreSeen) {
  EXPECT_FALSE(is_crossed(with_hole_turned(0.7), 1e-6));
  const Polyline bow = {{0, 0}, {8, 8}, {8, 0}, {0, 8}, {0, 0}};
  EXPECT_TRUE(is_crossed({{square, bow}}, 1e-6));
  const auto across = [](const Point2& p) { return Point2(p + Point2(4, 0)); };
  EXPECT_TRUE(is_crossed({{square, square}, {hole, moved(hole, across)}}, 1e-6));
  const Polyline touching = {{0, 0}, {8, 0}, {8, 8}, {4, 1e-9}, {0, 8}, {0, 0}};
  EXPECT_FALSE(is_crossed({{touching, touching}}, 1e-6));
}

TEST(SectionMap, AnOutlineThatDoesNotCloseIsRefused) {
  Context context;
  EXPECT_THROW(carried_inside({}, inside, 1.0, context), InvalidMeshError);
  EXPECT_THROW(carried_harmonically({}, inside, 1.0), InvalidMeshError);
}

}  // namespace
}  // namespace sweepmesh
