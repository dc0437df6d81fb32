// Paths of sweeps that turn: a profile moved along one becomes a straight prism.
#include "sweepmesh/imprint/sweep_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace sweepmesh {
namespace {

constexpr double pi = std::numbers::pi;

struct Curve {
  std::vector<Point3> points, tangents;
};

/// Along z up to the origin, around an arc of radius 30 in the plane of x and z, and straight on.
Curve bend(double angle) {
  Curve out;
  const auto add = [&](const Point3& p, const Point3& t) {
    out.points.push_back(p);
    out.tangents.push_back(t);
  };
  add({0, 0, -20}, {0, 0, 1});
  constexpr int n = 40;
  for (int i = 0; i <= n; ++i) {
    const double a = angle * i / n;
    add({30 - 30 * std::cos(a), 0, 30 * std::sin(a)}, {std::sin(a), 0, std::cos(a)});
  }
  const Point3 end = out.points.back(), along = out.tangents.back();
  add(end + 20 * along, along);
  return out;
}

/// Where a place of a profile (`across` the path, in and out of the arc's plane) comes to at a turn
/// of `a` around the arc.
Point3 moved(const Point2& across, double a) {
  const double r = 30 - across.x();
  return {30 - r * std::cos(a), across.y(), r * std::sin(a)};
}

/// Of two straightened points.
double apart_across(const Point3& a, const Point3& b) {
  return (a - b).head<2>().norm();
}

TEST(SweepPath, AProfileMovedAroundABendKeepsItsPlace) {
  for (const double angle : {pi / 3, pi / 2, pi, 1.3 * pi}) {
    const Curve c = bend(angle);
    const SweepPath path(c.points, c.tangents);
    for (const Point2& across : {Point2(0, 0), Point2(10, 3), Point2(-18, 0), Point2(-2, -15)}) {
      const Point3 first = path.straightened({across.x(), across.y(), -10});
      for (const double share : {0.0, 0.13, 0.5, 0.77, 1.0})
        EXPECT_LT(apart_across(path.straightened(moved(across, share * angle)), first), 3e-5);
    }
  }
}

TEST(SweepPath, HeightsGrowAlongIt) {
  const Curve c = bend(pi);
  const SweepPath path(c.points, c.tangents);
  double before = path.straightened({5, 2, -30}).z();
  for (const Point3& p : {Point3(5, 2, -20), Point3(5, 2, -1), moved({5, 2}, 0.4),
                          moved({5, 2}, 2.9), Point3(55, 2, -1), Point3(55, 2, -40)}) {
    const double here = path.straightened(p).z();
    EXPECT_GT(here, before);
    before = here;
  }
}

TEST(SweepPath, DistancesWithinASectionStay) {
  const Curve c = bend(pi / 2);
  const SweepPath path(c.points, c.tangents);
  const Point2 a(4, -3), b(-7, 9);
  EXPECT_NEAR(apart_across(path.straightened(moved(a, 0.7)), path.straightened(moved(b, 0.7))),
              (a - b).norm(), 1e-5);
}

TEST(SweepPath, TurnsWithTheSolid) {
  const Curve c = bend(pi / 2);
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  Curve turned = c;
  for (Point3& p : turned.points) p = turn * p;
  for (Point3& t : turned.tangents) t = turn * t;
  const SweepPath path(c.points, c.tangents), other(turned.points, turned.tangents);
  const Point3 p = moved({4, -3}, 0.2), q = moved({-7, 9}, 1.1);
  EXPECT_NEAR(apart_across(path.straightened(p), path.straightened(q)),
              apart_across(other.straightened(turn * p), other.straightened(turn * q)), 1e-9);
}

TEST(SweepPath, ACornerTurnsTheFrameOnce) {
  const std::vector<Point3> points = {{0, 0, 0}, {0, 0, 40}, {0, 0, 40}, {40, 0, 40}};
  const std::vector<Point3> tangents = {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
  const SweepPath path(points, tangents);
  EXPECT_NEAR(path.turning(), pi / 2, 1e-12);
  EXPECT_LT(apart_across(path.straightened({5, 3, 10}), path.straightened({20, 3, 35})), 1e-12);
}

}  // namespace
}  // namespace sweepmesh
