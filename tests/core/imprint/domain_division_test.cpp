#include "sweepmesh/imprint/domain_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sweepmesh {
namespace {

/// Points from a to b, b left out.
void add_side(const Point2& a, const Point2& b, int n, std::vector<Point2>& loop) {
  for (int i = 0; i < n; ++i) loop.push_back(a + (b - a) * i / n);
}

/// What a square corner leaves of a slanted strip: a passage of width `gap` between the corner at
/// the origin and the strip's lower side, narrow beside the nodes' distance of about 1.
PlanarLoops strip_at_corner(double gap, double slant) {
  const Point2 slope(std::cos(slant), -std::sin(slant));
  const Point2 below = gap * Point2(-std::sin(slant), -std::cos(slant));
  const Point2 tip = below - 0.6 * slope, far = below + 7.2 * slope;
  std::vector<Point2> loop;
  add_side(tip, far, 8, loop);
  add_side(far, Point2(6.6, 0), 3, loop);
  add_side(Point2(6.6, 0), Point2(0, 0), 7, loop);
  add_side(Point2(0, 0), Point2(0, 1), 1, loop);
  add_side(Point2(0, 1), tip, 1, loop);
  return {loop};
}

PlanarMesh first_candidate(const PlanarLoops& loops, const Context& context) {
  std::vector<PlanarMesh> all = candidate_meshes(loops, {}, {interior_angles(loops)}, context);
  return *std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return overall_quality(a) < overall_quality(b);
  });
}

double area_of(const PlanarMesh& mesh) {
  double sum = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    std::vector<Point2> corners;
    for (const int n : mesh.cell(c)) corners.push_back(mesh.points[n]);
    sum += signed_area(corners);
  }
  return sum;
}

/// Narrow strips, wide ones, flat and steep: with cuts all have meshes without folds.
TEST(DomainDivision, MeshesPassagesNarrowerThanACell) {
  const Context context;
  int n_divided = 0;
  for (const double gap : {0.06, 0.3})
    for (const double slant : {0.2, 0.5}) {
      SCOPED_TRACE(testing::Message() << gap << " " << slant);
      const PlanarLoops loops = strip_at_corner(gap, slant);
      const PlanarMesh whole = first_candidate(loops, context);
      if (quality(whole.points, whole).n_inverted == 0) continue;
      const auto mesh = mesh_divided(loops, whole, {}, context);
      ASSERT_TRUE(mesh);
      ++n_divided;
      EXPECT_EQ(quality(mesh->points, *mesh).n_inverted, 0);
      ASSERT_EQ(mesh->n_boundary, static_cast<int>(loops[0].size()));
      for (int i = 0; i < mesh->n_boundary; ++i) EXPECT_EQ(mesh->points[i], loops[0][i]);
      for (int c = 0; c < mesh->n_cells(); ++c) EXPECT_EQ(mesh->cell(c).size(), 4u);
      EXPECT_NEAR(area_of(*mesh), signed_area(loops[0]), 1e-9);
    }
  EXPECT_GT(n_divided, 0) << "none of the strips needs a cut";
}

/// A mesh without poor cells gives no place to cut at.
TEST(DomainDivision, LeavesGoodMeshesAlone) {
  const Context context;
  std::vector<Point2> square;
  const Point2 corner[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (int i = 0; i < 4; ++i) add_side(corner[i], corner[(i + 1) % 4], 4, square);
  EXPECT_FALSE(mesh_divided({square}, first_candidate({square}, context), {}, context));
}

}  // namespace
}  // namespace sweepmesh
