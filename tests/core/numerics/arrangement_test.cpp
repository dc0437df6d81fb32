// Exact arrangement: Euler's formula, areas and provenance over families of polylines.
#include "sweepmesh/numerics/cgal/arrangement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

using Polyline = std::vector<Point2>;

Polyline circle(const Point2& centre, double radius, int n) {
  Polyline out;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    out.emplace_back(centre + radius * Point2(std::cos(a), std::sin(a)));
  }
  out.push_back(out.front());
  return out;
}

Polyline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
}

double area_of(const PlaneArrangement& a, const std::vector<DirectedEdge>& loop) {
  double area = 0.0;
  for (const DirectedEdge& d : loop) {
    const auto& p = a.edges[d.edge].points;
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
      area += (d.reversed ? -0.5 : 0.5) * cross2(p[i], p[i + 1]);
  }
  return area;
}

int n_components(const PlaneArrangement& a) {
  std::vector<int> group(a.vertices.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = static_cast<int>(i);
  const auto find = [&](int v) {
    while (group[v] != v) v = group[v];
    return v;
  };
  for (const auto& e : a.edges) group[find(e.start)] = find(e.end);
  int n = 0;
  for (std::size_t i = 0; i < group.size(); ++i)
    n += find(static_cast<int>(i)) == static_cast<int>(i);
  return n;
}

void expect_consistent(const PlaneArrangement& a, const std::vector<Polyline>& input) {
  const int n_v = static_cast<int>(a.vertices.size()), n_e = static_cast<int>(a.edges.size());
  EXPECT_EQ(n_v - n_e + static_cast<int>(a.faces.size()), 1 + n_components(a));
  std::vector<int> sides(2 * a.edges.size(), 0);
  double total = 0.0;
  int n_unbounded = 0;
  for (const auto& f : a.faces) {
    n_unbounded += !f.is_bounded;
    for (const auto& loop : f.loops) {
      total += area_of(a, loop);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ++sides[2 * loop[i].edge + loop[i].reversed];
        const auto& e = a.edges[loop[i].edge];
        const auto& next = loop[(i + 1) % loop.size()];
        const auto& g = a.edges[next.edge];
        EXPECT_EQ(loop[i].reversed ? e.start : e.end, next.reversed ? g.end : g.start);
      }
    }
  }
  EXPECT_EQ(n_unbounded, 1);
  EXPECT_NEAR(total, 0.0, 1e-9);
  for (const int n : sides) EXPECT_EQ(n, 1);
  // Each polyline is covered once, from its start to its end.
  std::vector<double> covered(input.size(), 0.0);
  for (const auto& e : a.edges) {
    EXPECT_FALSE(e.uses.empty());
    for (const auto& u : e.uses) covered[u.polyline] += std::abs(u.last - u.first);
  }
  for (std::size_t c = 0; c < input.size(); ++c)
    EXPECT_NEAR(covered[c], static_cast<double>(input[c].size()) - 1, 1e-6);
}

TEST(Arrangement, OneClosedCurveIsOneEdgeAndTwoFaces) {
  const std::vector<Polyline> input = {circle({0, 0}, 1, 50)};
  const PlaneArrangement a = arrange(input);
  EXPECT_EQ(a.vertices.size(), 1u);
  EXPECT_EQ(a.edges.size(), 1u);
  EXPECT_EQ(a.faces.size(), 2u);
  expect_consistent(a, input);
}

TEST(Arrangement, CrossingsAreFoundAtAnyAngle) {
  for (int k = 0; k <= 15; ++k) {
    const double slope = std::pow(10.0, -k);
    const std::vector<Polyline> input = {{{-1, 0}, {1, 0}}, {{-1, -slope}, {1, 2 * slope}}};
    const PlaneArrangement a = arrange(input);
    EXPECT_EQ(a.vertices.size(), 5u) << slope;
    EXPECT_EQ(a.edges.size(), 4u) << slope;
    expect_consistent(a, input);
  }
}

TEST(Arrangement, PartialOverlapsKnowBothCurves) {
  const std::vector<Polyline> input = {rectangle(0, 0, 4, 4), {{1, 0}, {3, 0}}, {{6, 0}, {2, 0}}};
  const PlaneArrangement a = arrange(input);
  expect_consistent(a, input);
  std::vector<std::size_t> uses;
  for (const auto& e : a.edges)
    if (e.uses.size() > 1) uses.push_back(e.uses.size());
  std::sort(uses.begin(), uses.end());
  EXPECT_EQ(uses, (std::vector<std::size_t>{2, 2, 3}));
}

TEST(Arrangement, NestedLoopsAreHoles) {
  const std::vector<Polyline> input = {rectangle(0, 0, 10, 10), circle({5, 5}, 2, 20),
                                       rectangle(1, 1, 2, 2), rectangle(4.5, 4.5, 5, 5)};
  const PlaneArrangement a = arrange(input);
  expect_consistent(a, input);
  std::size_t most = 0;
  for (const auto& f : a.faces) most = std::max(most, f.loops.size());
  EXPECT_EQ(a.faces.size(), 5u);
  EXPECT_EQ(most, 3u);
}

TEST(Arrangement, RandomCurvesAreConsistent) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 10.0);
  for (int round = 0; round < 20; ++round) {
    std::vector<Polyline> input;
    for (int i = 0; i < 8; ++i) {
      input.push_back(circle({place(random), place(random)}, 0.2 + place(random) / 3, 30));
      const double x = place(random), y = place(random);
      input.push_back(rectangle(x, y, x + 0.1 + place(random), y + 0.1 + place(random)));
      input.push_back({{place(random), place(random)}, {place(random), place(random)}});
    }
    expect_consistent(arrange(input), input);
  }
}

TEST(Arrangement, BadInputIsRefused) {
  EXPECT_THROW(arrange({{{0, 0}, {0, 0}}}), InputError);
  EXPECT_THROW(arrange({{{0, 0}}}), InputError);
  EXPECT_THROW(arrange({{{0, 0}, {std::nan(""), 0}}}), InputError);
}

}  // namespace
}  // namespace sweepmesh
