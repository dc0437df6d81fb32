// What decides between a scheme and its mesh: schemes that cannot be laid out do not count.
#include "sweepmesh/pipeline/layout.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids.h"
#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/plan.h"
#include "sweepmesh/pipeline/sweep.h"
#include "terraces.h"
#include "to_model.h"

namespace sweepmesh {
namespace {

/// A square bar bent to a U, with a boss of half its width on one end: two sources over one target
/// along a bent path.
Model bent_bar_with_boss() {
  BRepBuilderAPI_MakePolygon square(gp_Pnt(20, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 0, 10),
                                    gp_Pnt(20, 0, 10), true);
  const TopoDS_Shape bar =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(square.Wire()).Face(),
                            gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi)
          .Shape();
  const TopoDS_Shape boss = BRepPrimAPI_MakeBox(gp_Pnt(20, -5, 0), gp_Pnt(25, 1, 10)).Shape();
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(bar, boss).Shape(), true, true, false);
  unify.Build();
  return test::to_model(unify.Shape());
}

/// Faces in the plane y = `value`, with the wished sign of x.
std::vector<FaceId> faces_at(const Model& model, double value, double sign) {
  std::vector<FaceId> out;
  for (const FaceId f : model.faces()) {
    const auto& loop = model.loops(f).front();
    if (std::ranges::all_of(loop, [&](const Coedge& c) {
          const Point3 p = model.point(c.start);
          return std::abs(p.y() - value) < 1e-6 && sign * p.x() > 0;
        }))
      out.push_back(f);
  }
  return out;
}

Picks along_the_bar(const Model& bar) {
  Picks out;
  for (const double y : {0.0, -5.0})
    for (const FaceId f : faces_at(bar, y, 1)) out.sources.push_back(f);
  out.targets = faces_at(bar, 0.0, -1);
  return out;
}

TEST(Layout, ABentPathWithSeveralSourcesHasOne) {
  const Model model = bent_bar_with_boss();
  Context context;
  const Picks picks = along_the_bar(model);
  ASSERT_EQ(picks.sources.size(), 2u);
  ASSERT_EQ(picks.targets.size(), 1u);
  const SweepResult result = sweep(model, picks, {}, context);
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_GT(result.quality.scaled_jacobian.min, 0.5);
}

/// Three quarters of a thick tube with a boss outside: two sources over one target, whose columns
/// fan out, so that they have neither a direction nor a path in common.
Model tube_with_boss() {
  BRepBuilderAPI_MakePolygon square(gp_Pnt(20, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 0, 10),
                                    gp_Pnt(20, 0, 10), true);
  const TopoDS_Shape tube =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(square.Wire()).Face(),
                            gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1.5 * std::numbers::pi)
          .Shape();
  const TopoDS_Shape boss = BRepPrimAPI_MakeBox(gp_Pnt(-3, 27, 2), gp_Pnt(3, 35, 8)).Shape();
  return test::to_model(BRepAlgoAPI_Fuse(tube, boss).Shape());
}

/// The faces whose corners are all at a distance from the z axis.
std::vector<FaceId> faces_around(const Model& model, double radius) {
  std::vector<FaceId> out;
  for (const FaceId f : model.faces())
    if (std::ranges::all_of(model.loops(f).front(), [&](const Coedge& c) {
          const Point3 p = model.point(c.start);
          return std::abs(std::hypot(p.x(), p.y()) - radius) < 1e-6;
        }))
      out.push_back(f);
  return out;
}

TEST(Layout, ASweepThatTypesAllowMayHaveNone) {
  const Model model = tube_with_boss();
  Context context;
  Picks outwards;
  outwards.sources = faces_around(model, 30.0);
  for (const FaceId f : faces_around(model, std::hypot(3.0, 35.0))) outwards.sources.push_back(f);
  outwards.targets = faces_around(model, 20.0);
  ASSERT_EQ(outwards.sources.size(), 2u);
  ASSERT_EQ(outwards.targets.size(), 1u);
  Assessment verdict = assess(model, outwards, context);
  ASSERT_TRUE(verdict.is_sweepable());
  const auto fault = layout_fault(model, verdict.schemes.front(), {}, context, true);
  ASSERT_TRUE(fault.has_value());
  EXPECT_FALSE(fault->is_of_size);
  refuse_without_layout(model, context, verdict);
  ASSERT_FALSE(verdict.is_sweepable());
  ASSERT_EQ(verdict.reasons.size(), 1u);
  const Reason& reason = verdict.reasons.front();
  EXPECT_EQ(reason.kind, ReasonKind::geometric);
  EXPECT_FALSE(reason.entities.empty());
  EXPECT_TRUE(reason.text.ends_with("that was tried can be laid out."));
}

TEST(Layout, OneSchemeThatHasOneIsEnough) {
  const Model model = bent_bar_with_boss();  // along z nothing is bent
  Context context;
  Assessment verdict = assess(model, {}, context);
  const std::size_t n = verdict.schemes.size();
  ASSERT_GT(n, 0u);
  refuse_without_layout(model, context, verdict);
  EXPECT_EQ(verdict.schemes.size(), n);
}

/// Verdict, plan and run say the same.
void expect_one_verdict(const Model& model) {
  Context context;
  const Assessment verdict = assess_or_divide(model, {}, context);
  const SweepPlan plan = plan_sweep(model, {}, {}, context);
  const SweepResult run = sweep(model, {}, {}, context);
  EXPECT_EQ(plan.assessment.is_sweepable(), verdict.is_sweepable());
  EXPECT_EQ(run.assessment.is_sweepable(), verdict.is_sweepable());
  if (verdict.is_sweepable()) return;
  for (const Assessment* other : {&plan.assessment, &run.assessment}) {
    ASSERT_FALSE(other->reasons.empty());
    EXPECT_EQ(other->reasons.front().kind, verdict.reasons.front().kind);
  }
  EXPECT_EQ(run.mesh.n_elements(), 0);
}

TEST(Layout, VerdictPlanAndRunAgree) {
  expect_one_verdict(bent_bar_with_boss());
  expect_one_verdict(test::terraced(
      {{test::rectangle(0, 0, 30, 30), 0, 10}, {test::rectangle(5, 5, 15, 15), 10, 20}}));
  for (const auto& [name, model] : test::unsweepable()) expect_one_verdict(model);
}

TEST(Layout, WhatCanBeSweptNeedsNoStrainedSchemes) {
  const Model model = test::box(3, 4, 5);
  Context context;
  Assessment verdict = assess(model, {}, context);
  const std::size_t n = verdict.schemes.size();
  verdict.strained = verdict.schemes;
  accept_strained(model, {}, context, verdict);
  EXPECT_EQ(verdict.schemes.size(), n);
}

TEST(Layout, StrainedSchemesThatCanBeLaidOutCount) {
  const Model model = test::box(3, 4, 5);
  Context context;
  Assessment verdict = assess(model, {}, context);
  verdict.strained = std::move(verdict.schemes);
  verdict.schemes.clear();
  verdict.reasons = {{ReasonKind::geometric, "Angles.", {}}};
  accept_strained(model, {}, context, verdict);
  EXPECT_TRUE(verdict.is_sweepable());
  EXPECT_TRUE(verdict.reasons.empty());
  EXPECT_LE(verdict.schemes.size(), kEnoughStrained);
}

}  // namespace
}  // namespace sweepmesh
