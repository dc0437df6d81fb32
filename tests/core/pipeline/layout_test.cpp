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

/// A square bar bent to a U, with a boss of half its width on one end: two sources over
/// one target along a bent path, whose curves have no common direction to be imprinted along.
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

TEST(Layout, ASweepThatTypesAllowMayHaveNone) {
  const Model model = bent_bar_with_boss();
  Context context;
  Picks along_the_bar;
  for (const double y : {0.0, -5.0})
    for (const FaceId f : faces_at(model, y, 1)) along_the_bar.sources.push_back(f);
  along_the_bar.targets = faces_at(model, 0.0, -1);
  ASSERT_EQ(along_the_bar.sources.size(), 2u);
  ASSERT_EQ(along_the_bar.targets.size(), 1u);
  Assessment verdict = assess(model, along_the_bar, context);
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

TEST(Layout, SchemesBesideThoseThatWereTriedHaveOtherCaps) {
  const Model model = bent_bar_with_boss();
  Context context;
  const std::vector<Scheme> all = schemes_beside(model, {}, context);
  ASSERT_FALSE(all.empty());
  const std::vector<Scheme> others = schemes_beside(model, {all.front()}, context);
  EXPECT_EQ(others.size() + 1, all.size());
  for (const Scheme& scheme : others) EXPECT_NE(scheme.face_role, all.front().face_role);
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
