// Imprinting over families of terraced solids: what must be true of every imprint, near-coincident
// curves, crossings, placements, and each way to fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/overlay.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/imprint/sweep_levels.h"
#include "terraces.h"

namespace sweepmesh {
namespace {

using test::Placement;
using test::rectangle;
using test::Terrace;

constexpr double size = 4.0;

Imprint imprinted(const Model& model, const Scheme& scheme, double element_size = size,
                  double fraction = 0.25) {
  const Context context;
  ImprintOptions options;
  options.size = element_size;
  options.merge_fraction = fraction;
  return imprint_caps(model, scheme, options, context);
}

Imprint imprinted(const Model& model, double fraction = 0.25) {
  return imprinted(model, test::upright_scheme(model), size, fraction);
}

Polyline points_of(const Imprint& imprint, DirectedEdge d) {
  Polyline points = imprint.edges[d.edge].points;
  if (d.reversed) std::reverse(points.begin(), points.end());
  return points;
}

double area_of(const Imprint& imprint, const Patch& patch) {
  double area = 0.0;
  for (const auto& loop : patch.loops)
    for (const DirectedEdge& d : loop) {
      const Polyline p = points_of(imprint, d);
      for (std::size_t i = 0; i + 1 < p.size(); ++i) area += 0.5 * cross2(p[i], p[i + 1]);
    }
  return area * imprint.unit * imprint.unit;
}

double height_of(const Model& model, FaceId cap, const Point3& up) {
  return up.dot(model.point(model.loops(cap).front().front().start));
}

double perimeter(const Model& model, FaceId cap) {
  double sum = 0.0;
  for (const Loop& loop : model.loops(cap))
    for (const Coedge& c : loop) sum += model.length(c.edge);
  return sum;
}

/// The patches of every cap have its area, the runs the solid's volume: both known another way.
/// `moved`: by how much curves may have been brought together.
void expect_complete(const Model& model, const Imprint& imprint, const Point3& up, double tolerance,
                     double moved = 0.0) {
  std::map<FaceId, double> area;
  double volume = 0.0;
  for (const Patch& p : imprint.patches)
    for (const Run& r : p.runs) {
      EXPECT_LT(r.low, r.high);
      area[r.target] += area_of(imprint, p);
      area[r.source] += area_of(imprint, p);
      volume +=
          area_of(imprint, p) * (height_of(model, r.source, up) - height_of(model, r.target, up));
    }
  EXPECT_NEAR(volume / model.volume(), 1.0, tolerance);
  for (const auto& [cap, a] : area)
    EXPECT_NEAR(a, model.area(cap), tolerance * model.area(cap) + moved * perimeter(model, cap))
        << name_of(cap);
}

/// Every CAD edge's chain covers its range without gaps; every loop closes; no edge has two CAD
/// edges of one level.
void expect_consistent(const Model& model, const Imprint& imprint) {
  for (const EdgeId e : model.edges()) {
    const auto& chain = imprint.chain[e.index];
    double at = model.range(e).first;
    for (const DirectedEdge& d : chain) {
      const auto& traces = imprint.edges[d.edge].traces;
      const auto t =
          std::find_if(traces.begin(), traces.end(), [&](const Trace& x) { return x.edge == e; });
      ASSERT_NE(t, traces.end());
      EXPECT_DOUBLE_EQ(d.reversed ? t->last : t->first, at);
      at = d.reversed ? t->first : t->last;
    }
    if (!chain.empty()) {
      EXPECT_DOUBLE_EQ(at, model.range(e).second);
    }
  }
  for (const ImprintEdge& e : imprint.edges) {
    EXPECT_FALSE(e.traces.empty());
    for (std::size_t i = 1; i < e.traces.size(); ++i)
      EXPECT_LT(e.traces[i - 1].level, e.traces[i].level);
    EXPECT_EQ(e.points.front(), imprint.vertices[e.start].point);
    EXPECT_EQ(e.points.back(), imprint.vertices[e.end].point);
  }
  for (const Patch& p : imprint.patches)
    for (const auto& loop : p.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_EQ(points_of(imprint, loop[i]).back(),
                  points_of(imprint, loop[(i + 1) % loop.size()]).front());
}

std::size_t n_runs(const Imprint& imprint) {
  std::size_t n = 0;
  for (const Patch& p : imprint.patches) n += p.runs.size();
  return n;
}

/// Of upright solids: a part of a straight CAD edge is as long as the imprint edge it stands for,
/// but for what curves were brought together.
void expect_traces_fit(const Model& model, const Imprint& imprint, double moved) {
  for (const ImprintEdge& e : imprint.edges)
    for (const Trace& t : e.traces) {
      const Point3 way = model.point(t.edge, t.last) - model.point(t.edge, t.first);
      const double length = imprint.unit * (e.points.back() - e.points.front()).norm();
      EXPECT_NEAR(way.head<2>().norm(), length, moved)
          << name_of(t.edge);
    }
}

TEST(Imprint, SeveralCrossingsOnOneEdgeAreCutWhereTheyAre) {
  const Model model = test::terraced({{rectangle(0, 0, 60, 30), 0, 20},
                                      {rectangle(0, 0, 60, 15), -10, 10},
                                      {rectangle(10, 0, 18, 30), 10, 30},
                                      {rectangle(27, 0, 33, 30), 10, 34},
                                      {rectangle(45, 0, 52, 30), 10, 38}});
  expect_traces_fit(model, imprinted(model, 0.0), 1e-3 * size);
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Model random = test::terraced(test::random_terraces(seed));
    expect_traces_fit(random, imprinted(random, 0.0), 1e-2 * size);
  }
}

TEST(Imprint, OneToOneIsOnePatchAndOneRun) {
  const Model model = test::terraced({{test::regular_polygon({0, 0}, 10, 6), 0, 20}});
  const Imprint imprint = imprinted(model);
  ASSERT_EQ(imprint.patches.size(), 1u);
  EXPECT_EQ(imprint.edges.size(), 6u);
  EXPECT_EQ(n_runs(imprint), 1u);
  expect_consistent(model, imprint);
  expect_complete(model, imprint, Point3::UnitZ(), 1e-7);
}

TEST(Imprint, RandomTerracesAreComplete) {
  int n_failed = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = test::terraced(test::random_terraces(seed));
    try {
      const Imprint imprint = imprinted(model, 0.0);
      expect_consistent(model, imprint);
      expect_complete(model, imprint, Point3::UnitZ(), 1e-3);
    } catch (const ImprintError& e) {
      ++n_failed;
      EXPECT_FALSE(e.entities().empty()) << e.what();
    }
  }
  EXPECT_EQ(n_failed, 0);
}

TEST(Imprint, MergingKeepsEveryRun) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Model model = test::terraced(test::random_terraces(seed));
    const Imprint imprint = imprinted(model, 0.25);
    expect_consistent(model, imprint);
    expect_complete(model, imprint, Point3::UnitZ(), 0.05, 0.25 * size);
  }
}

TEST(Imprint, IsTheSameToTheLastBitForASolidThatIsTurnedAndScaled) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Terrace> terraces = test::random_terraces(seed);
    const Imprint upright = imprinted(test::terraced(terraces));
    for (const double scale : {1e-3, 1.0, 1e3})
      for (const double angle : {0.0, 1.1, 2.9}) {
        SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(angle));
        const Placement placement{Point3(1, 2, -0.5).normalized(), angle, scale};
        const Model model = test::terraced(terraces, {}, placement);
        const Imprint imprint =
            imprinted(model, test::upright_scheme(model, placement), size * scale);
        EXPECT_EQ(n_runs(imprint), n_runs(upright));
        ASSERT_EQ(imprint.edges.size(), upright.edges.size());
        for (std::size_t e = 0; e < upright.edges.size(); ++e)
          EXPECT_EQ(imprint.edges[e].points, upright.edges[e].points);
      }
  }
}

/// A step above at x = 20 and one below, `gap` further; both run across the solid.
Model two_steps(double gap) {
  return test::terraced({{rectangle(0, 0, 40, 30), 0, 20},
                         {rectangle(0, 0, 20, 30), 10, 32},
                         {rectangle(0, 0, 20 + gap, 30), -12, 10}});
}

TEST(Imprint, NearStepsAreMergedBelowTheLimitAndKeptAboveIt) {
  for (int i = 0; i <= 20; ++i) {
    const double gap = size * i / 20.0;
    SCOPED_TRACE(gap);
    const Model model = two_steps(gap);
    const Imprint merged = imprinted(model, 0.25), kept = imprinted(model, 0.0);
    expect_consistent(model, merged);
    expect_consistent(model, kept);
    EXPECT_EQ(merged.patches.size(), i < 5 ? 2u : 3u);
    EXPECT_EQ(kept.patches.size(), i == 0 ? 2u : 3u);
    EXPECT_EQ(merged.merges.empty(), i == 0 || i >= 5);
    for (const Merge& m : merged.merges) EXPECT_NEAR(m.distance, gap, 1e-6);
  }
}

TEST(Imprint, StepsOfTheSameLayersAreNeverMerged) {
  // A thin rib and a thin slot, far thinner than the merge distance.
  const Model rib =
      test::terraced({{rectangle(0, 0, 40, 30), 0, 20}, {rectangle(20, 0, 20.1, 30), 10, 32}});
  EXPECT_EQ(imprinted(rib).patches.size(), 3u);
  const Model slot =
      test::terraced({{rectangle(0, 0, 40, 30), 0, 20}}, {{rectangle(20, -1, 20.1, 31), 10, 40}});
  EXPECT_EQ(imprinted(slot).patches.size(), 3u);
}

TEST(Imprint, CrossingsAreKeptAtEveryAngle) {
  for (const double degrees : {1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const double t = std::tan(degrees * std::numbers::pi / 180 / 2) * 100;
    // Steps along y that lean to either side and cross in the middle of a long solid.
    const Model model =
        test::terraced({{rectangle(-150, -100, 150, 100), 0, 20},
                        {{{-150, -100}, {-t, -100}, {t, 100}, {-150, 100}}, 10, 32},
                        {{{-150, -100}, {t, -100}, {-t, 100}, {-150, 100}}, -12, 10}});
    for (const double fraction : {0.0, 0.25}) {
      const Imprint imprint = imprinted(model, fraction);
      expect_consistent(model, imprint);
      std::set<std::pair<FaceId, FaceId>> pairs;
      for (const Patch& p : imprint.patches)
        for (const auto& r : p.runs) pairs.insert({r.target, r.source});
      EXPECT_EQ(pairs.size(), 4u);
      if (fraction == 0.0) {
        EXPECT_EQ(imprint.patches.size(), 4u);
      }
    }
  }
}

TEST(Imprint, SlotsGiveSeveralRunsOverOnePatch) {
  // A C-shaped solid: two arms over each other, joined at one side.
  const Model model = test::terraced({{rectangle(0, 0, 10, 30), 0, 30},
                                      {rectangle(0, 0, 40, 30), 0, 10},
                                      {rectangle(0, 0, 40, 30), 20, 30}});
  const Imprint imprint = imprinted(model);
  expect_consistent(model, imprint);
  expect_complete(model, imprint, Point3::UnitZ(), 1e-9);
  ASSERT_EQ(imprint.patches.size(), 2u);
  EXPECT_EQ(n_runs(imprint), 3u);
}

TEST(Imprint, HolesAndWindowsInLinkingFaces) {
  // A window through a wall: its linking face has two loops, and the runs below and above are two.
  const Model model =
      test::terraced({{rectangle(0, 0, 40, 30), 0, 30}}, {{rectangle(15, -1, 25, 31), 10, 20}});
  const Imprint imprint = imprinted(model);
  expect_consistent(model, imprint);
  expect_complete(model, imprint, Point3::UnitZ(), 1e-9);
  EXPECT_EQ(imprint.patches.size(), 3u);
  EXPECT_EQ(n_runs(imprint), 4u);
}

TEST(Imprint, LeaningAndTwistedPocketsHaveOneCurveForFloorAndRim) {
  for (const double twist : {0.0, 0.3, 1.0})
    for (const double growth : {0.7, 1.0, 1.4}) {
      const Model model = test::pocketed(twist, growth);
      const Imprint imprint = imprinted(model);
      expect_consistent(model, imprint);
      EXPECT_EQ(imprint.patches.size(), 2u) << twist << " " << growth;
      EXPECT_EQ(imprint.edges.size(), 8u);
      for (const ImprintEdge& e : imprint.edges) EXPECT_EQ(e.traces.size(), 2u);
    }
}

// --- failures
// --------------------------------------------------------------------------------------

ImprintError error_of(const Model& model, const Scheme& scheme) {
  try {
    imprinted(model, scheme);
  } catch (const ImprintError& e) {
    return e;
  }
  throw std::runtime_error("no error");
}

TEST(ImprintErrors, ACapThatIsNoneLeavesRunsOpen) {
  const Model model = two_steps(8);
  Scheme scheme = test::upright_scheme(model);
  const FaceId cap = scheme.faces_with(FaceRole::source).front();
  scheme.face_role[cap.index] = FaceRole::none;
  const ImprintError e = error_of(model, scheme);
  EXPECT_EQ(e.failure(), ImprintFailure::open_run);
  EXPECT_FALSE(e.entities().empty());
  EXPECT_EQ(e.stage(), "imprint");
}

TEST(ImprintErrors, ATargetTakenForASourceIsFound) {
  const Model model = two_steps(8);
  Scheme scheme = test::upright_scheme(model);
  const FaceId cap = scheme.faces_with(FaceRole::target).front();
  scheme.face_role[cap.index] = FaceRole::source;
  EXPECT_EQ(error_of(model, scheme).failure(), ImprintFailure::open_run);
}

TEST(ImprintErrors, AMembraneThinnerThanTheTolerancesHasNoRoom) {
  // Pockets from above and below: what is left between their floors is no level's height.
  const double thin = 5e-6;
  const Model model = test::terraced(
      {{rectangle(0, 0, 60, 50), 0, 20}},
      {{rectangle(10, 10, 40, 40), 10 + thin, 30}, {rectangle(20, 15, 50, 35), -10, 10}});
  const ImprintError e = error_of(model, test::upright_scheme(model));
  EXPECT_EQ(e.failure(), ImprintFailure::no_room);
  EXPECT_EQ(e.entities().size(), 2u);
}

TEST(ImprintErrors, ALinkingFaceThatIsNoneLeavesTheSectionOpen) {
  const Model model = two_steps(8);
  Scheme scheme = test::upright_scheme(model);
  const FaceId wall = scheme.faces_with(FaceRole::linking).front();
  scheme.face_role[wall.index] = FaceRole::none;
  const ImprintError e = error_of(model, scheme);
  EXPECT_EQ(e.failure(), ImprintFailure::unreachable);
  EXPECT_FALSE(e.entities().empty());
}

TEST(ImprintErrors, CurvesOfOneLevelOnOnePlaceCollide) {
  const Model model = two_steps(8);
  const Scheme scheme = test::upright_scheme(model);
  const Context context;
  const Walls walls = find_walls(model, scheme, sweep_levels(model, scheme));
  Reference reference = projected_reference(model, walls, Point3::UnitZ(), 1.0, 1e-3, context);
  // One edge of a cap is laid onto another one of the same level.
  const auto& first = reference.curves.front();
  const auto is_apart = [&](const ReferenceCurve& c) {
    std::set<VertexId> ends;
    for (const EdgeId e : {c.edge, first.edge}) ends.insert({model.start(e), model.end(e)});
    return ends.size() == 4 && walls.level[c.edge.index] == walls.level[first.edge.index];
  };
  const auto other = std::find_if(reference.curves.begin() + 1, reference.curves.end(), is_apart);
  ASSERT_NE(other, reference.curves.end());
  other->points = first.points;
  for (const auto& [moved, onto] : {std::pair(model.start(other->edge), model.start(first.edge)),
                                    std::pair(model.end(other->edge), model.end(first.edge))})
    reference.vertex[moved.index] = reference.vertex[onto.index];
  try {
    overlay(model, scheme, walls, reference, 1e-3, context);
    FAIL();
  } catch (const ImprintError& e) {
    EXPECT_EQ(e.failure(), ImprintFailure::collision);
    EXPECT_FALSE(e.entities().empty());
  }
}

TEST(ImprintErrors, OptionsThatMakeNoSense) {
  const Model model = two_steps(8);
  const Scheme scheme = test::upright_scheme(model);
  EXPECT_THROW(imprinted(model, scheme, 0.0), InputError);
  EXPECT_THROW(imprinted(model, scheme, std::nan("")), InputError);
  EXPECT_THROW(imprinted(model, scheme, 1.0, -0.1), InputError);
  EXPECT_THROW(imprinted(model, scheme, 1.0, 1.5), InputError);
}

TEST(ImprintErrors, CancelEndsIt) {
  const Model model = two_steps(8);
  const Scheme scheme = test::upright_scheme(model);
  Context context;
  context.cancel();
  EXPECT_THROW(imprint_caps(model, scheme, {}, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh
