// A plan says beforehand what a sweep then does.
#include "sweepmesh/pipeline/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "named_cases.h"
#include "solids.h"

namespace sweepmesh {
namespace {

SweepPlan planned(const Model& model, const SweepOptions& options = {}, const Picks& picks = {}) {
  Context context;
  return plan_sweep(model, picks, options, context);
}

class Plan : public testing::TestWithParam<test::NamedModel> {};

TEST_P(Plan, has_the_intervals_of_the_sweep) {
  const Model& model = GetParam().model;
  Context context;
  const SweepPlan plan = planned(model);
  const SweepResult result = sweep(model, {}, {}, context);
  EXPECT_EQ(plan.size, result.size);
  EXPECT_EQ(plan.intervals.edge, result.intervals.edge);
  EXPECT_EQ(plan.intervals.k, result.intervals.k);
  EXPECT_EQ(plan.intervals.n_layers, result.intervals.n_layers);
}

// Going once around a loop turns by one full turn around a disc, and by none around a tube.
TEST_P(Plan, types_sum_up_to_the_turns_of_the_loops) {
  const Model& model = GetParam().model;
  std::map<FaceId, int> sum;
  for (const CornerType& corner : planned(model).corners)
    sum[corner.face] += static_cast<int>(corner.type);
  EXPECT_FALSE(sum.empty());
  for (const auto& [face, turns] : sum) {
    const int n_loops = static_cast<int>(model.loops(face).size());
    EXPECT_TRUE(turns == 4 - 4 * (n_loops - 1) || turns == 0) << name_of(face) << ": " << turns;
  }
}

TEST_P(Plan, names_the_vertices_of_linking_faces_only) {
  const Model& model = GetParam().model;
  const SweepPlan plan = planned(model);
  for (const CornerType& corner : plan.corners) {
    EXPECT_EQ(plan.assessment.schemes.front().face_role[corner.face.index], FaceRole::linking);
    EXPECT_GE(plan.intervals.k[corner.vertex.index], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Prisms, Plan, testing::ValuesIn(test::prisms()), test::name_of_case);
INSTANTIATE_TEST_SUITE_P(General, Plan, testing::ValuesIn(test::general_one_to_one()),
                         test::name_of_case);
INSTANTIATE_TEST_SUITE_P(ManyToOne, Plan, testing::ValuesIn(test::many_to_one()),
                         test::name_of_case);

TEST(PlanOfNothing, has_the_reasons_and_no_numbers) {
  for (const auto& [name, model] : test::unsweepable()) {
    if (name == "box with a ball cut out") continue;  // is divided along its rounds
    SCOPED_TRACE(name);
    const SweepPlan plan = planned(model);
    EXPECT_FALSE(plan.assessment.is_sweepable());
    EXPECT_FALSE(plan.assessment.reasons.empty());
    EXPECT_TRUE(plan.corners.empty());
    EXPECT_TRUE(plan.intervals.edge.empty());
  }
}

TEST(PlanOfNothing, wrong_options_and_picks_are_refused) {
  const Model model = test::box(10, 10, 10);
  SweepOptions options;
  options.size = -1;
  EXPECT_THROW(planned(model, options), InputError);
  options.size = 1e-4;
  EXPECT_THROW(planned(model, options), InputError);
  Picks picks;
  picks.sources = picks.targets = {FaceId{0}};
  EXPECT_THROW(planned(model, {}, picks), InputError);
}

}  // namespace
}  // namespace sweepmesh
