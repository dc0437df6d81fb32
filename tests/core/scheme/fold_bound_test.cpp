// How far holes wind, of sections made from known motions.
#include "sweepmesh/scheme/fold_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace sweepmesh {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kLayers = 16;

using Motion = std::function<Point3(const Point3&, double)>;  ///< of a point, at 0..1

Point3 turned(const Point3& p, double angle) {
  return Eigen::AngleAxisd(angle, Point3::UnitZ()) * p;
}

/// A ring of columns around `centre`, clockwise for a hole, that goes up by 60 and moves besides.
WallRing ring(double radius, const Point3& centre, bool is_hole, int first, const Motion& motion,
              double from = 0.0, double to = 1.0) {
  constexpr int n = 16;
  WallRing out;
  out.layers.resize(kLayers + 1);
  for (int j = 0; j < n; ++j) {
    const double a = (is_hole ? -1 : 1) * 2 * std::numbers::pi * j / n;
    out.columns.push_back(first + j);
    out.face.emplace_back(first);
    const Point3 p = centre + radius * Point3(std::cos(a), std::sin(a), 0.0);
    for (int k = 0; k <= kLayers; ++k) {
      const double t = from + (to - from) * k / kLayers;
      out.layers[k].push_back(motion(p, t) + 60.0 * t * Point3::UnitZ());
    }
  }
  return out;
}

Point3 still(const Point3& p, double) {
  return p;
}

WallRing outer(const Motion& motion = still, double from = 0.0, double to = 1.0) {
  return ring(40.0, Point3::Zero(), false, 0, motion, from, to);
}

/// A hole around `centre` that turns around itself.
WallRing spinning(double angle, const Point3& centre, int first = 100, double from = 0.0,
                  double to = 1.0) {
  const Motion motion = [=](const Point3& p, double t) -> Point3 {
    return centre + turned(p - centre, angle * t);
  };
  return ring(8.0, centre, true, first, motion, from, to);
}

/// A hole that goes around the middle without turning itself.
WallRing going_round(double angle, const Point3& centre, int first) {
  return ring(5.0, centre, true, first, [=](const Point3& p, double t) -> Point3 {
    return p - centre + turned(centre, angle * t);
  });
}

double degrees(const std::vector<WallSection>& sections) {
  return largest_winding(sections).angle / kDegree;
}

double degrees(WallRing wall, std::vector<WallRing> holes) {
  return degrees({{0, kLayers, std::move(wall), std::move(holes)}});
}

TEST(FoldBound, turns_of_a_hole_are_counted_whole) {
  for (const double angle : {0.0, 30.0, -170.0, 190.0, 360.0, -500.0})
    for (const double x : {0.0, 20.0})
      EXPECT_NEAR(degrees(outer(), {spinning(angle * kDegree, {x, 0, 0})}), std::abs(angle), 1e-6);
}

TEST(FoldBound, what_turns_as_a_whole_does_not_wind) {
  for (const double angle : {90.0, 300.0, -700.0}) {
    const Motion all = [&](const Point3& p, double t) { return turned(p, angle * kDegree * t); };
    const auto hole = [&](double x, int first) { return ring(6.0, {x, 5, 0}, true, first, all); };
    EXPECT_NEAR(degrees(outer(all), {hole(15, 100), hole(-15, 200)}), 0.0, 1e-6);
  }
}

TEST(FoldBound, bends_and_growth_do_not_wind) {
  const Motion bend = [](const Point3& p, double t) -> Point3 {
    const double a = 2.5 * t;
    const Point3 grown = (1.0 + t) * p;
    const double r = 120.0 - grown.x();
    return {120.0 - r * std::cos(a), grown.y(), r * std::sin(a) - 60.0 * t};
  };
  EXPECT_NEAR(degrees(outer(bend), {ring(6.0, {15, 5, 0}, true, 100, bend)}), 0.0, 3.0);
}

TEST(FoldBound, a_still_hole_winds_in_an_outer_wall_that_turns) {
  const Motion turn = [](const Point3& p, double t) { return turned(p, 250 * kDegree * t); };
  EXPECT_NEAR(degrees(outer(turn), {spinning(0.0, Point3::Zero())}), 250.0, 1e-6);
}

TEST(FoldBound, two_holes_wind_around_each_other) {
  for (const double angle : {40.0, 220.0, -400.0}) {
    const double a = angle * kDegree;
    const auto sections = std::vector<WallSection>{
        {0, kLayers, outer(), {going_round(a, {15, 0, 0}, 100), going_round(a, {-15, 0, 0}, 200)}}};
    const Winding winding = largest_winding(sections);
    EXPECT_NEAR(winding.angle / kDegree, std::abs(angle), 1e-6);
    EXPECT_TRUE(winding.is_of_two);
    EXPECT_EQ(winding.faces, (std::vector<FaceId>{FaceId{100}, FaceId{200}}));
  }
}

TEST(FoldBound, one_hole_that_goes_round_does_not_wind) {
  EXPECT_NEAR(degrees(outer(), {going_round(2 * std::numbers::pi, {15, 0, 0}, 100)}), 0.0, 1e-6);
}

TEST(FoldBound, winding_adds_up_over_slabs) {
  const auto slab = [](double from, double to) {
    return WallSection{
        0, 1, outer(still, from, to), {spinning(280 * kDegree, Point3::Zero(), 100, from, to)}};
  };
  EXPECT_NEAR(degrees({slab(0.0, 0.5)}), 140.0, 1e-6);
  EXPECT_NEAR(degrees({slab(0.0, 0.3), slab(0.3, 0.8), slab(0.8, 1.0)}), 280.0, 1e-6);
}

TEST(FoldBound, other_holes_above_do_not_add_up) {
  const auto slab = [](double from, double to, int first) {
    return WallSection{
        0, 1, outer(still, from, to), {spinning(280 * kDegree, Point3::Zero(), first, from, to)}};
  };
  EXPECT_NEAR(degrees({slab(0.0, 0.5, 100), slab(0.5, 1.0, 200)}), 140.0, 1e-6);
}

TEST(FoldBound, nothing_is_said_where_layers_turn_too_fast) {
  EXPECT_EQ(degrees(outer(), {spinning(70 * kLayers * kDegree, Point3::Zero())}), 0.0);
}

TEST(FoldBound, nothing_is_said_where_the_outer_ring_keeps_no_shape) {
  const Motion squeeze = [](const Point3& p, double t) -> Point3 {
    return {p.x() * (1 + 3 * t), p.y() * (1 - 0.9 * t), p.z()};
  };
  EXPECT_EQ(degrees(outer(squeeze), {spinning(250 * kDegree, Point3::Zero())}), 0.0);
}

TEST(FoldBound, nothing_is_said_of_a_hole_that_lies_over) {
  const Motion lie_over = [](const Point3& p, double t) -> Point3 {
    return Eigen::AngleAxisd(150 * kDegree * std::sin(std::numbers::pi * t), Point3::UnitY()) * p;
  };
  EXPECT_EQ(degrees(outer(), {ring(6.0, Point3::Zero(), true, 100, lie_over)}), 0.0);
}

TEST(FoldBound, without_holes_nothing_winds) {
  EXPECT_EQ(degrees(outer(), {}), 0.0);
  EXPECT_EQ(degrees(std::vector<WallSection>{}), 0.0);
}

TEST(WallSections, holes_go_to_the_smallest_ring_around_them) {
  const auto at = [](double x, double radius, bool is_hole, int first) {
    return ring(radius, {x, 0, 0}, is_hole, first, still);
  };
  // Two parts, one within the hole of the other, and a hole in each; one hole in neither.
  const auto sections =
      joined_to_sections(0, kLayers,
                         {at(0, 5, true, 1), at(0, 40, false, 2), at(0, 20, true, 3),
                          at(0, 10, false, 4), at(90, 5, true, 5)});
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].outer.columns.front(), 2);
  ASSERT_EQ(sections[0].holes.size(), 1u);
  EXPECT_EQ(sections[0].holes.front().columns.front(), 3);
  EXPECT_EQ(sections[1].outer.columns.front(), 4);
  ASSERT_EQ(sections[1].holes.size(), 1u);
  EXPECT_EQ(sections[1].holes.front().columns.front(), 1);
}

}  // namespace
}  // namespace sweepmesh
