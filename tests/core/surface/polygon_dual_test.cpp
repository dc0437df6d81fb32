// Polygons from triangles: invariants over families and random domains, and the ways out.
#include "sweepmesh/surface/polygon_dual.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "cap_shapes.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/surface/planar_pair.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {
namespace {

using namespace test;

PlanarMesh polygons(const PlanarLoops& loops, double size) {
  PlanarMeshOptions options;
  options.size = size;
  options.kind = CellKind::polygon;
  return mesh_planar(loops, options, Context());
}

double area_of(const PlanarMesh& mesh, int c) {
  std::vector<Point2> corners;
  for (const int node : mesh.cell(c)) corners.push_back(mesh.points[node]);
  return signed_area(corners);
}

using Sides = std::map<std::pair<int, int>, int>;  ///< directed side -> its cell

Sides sides_of(const PlanarMesh& mesh) {
  Sides out;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const bool is_new = out.emplace(std::pair(cell[i], cell[(i + 1) % cell.size()]), c).second;
      EXPECT_TRUE(is_new) << "a side is used twice";
    }
  }
  return out;
}

/// What holds of every dual, be it smooth or not.
void expect_division_of(const PlanarLoops& loops, const PlanarMesh& mesh) {
  const std::vector<Point2> boundary = flattened(loops);
  ASSERT_EQ(mesh.n_boundary, static_cast<int>(boundary.size()));
  double expected_area = 0.0, area = 0.0;
  std::set<std::pair<int, int>> border;
  int first = 0;
  for (const auto& loop : loops) {
    expected_area += signed_area(loop);
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) border.insert({first + i, first + (i + 1) % n});
    first += n;
  }
  for (int i = 0; i < mesh.n_boundary; ++i) EXPECT_EQ(mesh.points[i], boundary[i]);
  for (int c = 0; c < mesh.n_cells(); ++c) area += area_of(mesh, c);
  EXPECT_NEAR(area, expected_area, 1e-9 * expected_area);
  const Sides sides = sides_of(mesh);
  long n_edges = static_cast<long>(border.size());
  for (const auto& [side, cell] : sides) {
    const bool has_other = sides.contains({side.second, side.first});
    EXPECT_NE(has_other, border.contains(side));
    n_edges += has_other && side.first < side.second;
  }
  for (const auto& side : border) EXPECT_TRUE(sides.contains(side));
  // Euler: a disc with holes, and no node is alone.
  EXPECT_EQ(mesh.n_nodes() - n_edges + mesh.n_cells(), 2 - static_cast<long>(loops.size()));
  std::vector<int> n_cells(mesh.n_nodes(), 0);
  for (const int node : mesh.cell_nodes) ++n_cells[node];
  for (int n = 0; n < mesh.n_nodes(); ++n) EXPECT_GE(n_cells[n], n < mesh.n_boundary ? 1 : 3);
}

void expect_convex(const PlanarMesh& mesh, double least) {
  for (int c = 0; c < mesh.n_cells(); ++c)
    EXPECT_GT(scaled_jacobian(mesh.points, mesh.cell(c)), least);
}

/// How many cells off the boundary have so many corners, from the least number to the largest.
int n_inner_with(const PlanarMesh& mesh, std::size_t least, std::size_t largest) {
  int n = 0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    n += cell.size() >= least && cell.size() <= largest &&
         std::ranges::none_of(cell, [&](int node) { return node < mesh.n_boundary; });
  }
  return n;
}

class PolygonOutlines : public testing::TestWithParam<Outline> {};

TEST_P(PolygonOutlines, convex_polygons_fill_the_domain_and_keep_its_boundary) {
  const PlanarMesh mesh = polygons(GetParam().loops, GetParam().size);
  expect_division_of(GetParam().loops, mesh);
  expect_convex(mesh, 0.2);
}

TEST(PolygonDual, meshes_of_usual_outlines_are_good_on_the_mean_and_have_about_six_corners) {
  for (const Outline& outline : outlines()) {
    const PlanarMesh mesh = polygons(outline.loops, outline.size);
    EXPECT_GT(quality(mesh.points, mesh).mean, 0.75) << outline.name;
    EXPECT_GE(n_inner_with(mesh, 5, 7), 0.7 * n_inner_with(mesh, 3, 100) - 2) << outline.name;
  }
}

TEST(PolygonDual, far_from_the_boundary_most_cells_are_hexagons) {
  const PlanarMesh mesh = polygons({circle(120, 20, {0, 0})}, 1.05);
  EXPECT_GT(n_inner_with(mesh, 6, 6), 0.6 * n_inner_with(mesh, 3, 100));
}

TEST_P(PolygonOutlines, same_input_gives_the_same_mesh) {
  const PlanarMesh a = polygons(GetParam().loops, GetParam().size);
  const PlanarMesh b = polygons(GetParam().loops, GetParam().size);
  EXPECT_EQ(a.cell_nodes, b.cell_nodes);
  EXPECT_EQ(a.points, b.points);
}

/// Straight strips: as narrow as one element, ending square.
std::vector<Outline> strips() {
  std::vector<Outline> out;
  for (const int width : {1, 2, 3})
    for (const int length : {1, 2, 3, 7, 30})
      out.push_back({"strip " + std::to_string(width) + " by " + std::to_string(length),
                     {rectangle({0, 0}, {length, width}, 1)},
                     1});
  return out;
}

/// Regular loops of few edges, odd ones too.
std::vector<Outline> small_loops() {
  std::vector<Outline> out;
  for (const int n : {3, 4, 5, 6, 7, 8, 9, 11, 14})
    out.push_back({"loop of " + std::to_string(n), {circle(n, 1, {0, 0})}, 2 * pi / n});
  out.push_back(
      {"triangle in a triangle", {circle(3, 4, {0, 0}), as_hole(circle(3, 1, {0, 0}, pi))}, 4});
  out.push_back(
      {"triangle in a square", {rectangle({-3, -3}, {3, 3}, 6), as_hole(circle(3, 1, {0, 0}))}, 6});
  out.push_back({"narrow ring", {circle(30, 5, {0, 0}), as_hole(circle(30, 4.2, {0, 0}))}, 1});
  out.push_back({"star",
                 {[] {
                   std::vector<Point2> corners;
                   for (int i = 0; i < 10; ++i)
                     corners.push_back(circle(10, i % 2 ? 4 : 10, {0, 0})[i]);
                   return polygon(corners, 1.2);
                 }()},
                 1.2});
  return out;
}

const auto named = [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Families, PolygonOutlines, testing::ValuesIn(outlines()), named);
INSTANTIATE_TEST_SUITE_P(Strips, PolygonOutlines, testing::ValuesIn(strips()), named);
INSTANTIATE_TEST_SUITE_P(Small, PolygonOutlines, testing::ValuesIn(small_loops()), named);

/// A loop around the origin whose radius wanders, with some sides cut finer than others.
PlanarLoops random_domain(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlanarLoops loops(1);
  const int n = 12 + static_cast<int>(40 * unit(random));
  const double wave = 0.3 * unit(random), phase = 2 * pi * unit(random);
  const int n_waves = 2 + static_cast<int>(3 * unit(random));
  for (int i = 0; i < n; ++i) {
    const double a = 2 * pi * (i + 0.3 * unit(random)) / n;
    const double radius = 10 * (1 + wave * std::sin(n_waves * a + phase));
    loops[0].push_back(radius * Point2(std::cos(a), std::sin(a)));
  }
  if (unit(random) < 0.6) {
    const Point2 centre(3 * unit(random), 3 * unit(random));
    loops.push_back(
        as_hole(circle(3 + static_cast<int>(20 * unit(random)), 0.5 + 2 * unit(random), centre)));
  }
  return loops;
}

TEST(PolygonDual, random_domains_are_divided_into_convex_polygons) {
  std::mt19937 random(7);
  for (int run = 0; run < 24; ++run) {
    const PlanarLoops loops = random_domain(random);
    if (!is_domain(loops)) continue;
    const PlanarMesh mesh = polygons(loops, 2 * pi * 10 / static_cast<double>(loops[0].size()));
    expect_division_of(loops, mesh);
    expect_convex(mesh, 0.0);
    if (HasFailure()) FAIL() << "domain " << run;
  }
}

/// Triangles without a node inside: fans of one triangle, chords, dangling trees everywhere.
PlanarMesh triangles_of(const PlanarLoops& loops) {
  PlanarMesh mesh;
  mesh.points = flattened(loops);
  mesh.n_boundary = mesh.n_nodes();
  std::vector<std::vector<int>> numbers;
  int first = 0;
  for (const auto& loop : loops) {
    numbers.emplace_back(loop.size());
    for (int& i : numbers.back()) i = first++;
  }
  for (const auto& t : constrained_delaunay(mesh.points, numbers)) mesh.add_cell(t);
  return mesh;
}

TEST(PolygonDual, any_triangulation_and_any_wishes_give_a_division_of_the_domain) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> wish(1, 4);
  int n_divided = 0, n_runs = 0;
  for (; n_runs < 200; ++n_runs) {
    const PlanarLoops loops = random_domain(random);
    if (!is_domain(loops)) continue;
    const PlanarMesh triangles = triangles_of(loops);
    std::vector<int> wished(triangles.n_boundary);
    for (int& w : wished) w = wish(random);
    const auto dual = polygon_dual(triangles, wished);
    if (!dual) continue;
    ++n_divided;
    expect_division_of(loops, *dual);
    if (HasFailure()) FAIL() << "domain " << n_runs;
  }
  EXPECT_GT(n_divided, 0.8 * n_runs);
}

TEST(PolygonDual, a_square_of_two_triangles_is_one_cell) {
  const PlanarMesh triangles = triangles_of({rectangle({0, 0}, {1, 1}, 1)});
  const auto dual = polygon_dual(triangles, {1, 1, 1, 1});
  ASSERT_TRUE(dual);
  ASSERT_EQ(dual->n_cells(), 1);
  EXPECT_EQ(dual->cell(0).size(), 4u);
}

TEST(PolygonDual, a_hole_beyond_a_neck_needs_links_on_its_side) {
  const PlanarLoops loops = {
      {{-4, 0}, {-3, -2}, {0, -0.3}, {3, -2}, {4, 0}, {3, 2}, {0, 0.3}, {-3, 2}},
      as_hole(circle(3, 0.5, {2.5, 0}))};
  const PlanarMesh triangles = triangles_of(loops);
  EXPECT_FALSE(polygon_dual(triangles, {2, 2, 1, 1, 1, 1, 1, 2, 1, 1, 1}));
  const auto dual = polygon_dual(triangles, std::vector<int>(11, 2));
  ASSERT_TRUE(dual);
  expect_division_of(loops, *dual);
}

TEST(PolygonDual, cells_at_a_node_follow_the_widest_of_its_angles) {
  const double degree = pi / 180;
  EXPECT_EQ(
      polygons_at_nodes({{90 * degree, 180 * degree, 240 * degree, 270 * degree, 60 * degree},
                         {90 * degree, 120 * degree, 240 * degree, 200 * degree, 170 * degree}}),
      (std::vector<int>{1, 2, 2, 3, 2}));
}

TEST(PolygonDual, a_reflex_corner_is_cut_off) {
  PlanarMesh arrow;
  arrow.points = {{0, 0}, {4, 0}, {4, 4}, {3, 1}, {0, 0.8}};
  arrow.n_boundary = 5;
  arrow.add_cell(std::vector<int>{0, 1, 2, 3, 4});
  ASSERT_LT(scaled_jacobian(arrow.points, arrow.cell(0)), 0.0);
  const PlanarMesh cut = with_reflex_corners_cut(arrow);
  EXPECT_EQ(cut.n_cells(), 2);
  expect_convex(cut, 0.0);
  EXPECT_NEAR(area_of(cut, 0) + area_of(cut, 1), area_of(arrow, 0), 1e-12);
}

TEST(PolygonDual, a_hole_may_move_far_and_leave_a_ring_of_quads_behind) {
  const PlanarLoops first = {rectangle({-10, -10}, {10, 10}, 2), as_hole(circle(10, 4, {-5, -3}))};
  PlanarLoops second = first;
  second[1] = moved(first[1], {-5, -3}, 0, 1.0, {10, 6});
  PlanarMeshOptions options;
  options.size = 2;
  options.kind = CellKind::polygon;
  const PlanarPair pair = mesh_planar_pair(first, second, options, {}, Context());
  EXPECT_GT(std::min(pair.first_quality.min, pair.second_quality.min), 0.0);
  expect_division_of(first, pair.first);
  PlanarMesh there = pair.first;
  there.points = pair.second;
  expect_division_of(second, there);
}

TEST(PolygonDual, one_mesh_serves_both_ends_of_a_twisted_hole) {
  const PlanarLoops first = {rectangle({-10, -10}, {10, 10}, 2),
                             as_hole(rectangle({-4, -4}, {4, 4}, 2))};
  PlanarLoops second = first;
  second[1] = moved(first[1], {0, 0}, pi / 6, 1.0, {1, 0});
  PlanarMeshOptions options;
  options.size = 2;
  options.kind = CellKind::polygon;
  const PlanarPair pair = mesh_planar_pair(first, second, options, {}, Context());
  EXPECT_GT(pair.first_quality.min, 0.2);
  EXPECT_GT(pair.second_quality.min, 0.2);
  PlanarMesh there = pair.first;
  there.points = pair.second;
  expect_division_of(second, there);
  EXPECT_TRUE(std::any_of(pair.first.cell_offset.begin(), pair.first.cell_offset.end() - 1,
                          [&, c = 0](int) mutable { return pair.first.cell(c++).size() > 4; }));
}

}  // namespace
}  // namespace sweepmesh
