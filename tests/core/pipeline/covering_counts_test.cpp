// More mesh edges where faces are covered poorly, and what the whole pipeline makes of it.
#include "sweepmesh/pipeline/covering_counts.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "named_cases.h"
#include "solids.h"
#include "sweepmesh/pipeline/sweep.h"
#include "to_model.h"

namespace sweepmesh {
namespace {

class CoveringCounts : public testing::TestWithParam<test::NamedModel> {
 protected:
  const Model& model() const { return GetParam().model; }

  Intervals counts(int n) const {
    Intervals out;
    out.edge.assign(model().n_edges(), n);
    return out;
  }
  /// Each face lacks this part of its area.
  std::vector<FaceCoverage> lacking(double part) const {
    std::vector<FaceCoverage> out;
    for (const FaceId f : model().faces()) {
      const double area = model().area(f);
      out.push_back({f, area, (1.0 - part) * area});
    }
    return out;
  }
};

TEST_P(CoveringCounts, nothing_is_raised_where_faces_are_covered) {
  IntervalOptions options;
  EXPECT_FALSE(is_poorly_covered(lacking(0.05)));
  EXPECT_FALSE(raise_for_coverage(model(), lacking(0.05), counts(4), options));
  EXPECT_TRUE(options.least_count.empty());
}

TEST_P(CoveringCounts, are_at_most_doubled_and_at_least_one_more) {
  for (const int n : {3, 8})
    for (const double part : {0.09, 0.2, 0.9}) {
      IntervalOptions options;
      EXPECT_TRUE(is_poorly_covered(lacking(part)));
      ASSERT_TRUE(raise_for_coverage(model(), lacking(part), counts(n), options));
      for (const auto& [edge, least] : options.least_count) {
        EXPECT_GT(least, n) << name_of(edge);
        EXPECT_LE(least, 2 * n) << name_of(edge);
      }
    }
}

TEST_P(CoveringCounts, the_user_s_counts_and_sizes_stay) {
  IntervalOptions options;
  for (const EdgeId e : model().edges())
    if (e.index % 2)
      options.edge_count[e] = 4;
    else
      options.edge_size[e] = 1.0;
  EXPECT_FALSE(raise_for_coverage(model(), lacking(0.3), counts(4), options));
  EXPECT_TRUE(options.least_count.empty());
}

INSTANTIATE_TEST_SUITE_P(Prisms, CoveringCounts, testing::ValuesIn(test::prisms()),
                         test::name_of_case);
INSTANTIATE_TEST_SUITE_P(General, CoveringCounts, testing::ValuesIn(test::general_one_to_one()),
                         test::name_of_case);

TEST(CoveringCounts, only_edges_whose_chords_are_to_blame_are_raised) {
  const Model model = test::to_model(BRepPrimAPI_MakeCylinder(5, 20, 1.0).Shape());  // a wedge
  Intervals counts;
  counts.edge.assign(model.n_edges(), 1);
  std::vector<FaceCoverage> coverage;
  for (const FaceId f : model.faces()) {
    const double area = model.area(f);
    coverage.push_back({f, area, (model.is_planar(f) ? 1.0 : 0.9) * area});
  }
  IntervalOptions options;
  ASSERT_TRUE(raise_for_coverage(model, coverage, counts, options));
  EXPECT_EQ(options.least_count.size(), 2u);
  for (const auto& [edge, least] : options.least_count)
    EXPECT_NEAR(model.length(edge), 5.0, 1e-9) << name_of(edge);  // the arcs
}

/// A shaft with a point much smaller than its elements.
Model shaft_with_point(double radius, double height) {
  const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(6, 12).Shape();
  const gp_Ax2 top(gp_Pnt(0, 0, 12), gp_Dir(0, 0, 1));
  return test::to_model(
      BRepAlgoAPI_Fuse(shaft, BRepPrimAPI_MakeCone(top, radius, 0, height).Shape()).Shape());
}

TEST(Coverage, points_of_shafts_are_not_cut_off) {
  for (const auto [radius, height] :
       {std::pair(0.4, 1.0), {0.7, 1.0}, {0.7, 2.0}, {1.0, 1.0}, {1.0, 2.0}}) {
    const Model model = shaft_with_point(radius, height);
    Context context;
    const SweepResult result = sweep(model, {}, {}, context);
    ASSERT_GT(result.mesh.n_elements(), 0);
    EXPECT_EQ(result.quality.n_inverted, 0);
    ASSERT_EQ(result.coverage.size(), model.faces().size());
    EXPECT_LE(worst_deviation(result.coverage), kMostAreaDeviation) << radius << ' ' << height;
  }
}

TEST(Coverage, counts_that_the_user_gave_hold_and_poor_faces_are_named) {
  const Model model = test::to_model(BRepPrimAPI_MakeCylinder(6, 12).Shape());
  SweepOptions options;
  for (const EdgeId e : model.edges())
    if (model.start(e) == model.end(e)) options.edge_count[e] = 4;
  Context context;
  const SweepResult result = sweep(model, {}, options, context);
  for (const auto& [edge, n] : options.edge_count) EXPECT_EQ(result.intervals.edge[edge.index], n);
  EXPECT_GT(worst_deviation(result.coverage), kMostAreaDeviation);
  const auto names_face = [&](const FaceCoverage& f) {
    return std::ranges::any_of(result.warnings, [&](const std::string& w) {
      return w.find(name_of(f.face) + " has") != std::string::npos;
    });
  };
  for (const FaceCoverage& f : result.coverage)
    EXPECT_EQ(names_face(f), !is_covered(f)) << name_of(f.face);
}

}  // namespace
}  // namespace sweepmesh
