// Rectilinear regions: what they contain, how slits and tubes are told apart, what is no region.
#include "sweepmesh/intervals/grid_region.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace sweepmesh {
namespace {

/// "R3 U2 L3 D2": runs of steps to the right (+i), up (+k), left, down.
GridLoop loop(GridPoint start, const std::string& runs) {
  GridLoop out{start, {}};
  for (std::size_t at = 0; at < runs.size(); ++at) {
    const auto which = std::string("RULD").find(runs[at]);
    if (which == std::string::npos) continue;
    const int n = std::stoi(runs.substr(at + 1));
    out.steps.insert(out.steps.end(), n, static_cast<Direction>(which));
  }
  return out;
}

/// Every edge of a cell has a cell on its other side or is a step of a loop; corners fit (i, k).
void expect_complete(const GridRegion& r, int period = 0) {
  std::map<std::pair<int, int>, int> sides;
  const int di[] = {0, 1, 1, 0}, dk[] = {0, 0, 1, 1};
  for (const auto& cell : r.cells) {
    for (int c = 0; c < 4; ++c) {
      const GridPoint low = r.nodes[cell[0]], at = r.nodes[cell[c]];
      const int off = at.i - low.i - di[c];
      EXPECT_EQ(period > 0 ? off % period : off, 0);
      EXPECT_EQ(at.k, low.k + dk[c]);
      ++sides[{cell[c], cell[(c + 1) % 4]}];
    }
  }
  int n_boundary = 0;
  for (const auto& [side, n] : sides) {
    EXPECT_EQ(n, 1);
    if (!sides.count({side.second, side.first})) {
      ++n_boundary;
      EXPECT_LT(side.first, r.n_boundary);
      EXPECT_LT(side.second, r.n_boundary);
    }
  }
  EXPECT_EQ(n_boundary, r.n_boundary);
  std::set<int> used;
  for (const auto& cell : r.cells) used.insert(cell.begin(), cell.end());
  EXPECT_EQ(used.size(), r.nodes.size());
}

TEST(Region, Rectangles) {
  for (int w = 1; w < 5; ++w)
    for (int h = 1; h < 5; ++h) {
      const std::string a = std::to_string(w), b = std::to_string(h);
      const auto r = fill_region({loop({3, -2}, "R" + a + "U" + b + "L" + a + "D" + b)});
      ASSERT_TRUE(r);
      expect_complete(*r);
      EXPECT_EQ(r->cells.size(), static_cast<std::size_t>(w * h));
      EXPECT_EQ(r->nodes.size(), static_cast<std::size_t>((w + 1) * (h + 1)));
    }
}

TEST(Region, ConcaveOnes) {
  for (const auto& [runs, n_cells] : std::vector<std::pair<std::string, std::size_t>>{
           {"R5 U2 L3 U2 L2 D4", 14},                    // L
           {"R6 U4 L2 D2 L2 U2 L2 D4", 20},              // U
           {"R2 U2 R2 D2 R2 U4 L6 D4", 20},              // arch
           {"R2 U1 R2 U1 R2 U2 L2 D1 L2 D1 L2 D2", 12},  // stairs
       }) {
    const auto r = fill_region({loop({0, 0}, runs)});
    ASSERT_TRUE(r) << runs;
    expect_complete(*r);
    EXPECT_EQ(r->cells.size(), n_cells) << runs;
  }
}

TEST(Region, Holes) {
  const auto outer = loop({0, 0}, "R7 U5 L7 D5");
  const auto r = fill_region({outer, loop({1, 1}, "U2 R2 D2 L2"), loop({4, 2}, "U1 R2 D1 L2")});
  ASSERT_TRUE(r);
  expect_complete(*r);
  EXPECT_EQ(r->cells.size(), 35u - 4 - 2);
}

TEST(Region, SlitHasTwoSides) {
  const auto r = fill_region({loop({0, 0}, "R2 U2 D2 R2 U3 L4 D3")});
  ASSERT_TRUE(r);
  expect_complete(*r);
  EXPECT_EQ(r->cells.size(), 12u);
  int n_at_slit = 0;
  for (const GridPoint p : r->nodes) n_at_slit += p == GridPoint{2, 1};
  EXPECT_EQ(n_at_slit, 2);
}

TEST(Region, Tubes) {
  for (const int around : {3, 4, 9})
    for (const int turn : {0, 1, 5, -7}) {
      const std::string n = std::to_string(around);
      const auto r = fill_region({loop({0, 0}, "R" + n), loop({turn, 4}, "L" + n)}, around);
      ASSERT_TRUE(r);
      expect_complete(*r, around);
      EXPECT_EQ(r->cells.size(), static_cast<std::size_t>(4 * around));
    }
  const auto r = fill_region(
      {loop({0, 0}, "R8"), loop({0, 5}, "L3 D2 L3 U2 L2"), loop({6, 1}, "U2 R4 D2 L4")}, 8);
  EXPECT_FALSE(r) << "the hole runs into the notch";
  const auto fits = fill_region(
      {loop({0, 0}, "R8"), loop({0, 6}, "L3 D2 L3 U2 L2"), loop({6, 1}, "U2 R3 D2 L3")}, 8);
  ASSERT_TRUE(fits);
  expect_complete(*fits, 8);
  EXPECT_EQ(fits->cells.size(), 48u - 6 - 6);
}

TEST(Region, WhatIsNone) {
  EXPECT_FALSE(fill_region({})) << "nothing";
  EXPECT_FALSE(fill_region({loop({0, 0}, "R2 U2 L2")})) << "not closed";
  EXPECT_FALSE(fill_region({loop({0, 0}, "U2 R2 D2 L2")})) << "clockwise";
  EXPECT_FALSE(fill_region({loop({0, 0}, "R4 U1 L4 U1 R2 D3 L2 U1")})) << "crosses itself";
  EXPECT_FALSE(fill_region({loop({0, 0}, "R3 L3")})) << "no inside";
  const auto outer = loop({0, 0}, "R5 U5 L5 D5");
  EXPECT_FALSE(fill_region({outer, loop({6, 1}, "U1 R1 D1 L1")})) << "hole outside";
  EXPECT_FALSE(fill_region({outer, loop({0, 1}, "U1 R1 D1 L1")})) << "hole touches";
  EXPECT_FALSE(fill_region({outer, loop({4, 1}, "U1 R3 D1 L3")})) << "hole crosses";
  EXPECT_FALSE(fill_region({outer, loop({1, 1}, "R1 U1 L1 D1")})) << "hole runs counterclockwise";
  EXPECT_FALSE(fill_region({outer, loop({1, 1}, "U2 R2 D2 L2"), loop({2, 2}, "U2 R2 D2 L2")}))
      << "holes overlap";
  EXPECT_FALSE(fill_region({loop({0, 0}, "R2 U1 L1 U1 R1 U1 L2 D3"), loop({0, 0}, "R1 U1 L1 D1")}))
      << "covered twice";
  EXPECT_FALSE(fill_region({loop({0, 0}, "R4"), loop({0, 3}, "L5")}, 4)) << "rims differ";
}

/// A C whose lower arm ends in a hook that reaches into the upper arm: a walk of total turn 4 that
/// covers one cell twice.
TEST(Region, OverlappingArms) {
  EXPECT_FALSE(fill_region({loop({0, 0}, "R6 U4 L1 D2 L4 U1 R5 U3 L6 D6")}));
  EXPECT_TRUE(fill_region({loop({0, 0}, "R6 U4 L1 D2 L4 U3 R5 U3 L6 D8")}));
}

}  // namespace
}  // namespace sweepmesh
