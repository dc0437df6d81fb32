// Solids whose boundary has to turn in the middle of rounded edges.
#include "sweepmesh/pipeline/divided_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "named_cases.h"
#include "solids.h"
#include "sweepmesh/scheme/round_cuts.h"

namespace sweepmesh {
namespace {

std::vector<FaceCut> all_cuts(const Model& model) {
  std::vector<FaceCut> out;
  for (const CutGroup& group : round_cuts(model)) out.insert(out.end(), group.begin(), group.end());
  return out;
}

class Drilled : public testing::TestWithParam<test::NamedModel> {
 protected:
  const Model& model() const { return GetParam().model; }
};

TEST_P(Drilled, CutsRunAcrossFacesFromEdgeToEdge) {
  const auto cuts = all_cuts(model());
  ASSERT_FALSE(cuts.empty());
  for (const FaceCut& cut : cuts)
    for (const Point2& end : {cut.from, cut.to}) {
      double distance = 1.0;
      for (const Loop& loop : model().loops(cut.face))
        for (const Coedge& c : loop)
          if (c.edge.is_valid())
            distance = std::min(distance, model().distance(c.edge, model().point(cut.face, end)));
      EXPECT_LT(distance, 1e-6) << name_of(cut.face);
    }
}

TEST_P(Drilled, PartsAddUpToTheSolid) {
  const DividedModel divided = divide_model(model(), all_cuts(model()));
  const Model& parts = divided.model;
  EXPECT_NEAR(parts.volume(), model().volume(), 1e-6 * model().volume());
  std::map<FaceId, double> area;
  for (const FaceId f : parts.faces()) area[divided.face[f.index]] += parts.area(f);
  for (const FaceId f : model().faces()) EXPECT_NEAR(area[f], model().area(f), 1e-4 * area[f]);
  std::map<EdgeId, double> length;
  for (const EdgeId e : parts.edges()) {
    EXPECT_NE(divided.edge[e.index].is_valid(), divided.edge_face[e.index].is_valid());
    if (divided.edge[e.index].is_valid()) length[divided.edge[e.index]] += parts.length(e);
  }
  int n_seams = 0;
  for (const EdgeId e : model().edges()) {
    const bool is_seam = model().coedges(e).front().seam;
    n_seams += is_seam;
    if (!is_seam) EXPECT_NEAR(length[e], model().length(e), 1e-6 * model().length(e));
  }
  EXPECT_GT(n_seams, 0);
  for (const VertexId v : parts.vertices())
    if (const VertexId whole = divided.vertex[v.index]; whole.is_valid())
      EXPECT_LT((parts.point(v) - model().point(whole)).norm(), 1e-9);
    else
      EXPECT_LT(model().distance(divided.vertex_edge[v.index], parts.point(v)), 1e-6);
}

TEST_P(Drilled, IsSweptOnlyDivided) {
  Context context;
  const Assessment whole = assess(model(), {}, context);
  EXPECT_FALSE(whole.is_sweepable());
  EXPECT_TRUE(may_be_divided(whole));
  const SweepResult result = sweep(model(), {}, {}, context);
  ASSERT_TRUE(result.assessment.is_sweepable());
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_GT(result.quality.scaled_jacobian.min, 0.1);
  EXPECT_NEAR(result.quality.total_volume, model().volume(), 0.05 * model().volume());
  const auto& roles = result.assessment.schemes.front().face_role;
  EXPECT_GT(std::ranges::count(roles, FaceRole::divided), 0);
  EXPECT_FALSE(result.warnings.empty());
}

TEST_P(Drilled, NodesKnowWhatTheyLieOn) {
  Context context;
  const SweepResult result = sweep(model(), {}, {}, context);
  const double tolerance = 1e-6 * model().tolerances().model_size;
  std::map<EdgeId, int> on_edge;
  for (std::size_t n = 0; n < result.mesh.owner.size(); ++n) {
    const Owner& owner = result.mesh.owner[n];
    const Point3 p = result.mesh.points.row(static_cast<Eigen::Index>(n));
    if (owner.index < 0) continue;
    if (owner.kind == EntityKind::edge) {
      ++on_edge[EdgeId{owner.index}];
      EXPECT_LT(model().distance(EdgeId{owner.index}, p), tolerance);
    } else if (owner.kind == EntityKind::face) {
      EXPECT_LT(model().distance(FaceId{owner.index}, p), tolerance);
    } else {
      EXPECT_LT((model().point(VertexId{owner.index}) - p).norm(), tolerance);
    }
  }
  for (const auto& [edge, n] : on_edge) EXPECT_EQ(n, result.intervals.edge[edge.index] - 1);
}

TEST_P(Drilled, PlanSaysWhatTheSweepDoes) {
  Context context;
  const SweepPlan plan = plan_sweep(model(), {}, {}, context);
  const SweepResult result = sweep(model(), {}, {}, context);
  EXPECT_EQ(plan.intervals.edge, result.intervals.edge);
  EXPECT_EQ(plan.intervals.k, result.intervals.k);
  int n_turns = 0;
  for (const CornerType& corner : plan.corners) {
    if (corner.vertex.is_valid()) continue;
    EXPECT_LT(model().distance(corner.edge, corner.point), 1e-6);
    n_turns += corner.type != VertexType::side;
  }
  EXPECT_GT(n_turns, 0);
  for (const EdgeId e : model().edges())
    if (plan.edge_nodes[e.index].rows() > 0)
      EXPECT_EQ(plan.edge_nodes[e.index].rows(), plan.intervals.edge[e.index] + 1) << name_of(e);
  for (const EdgeDirection& d : plan.directions)
    if (d.edge.is_valid())
      EXPECT_LE(d.n_intervals, plan.intervals.edge[d.edge.index]) << name_of(d.edge);
}

INSTANTIATE_TEST_SUITE_P(Across, Drilled, testing::ValuesIn(test::drilled_across()),
                         test::name_of_case);

TEST(DividedSweep, WhatHasNoRoundsAcrossHasNoCuts) {
  EXPECT_TRUE(round_cuts(test::box(1, 2, 3)).empty());
  for (const auto& [name, model] : test::prisms())
    if (name == "disc" || name == "hexagon" || name == "square")
      EXPECT_TRUE(round_cuts(model).empty()) << name;
}

TEST(DividedSweep, CountsOfDividedEdgesAreShared) {
  const Model model = test::drilled_across().back().model;
  Context context;
  const SweepPlan free = plan_sweep(model, {}, {}, context);
  const auto divided =
      std::ranges::find_if(free.corners, [](const CornerType& c) { return !c.vertex.is_valid(); });
  ASSERT_NE(divided, free.corners.end());
  SweepOptions options;
  options.edge_count[divided->edge] = 24;
  EXPECT_EQ(plan_sweep(model, {}, options, context).intervals.edge[divided->edge.index], 24);
}

TEST(DividedSweep, PicksHoldForAllPiecesOfAFace) {
  const Model model = test::drilled_across().back().model;
  Context context;
  Picks picks;
  for (const FaceId f : model.faces())
    if (model.is_planar(f) && model.distance(f, {30, 20, 50}) < 1e-9) picks.sources.push_back(f);
  ASSERT_EQ(picks.sources.size(), 1u);
  const Assessment found = assess_or_divide(model, picks, context);
  ASSERT_TRUE(found.is_sweepable());
  EXPECT_EQ(found.schemes.front().face_role[picks.sources.front().index], FaceRole::source);
  EXPECT_THROW(sweep(model, {picks.sources, picks.sources, {}}, {}, context), InputError);
}

TEST(DividedSweep, CutsThatEndInsideAFaceAreRefused) {
  const Model box = test::box(1, 1, 1);
  const auto [low, high] = box.uv_bounds(FaceId{0});
  const Point2 middle = 0.5 * (low + high);
  try {
    divide_model(box, {{FaceId{0}, 0.5 * (low + middle), middle}});
    FAIL() << "nothing was said";
  } catch (const Error& error) {
    EXPECT_EQ(error.stage(), "divide");
    EXPECT_TRUE(std::string(error.what()).ends_with("."));
  }
}

}  // namespace
}  // namespace sweepmesh
