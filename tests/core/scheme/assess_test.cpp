#include "sweepmesh/scheme/assess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "scheme_solids.h"
#include "sweepmesh/base/errors.h"
#include "valid_scheme.h"

namespace sweepmesh {
namespace {

using test::expect_valid_scheme;
using test::NamedModel;

Assessment assessed(const Model& model, const Picks& picks = {}) {
  Context context;
  return assess(model, picks, context);
}

/// Every offered scheme is valid, has roles of its own, and costs no less than the one before
/// unless caps are smaller.
void expect_sound(const NamedModel& solid, const Assessment& found) {
  SCOPED_TRACE(solid.name);
  ASSERT_TRUE(found.is_sweepable());
  EXPECT_TRUE(found.reasons.empty());
  std::set<std::vector<FaceRole>> roles;
  double cost = 0.0;
  for (const Scheme& scheme : found.schemes) {
    expect_valid_scheme(solid.model, scheme);
    EXPECT_TRUE(roles.insert(scheme.face_role).second);
    EXPECT_GE(scheme.cost, cost - 1e-6);
    cost = scheme.cost;
  }
}

void expect_refused(const Assessment& found, ReasonKind kind,
                    const std::vector<std::string>& entities) {
  ASSERT_FALSE(found.is_sweepable());
  ASSERT_FALSE(found.reasons.empty());
  const Reason& reason = found.reasons.front();
  EXPECT_EQ(reason.kind, kind) << reason.text;
  EXPECT_TRUE(reason.text.ends_with(".")) << reason.text;
  std::set<std::string> named(reason.entities.begin(), reason.entities.end());
  for (const std::string& entity : entities)
    EXPECT_TRUE(named.contains(entity)) << entity << ": " << reason.text;
}

/// The plane faces whose normal is along z, upwards or downwards.
std::vector<FaceId> level_faces(const Model& model, double sign) {
  std::vector<FaceId> out;
  for (FaceId f : model.faces()) {
    const auto [low, high] = model.uv_bounds(f);
    if (model.is_planar(f) && sign * model.normal(f, 0.5 * (low + high)).z() > 0.999)
      out.push_back(f);
  }
  return out;
}

TEST(Assess, OneToOneFamiliesAreSweptEndToEnd) {
  for (const auto& solids : {test::prisms(), test::general_one_to_one()})
    for (const NamedModel& solid : solids) {
      const Assessment found = assessed(solid.model);
      expect_sound(solid, found);
      EXPECT_EQ(found.schemes.front().faces_with(FaceRole::source).size(), 1u) << solid.name;
      EXPECT_EQ(found.schemes.front().faces_with(FaceRole::target).size(), 1u) << solid.name;
    }
}

TEST(Assess, PrismsAreSweptAlongTheirAxis) {
  for (const NamedModel& solid : test::prisms()) {
    if (solid.name == "square") continue;  // any of its axes
    const Scheme best = assessed(solid.model).schemes.front();
    std::set<FaceId> caps, level;
    for (FaceRole role : {FaceRole::source, FaceRole::target})
      for (FaceId f : best.faces_with(role)) caps.insert(f);
    for (double sign : {1.0, -1.0})
      for (FaceId f : level_faces(solid.model, sign)) level.insert(f);
    EXPECT_EQ(caps, level) << solid.name;
  }
}

TEST(Assess, BoxHasThreeSchemes) {
  const Model model = test::box(3, 4, 5);
  EXPECT_EQ(assessed(model).schemes.size(), 3u);
}

TEST(Assess, StepsBossesAndBlindHolesHaveManySources) {
  for (const NamedModel& solid : test::many_to_one()) expect_sound(solid, assessed(solid.model));
}

TEST(Assess, PickedCapsKeepTheirRoles) {
  for (const auto& solids : {test::prisms(), test::many_to_one()})
    for (const NamedModel& solid : solids) {
      if (solid.name == "step") continue;  // extruded along z: its steps are no level faces
      Picks picks{level_faces(solid.model, 1.0), level_faces(solid.model, -1.0), {}};
      const Assessment up = assessed(solid.model, picks);
      expect_sound(solid, up);
      EXPECT_EQ(up.schemes.front().faces_with(FaceRole::source), picks.sources) << solid.name;
      EXPECT_EQ(up.schemes.front().faces_with(FaceRole::target), picks.targets) << solid.name;
      std::swap(picks.sources, picks.targets);
      const Assessment down = assessed(solid.model, picks);
      expect_sound(solid, down);
      EXPECT_NEAR(down.schemes.front().cost, up.schemes.front().cost, 1e-9) << solid.name;
    }
}

TEST(Assess, OnePickIsEnough) {
  const Model model = test::box(10, 10, 10);
  for (FaceId f : model.faces()) {
    const Assessment found = assessed(model, {{f}, {}, {}});
    ASSERT_EQ(found.schemes.size(), 1u);
    EXPECT_EQ(found.schemes.front().faces_with(FaceRole::source), std::vector{f});
  }
}

TEST(Assess, SameAnswerOnEveryRun) {
  for (const NamedModel& solid : test::many_to_one()) {
    const Assessment a = assessed(solid.model), b = assessed(solid.model);
    ASSERT_EQ(a.schemes.size(), b.schemes.size());
    for (std::size_t i = 0; i < a.schemes.size(); ++i) {
      EXPECT_EQ(a.schemes[i].face_role, b.schemes[i].face_role);
      EXPECT_EQ(a.schemes[i].cost, b.schemes[i].cost);
    }
  }
}

TEST(Assess, TerracesAreSweptUpwards) {
  std::mt19937 random(5);
  for (int round = 0; round < 12; ++round) {
    // Sums of rows and columns: no two columns stick out of their neighbours with but an edge in
    // common.
    std::vector<double> rows(2 + round % 3), columns(2 + round % 2);
    for (double& row : rows) row = 5.0 * (1 + random() % 4);
    for (double& column : columns) column = 3.0 * (random() % 4);
    std::vector<std::vector<double>> heights;
    for (double row : rows) {
      heights.emplace_back();
      for (double column : columns) heights.back().push_back(row + column);
    }
    const Model model = test::terraces(heights);
    expect_sound({"terraces " + std::to_string(round), model}, assessed(model));
    const Assessment picked = assessed(model, {{}, level_faces(model, -1.0), {}});
    expect_sound({"terraces from below " + std::to_string(round), model}, picked);
    EXPECT_EQ(picked.schemes.front().faces_with(FaceRole::source), level_faces(model, 1.0));
  }
}

TEST(Assess, ShellsOfABallAreSweptRadially) {
  const Assessment found = assessed(test::hollow_ball(1));
  ASSERT_EQ(found.schemes.size(), 1u);
  EXPECT_EQ(found.schemes.front().faces_with(FaceRole::linking).size(), 0u);
}

TEST(Assess, HollowBoxIsSweptRadiallyWhenItsShellsArePicked) {
  const Model model = test::hollow_box();
  expect_sound({"hollow box", model}, assessed(model));
  Picks picks;
  const auto [low, high] = model.bounding_box();
  for (FaceId f : model.faces()) {
    const auto [a, b] = model.uv_bounds(f);
    const Point3 p = model.point(f, 0.5 * (a + b));
    const bool is_outer =
        ((p - low).cwiseAbs().minCoeff() < 1e-6) || ((p - high).cwiseAbs().minCoeff() < 1e-6);
    (is_outer ? picks.sources : picks.targets).push_back(f);
  }
  const Assessment radial = assessed(model, picks);
  expect_sound({"radial", model}, radial);
  EXPECT_TRUE(radial.schemes.front().faces_with(FaceRole::linking).empty());
}

TEST(Assess, VoidsThatNoShellMapsOntoAreATopologicalReason) {
  for (int n_voids : {2, 3})
    expect_refused(assessed(test::hollow_ball(n_voids)), ReasonKind::topological,
                   {"Face1", "Face2", "Face3"});
}

TEST(Assess, SolidsWithoutASweepAreRefusedWithAReason) {
  for (const NamedModel& solid : test::unsweepable()) {
    SCOPED_TRACE(solid.name);
    const Assessment found = assessed(solid.model);
    ASSERT_FALSE(found.reasons.empty());
    expect_refused(found, found.reasons.front().kind, {});
    EXPECT_NE(found.reasons.front().kind, ReasonKind::prescribed);
  }
}

TEST(Assess, SectionsThatHangTogetherAtAPointAreATopologicalReason) {
  const Model model = test::notched_pyramid();
  std::map<VertexId, std::set<FaceId>> faces_at;
  for (const FaceId f : model.faces())
    for (const Coedge& c : model.loops(f).front()) faces_at[c.start].insert(f);
  const auto tip = std::ranges::find(faces_at, 4u, [](const auto& at) { return at.second.size(); });
  ASSERT_NE(tip, faces_at.end());  // the only vertex of four faces
  std::vector<std::string> named = {name_of(tip->first)};
  for (const FaceId f : tip->second) named.push_back(name_of(f));
  const Assessment found = assessed(model);
  expect_refused(found, ReasonKind::topological, named);
  EXPECT_EQ(found.reasons.front().entities, named);
}

TEST(Assess, WallThatRunsBackIsAGeometricReason) {
  const Assessment found = assessed(test::block_with_returning_hole());
  expect_refused(found, ReasonKind::geometric, {});
  EXPECT_NE(found.reasons.front().text.find("runs back"), std::string::npos);
}

TEST(Assess, MitreIsSweptWhereItsEndsArePicked) {
  const Model model = test::mitred_tube();
  const std::vector<FaceId> ends = level_faces(model, 1.0);
  const FaceId top = *std::ranges::max_element(
      ends, {}, [&](FaceId f) { return model.point(f, model.uv_bounds(f).first).z(); });
  const Assessment found = assessed(model, {{top}, {}, {}});
  expect_sound({"mitred tube", model}, found);
  EXPECT_EQ(found.schemes.front().faces_with(FaceRole::target).size(), 1u);
}

TEST(Assess, FaceOfBothKindsIsAPrescribedReason) {
  expect_refused(assessed(test::box(1, 1, 1), {{FaceId{2}}, {FaceId{2}}, {}}),
                 ReasonKind::prescribed, {"Face3"});
}

TEST(Assess, SourceBesideTargetIsAPrescribedReason) {
  const Model model = test::box(1, 1, 1);
  const FaceId a = model.faces().front();
  const FaceId b = model.partner(model.loops(a)[0][0]).face;
  expect_refused(assessed(model, {{a}, {b}, {}}), ReasonKind::prescribed,
                 {name_of(a), name_of(b), name_of(model.loops(a)[0][0].edge)});
}

TEST(Assess, PickThatNoSchemeHasIsNamed) {
  const auto prisms = test::prisms();
  const Model& disc = std::ranges::find(prisms, "disc", &NamedModel::name)->model;
  FaceId wall;
  for (FaceId f : disc.faces())
    if (!disc.is_planar(f)) wall = f;
  expect_refused(assessed(disc, {{wall}, {}, {}}), ReasonKind::prescribed, {name_of(wall)});
}

TEST(Assess, PairsMustFollowTheWalls) {
  const Model model = test::quartered_box();
  const std::vector<FaceId> above = level_faces(model, 1.0), below = level_faces(model, -1.0);
  ASSERT_EQ(above.size(), 4u);
  ASSERT_EQ(below.size(), 4u);
  const auto middle = [&](FaceId f) {
    const auto [low, high] = model.uv_bounds(f);
    return model.point(f, 0.5 * (low + high));
  };
  Picks right, opposite;
  for (FaceId s : above)
    for (FaceId t : below) {
      const Point3 a = middle(s), b = middle(t);
      if ((a - b).head<2>().norm() < 1) right.pairs.emplace_back(s, t);
      if ((a + b).head<2>().norm() < 1) opposite.pairs.emplace_back(s, t);
    }
  ASSERT_EQ(right.pairs.size(), 4u);
  expect_sound({"beneath", model}, assessed(model, right));
  const Assessment found = assessed(model, opposite);
  expect_refused(found, ReasonKind::prescribed, {});
  EXPECT_NE(found.reasons.front().text.find("cannot be paired"), std::string::npos);
  EXPECT_GE(found.reasons.front().entities.size(),
            4u);  // source, target, and the walls along the way
}

TEST(Assess, PickedVertexTypesHoldOrAreNamed) {
  const Model model = test::slanted_block();
  const auto five = std::ranges::find_if(
      model.faces(), [&](FaceId f) { return model.loops(f)[0].size() == 5 && model.is_planar(f); });
  ASSERT_NE(five, model.faces().end());
  const Loop& loop = model.loops(*five)[0];
  int n_reached = 0;
  for (const Coedge& c : loop) {  // any of the five may be the SIDE
    const Assessment found = assessed(model, {{}, {}, {}, {{*five, c.end, VertexType::side}}});
    if (!found.is_sweepable()) continue;
    for (const Scheme& scheme : found.schemes) {
      expect_valid_scheme(model, scheme);
      EXPECT_EQ(scheme.face_role[five->index], FaceRole::linking);
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (loop[i].end == c.end)
          n_reached += scheme.face[five->index].type[0][i] == VertexType::side;
    }
  }
  EXPECT_GT(n_reached, 1);
  // Four corners of a four-sided linking face can only be END: a SIDE on each face contradicts
  // whatever is swept.
  const Model box = test::box(1, 1, 1);
  std::vector<TypePick> types;
  for (FaceId f : box.faces()) types.push_back({f, box.loops(f)[0][0].end, VertexType::side});
  const Assessment refused = assessed(box, {{}, {}, {}, types});
  expect_refused(refused, ReasonKind::prescribed, {});
  EXPECT_NE(refused.reasons.front().text.find("as SIDE"), std::string::npos);
  EXPECT_LT(refused.reasons.front().entities.size(), 2 * types.size());
  EXPECT_THROW(assessed(box, {{}, {}, {}, {{FaceId{0}, VertexId{99}, VertexType::end}}}),
               InputError);
}

TEST(Assess, VertexTypesThatContradictEachOtherAtOnceAreErrors) {
  const Model box = test::box(1, 1, 1);
  const FaceId face = box.faces().front();
  const VertexId vertex = box.loops(face)[0][0].end;
  const TypePick end{face, vertex, VertexType::end}, side{face, vertex, VertexType::side};
  const auto sentence_of = [&](const Picks& picks) -> std::string {
    try {
      assessed(box, picks);
    } catch (const InputError& error) {
      EXPECT_EQ(error.entities(), (std::vector{name_of(vertex), name_of(face)}));
      return error.what();
    }
    return "";
  };
  EXPECT_NE(sentence_of({{}, {}, {}, {end, side}}).find("as END and as SIDE"), std::string::npos);
  EXPECT_NE(sentence_of({{face}, {}, {}, {end}}).find("source or target"), std::string::npos);
  EXPECT_TRUE(assessed(box, {{}, {}, {}, {end, end}}).is_sweepable());
}

TEST(Assess, OpenBoundaryIsRefusedOnReading) {
  EXPECT_THROW(test::open_box(), InputError);
}

TEST(Assess, FaceOfNoneIsAnInputError) {
  EXPECT_THROW(assessed(test::box(1, 1, 1), {{FaceId{17}}, {}, {}}), InputError);
}

TEST(Assess, CanBeCancelled) {
  Context context;
  context.cancel();
  EXPECT_THROW(assess(test::box(1, 1, 1), {}, context), Cancelled);
}

TEST(SolveScheme, FindsTheSameStatesForTheRolesThatWereFound) {
  Context context;
  for (const auto& solids : {test::prisms(), test::general_one_to_one(), test::many_to_one()})
    for (const NamedModel& solid : solids)
      for (const Scheme& scheme : assessed(solid.model).schemes) {
        const auto solved = solve_scheme(solid.model, scheme.face_role, context);
        ASSERT_TRUE(std::holds_alternative<Scheme>(solved)) << solid.name;
        expect_valid_scheme(solid.model, std::get<Scheme>(solved));
        EXPECT_LE(std::get<Scheme>(solved).cost, scheme.cost + 1e-9) << solid.name;
      }
}

TEST(SolveScheme, RefusesRolesThatCannotBe) {
  Context context;
  const Model model = test::box(1, 1, 1);
  const auto solved = solve_scheme(model, std::vector(6, FaceRole::linking), context);
  EXPECT_TRUE(std::holds_alternative<std::vector<Reason>>(solved));
}

}  // namespace
}  // namespace sweepmesh
