// Intervals of whole solids: what must hold for any of them, and each refusal.
#include "sweepmesh/intervals/assign_intervals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simple_scheme.h"
#include "solids.h"
#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/intervals/wishes.h"

namespace sweepmesh {
namespace {

using testing::model_of;

struct Case {
  Model model;
  Scheme scheme;
};

/// Swept along z: everything that faces up is a source, everything that faces down a target.
Case upright(const TopoDS_Shape& shape) {
  Model model = model_of(shape);
  Scheme scheme = testing::simple_scheme(model, testing::faces_facing(model, 1),
                                         testing::faces_facing(model, -1));
  return {std::move(model), std::move(scheme)};
}

TopoDS_Shape plate_with_hole() {
  return BRepAlgoAPI_Cut(
             testing::box(40, 30, 10),
             BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1)), 5, 12).Shape())
      .Shape();
}

/// A block with a slot along y: an upright wall beside it, seen from the front an L.
TopoDS_Shape step_block() {
  return testing::prism({{gp_Pnt(0, 0, 0), gp_Pnt(30, 0, 0), gp_Pnt(30, 0, 10), gp_Pnt(12, 0, 10),
                          gp_Pnt(12, 0, 25), gp_Pnt(0, 0, 25)}},
                        gp_Vec(0, 20, 0));
}

/// Seen from the front a frame: a window through the block, whose floor is a source and whose top a
/// target.
TopoDS_Shape window_block() {
  return testing::prism(
      {{gp_Pnt(0, 0, 0), gp_Pnt(50, 0, 0), gp_Pnt(50, 0, 40), gp_Pnt(0, 0, 40)},
       {gp_Pnt(10, 0, 12), gp_Pnt(20, 0, 12), gp_Pnt(20, 0, 30), gp_Pnt(10, 0, 30)}},
      gp_Vec(0, 15, 0));
}

std::vector<std::pair<std::string, TopoDS_Shape>> family() {
  return {{"box", testing::box(10, 20, 30)},
          {"cylinder", BRepPrimAPI_MakeCylinder(5, 20).Shape()},
          {"plate with hole", plate_with_hole()},
          {"step", step_block()},
          {"window", window_block()},
          {"polygon", testing::regular_prism(13, 20, 9)}};
}

int sum_around(const Loop& loop, const Intervals& n) {
  int sum = 0;
  for (const Coedge& c : loop)
    if (c.edge.is_valid()) sum += n.edge[c.edge.index];
  return sum;
}

/// All that the sweep demands of the counts.
void expect_consistent(const Case& c, const Intervals& n) {
  for (const FaceId f : c.model.faces()) {
    const auto& loops = c.model.loops(f);
    const bool is_cap = c.scheme.face_role[f.index] != FaceRole::linking;
    int around = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const int sum = sum_around(loops[l], n);
      around += sum;
      EXPECT_GE(sum, 4) << name_of(f);
      int i = 0;
      for (std::size_t j = 0; j < loops[l].size(); ++j) {
        const Coedge& edge = loops[l][j];
        const int rise = n.k[edge.end.index] - n.k[edge.start.index];
        const int count = n.edge[edge.edge.index];
        EXPECT_GE(count, 1);
        if (is_cap) {
          EXPECT_EQ(rise, 0);
          continue;
        }
        const Direction d = c.scheme.face[f.index].direction[l][j];
        const int up = d == Direction::plus_k ? 1 : d == Direction::minus_k ? -1 : 0;
        EXPECT_EQ(rise, up * count);
        if (d == Direction::plus_i) i += count;
        if (d == Direction::minus_i) i -= count;
      }
      EXPECT_EQ(i, 0) << name_of(f);
    }
    EXPECT_TRUE(!is_cap || around % 2 == 0) << name_of(f);
  }
  int low = n.n_layers, high = 0;
  for (const VertexId v : c.model.vertices()) {
    low = std::min(low, n.k[v.index]);
    high = std::max(high, n.k[v.index]);
  }
  EXPECT_EQ(low, 0);
  EXPECT_EQ(high, n.n_layers);
}

TEST(AssignIntervals, MeetsAllDemandsOverSizes) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Case c = upright(shape);
    for (const double size : {0.7, 2.0, 5.0, 11.0, 100.0}) {
      SCOPED_TRACE(size);
      Context context;
      const IntervalOptions options{.size = size};
      const Intervals n = assign_intervals(c.model, c.scheme, options, context);
      expect_consistent(c, n);
      EXPECT_TRUE(n.is_optimal);
      EXPECT_EQ(assign_intervals(c.model, c.scheme, options, context).edge, n.edge);
    }
  }
}

TEST(AssignIntervals, LeastCountsHoldUnlessTheUserGaveTheCount) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Case c = upright(shape);
    Context context;
    const Intervals before = assign_intervals(c.model, c.scheme, {.size = 5.0}, context);
    for (const EdgeId e : c.model.edges()) {
      IntervalOptions options{.size = 5.0};
      options.least_count = {{e, before.edge[e.index] + 3}};
      const Intervals n = assign_intervals(c.model, c.scheme, options, context);
      expect_consistent(c, n);
      EXPECT_GE(n.edge[e.index], before.edge[e.index] + 3) << name_of(e);
      options.edge_count = {{e, before.edge[e.index]}};
      EXPECT_EQ(assign_intervals(c.model, c.scheme, options, context).edge[e.index],
                before.edge[e.index])
          << name_of(e);
    }
  }
}

TEST(AssignIntervals, CountsComeFromTheSize) {
  const Case c = upright(testing::box(10, 20, 30));
  Context context;
  const Intervals n = assign_intervals(c.model, c.scheme, {.size = 2.0}, context);
  for (const EdgeId e : c.model.edges())
    EXPECT_EQ(n.edge[e.index], std::lround(c.model.length(e) / 2.0));
  EXPECT_EQ(n.n_layers, 15);
}

TEST(AssignIntervals, LayersAreExact) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Case c = upright(shape);
    for (const int layers : {3, 8, 21}) {
      Context context;
      const Intervals n =
          assign_intervals(c.model, c.scheme, {.size = 3.0, .layers = layers}, context);
      expect_consistent(c, n);
      EXPECT_EQ(n.n_layers, layers);
    }
  }
}

TEST(AssignIntervals, UsersCountsAndSizesOnEdges) {
  const Case c = upright(step_block());
  for (const EdgeId e : c.model.edges()) {
    Context context;
    const Intervals fixed =
        assign_intervals(c.model, c.scheme, {.size = 4.0, .edge_count = {{e, 6}}}, context);
    EXPECT_EQ(fixed.edge[e.index], 6) << name_of(e);
    expect_consistent(c, fixed);
    const Intervals finer =
        assign_intervals(c.model, c.scheme, {.size = 4.0, .edge_size = {{e, 0.5}}}, context);
    const Intervals plain = assign_intervals(c.model, c.scheme, {.size = 4.0}, context);
    EXPECT_GT(finer.edge[e.index], plain.edge[e.index]) << name_of(e);
    EXPECT_NEAR(finer.edge[e.index], c.model.length(e) / 0.5, 1.5) << name_of(e);
    expect_consistent(c, finer);
  }
}

TEST(AssignIntervals, PairsOfEdgesGetEqualCounts) {
  const Case c = upright(testing::box(10, 20, 30));
  IntervalOptions options{.size = 2.0};
  options.equal_edges = {{c.model.edges()[0], c.model.edges()[1]}};
  Context context;
  const Intervals n = assign_intervals(c.model, c.scheme, options, context);
  EXPECT_EQ(n.edge[c.model.edges()[0].index], n.edge[c.model.edges()[1].index]);
  expect_consistent(c, n);
}

TEST(AssignIntervals, HolesLieInsideTheirFaces) {
  const Case c = upright(window_block());
  int n_checked = 0;
  for (const double size : {1.0, 3.0, 9.0, 40.0}) {
    Context context;
    const Intervals n = assign_intervals(c.model, c.scheme, {.size = size}, context);
    for (const FaceId f : c.model.faces()) {
      const auto& loops = c.model.loops(f);
      if (loops.size() != 2) continue;
      int width = 0, least = 0, most = 0, i = n.loop_i[f.index][1];
      for (const Coedge& edge : loops[0])
        width = std::max(
            width, n.k[edge.start.index] == n.k[edge.end.index] ? n.edge[edge.edge.index] : 0);
      least = most = i;
      for (std::size_t j = 0; j < 4; ++j) {
        const Direction d = c.scheme.face[f.index].direction[1][j];
        if (d == Direction::plus_i) i += n.edge[loops[1][j].edge.index];
        if (d == Direction::minus_i) i -= n.edge[loops[1][j].edge.index];
        least = std::min(least, i);
        most = std::max(most, i);
        EXPECT_GT(n.k[loops[1][j].start.index], 0);
        EXPECT_LT(n.k[loops[1][j].start.index], n.n_layers);
      }
      // Relative to the first vertex of loop 0, the outer loop spans `width` to one side or the
      // other.
      EXPECT_LT(most - least, width);
      EXPECT_TRUE((least > 0 && most < width) || (least > -width && most < 0))
          << least << ' ' << most;
      ++n_checked;
    }
  }
  EXPECT_EQ(n_checked, 8);
}

template <class E>
E thrown_by(const Case& c, const IntervalOptions& options) {
  Context context;
  try {
    assign_intervals(c.model, c.scheme, options, context);
  } catch (const E& e) {
    return e;
  }
  ADD_FAILURE() << "nothing of that type was thrown";
  return E("", "");
}

TEST(AssignIntervals, ContradictionNamesItsEdgesAndFaces) {
  const Case c = upright(testing::box(10, 20, 30));
  std::vector<EdgeId> along_x;
  for (const EdgeId e : c.model.edges())
    if (std::abs(c.model.tangent(e, c.model.range(e).first).x()) > 0.9) along_x.push_back(e);
  ASSERT_EQ(along_x.size(), 4u);
  std::sort(along_x.begin(), along_x.end(), [&](EdgeId a, EdgeId b) {
    const Point3 p = c.model.point(c.model.start(a)), q = c.model.point(c.model.start(b));
    return std::make_pair(p.y(), p.z()) < std::make_pair(q.y(), q.z());
  });  // the first two bound the same linking face from below and above
  const auto e =
      thrown_by<SolverError>(c, {.size = 2.0, .edge_count = {{along_x[0], 3}, {along_x[1], 5}}});
  EXPECT_EQ(e.stage(), "intervals");
  EXPECT_EQ(e.entities().size(), 3u);
  const auto names = e.entities();
  EXPECT_NE(std::find(names.begin(), names.end(), name_of(along_x[0])), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), name_of(along_x[1])), names.end());
}

TEST(AssignIntervals, OddRimOfOneEdgeIsAContradiction) {
  const Case c = upright(BRepPrimAPI_MakeCylinder(5, 20).Shape());
  for (const EdgeId e : c.model.edges()) {
    if (c.model.start(e) != c.model.end(e)) continue;
    const auto error = thrown_by<SolverError>(c, {.size = 2.0, .edge_count = {{e, 7}}});
    EXPECT_FALSE(error.entities().empty());
    Context context;
    const IntervalOptions prisms{.size = 2.0, .edge_count = {{e, 7}}, .quad_caps = false};
    EXPECT_EQ(assign_intervals(c.model, c.scheme, prisms, context).edge[e.index], 7);
  }
}

/// A C that lies on its back: a slot, 20 deep, opens to the left of a block 30 wide.
TopoDS_Shape slotted_block() {
  const std::vector<std::pair<double, double>> corners = {{0, 0},  {30, 0},  {30, 30}, {0, 30},
                                                          {0, 20}, {20, 20}, {20, 10}, {0, 10}};
  std::vector<gp_Pnt> points;
  for (const auto& [x, z] : corners) points.emplace_back(x, 0.0, z);
  return testing::prism({points}, gp_Vec(0, 9, 0));
}

/// As many mesh edges along the slot as along the whole block leave nothing behind the slot.
TEST(AssignIntervals, OrderThatCannotBeKeptNamesWhatContradictsIt) {
  const Case c = upright(slotted_block());
  IntervalOptions options{.size = 4.0};
  for (const EdgeId e : c.model.edges()) {
    const Point3 t = c.model.tangent(e, c.model.range(e).first);
    if (std::abs(t.x()) > 0.9) options.edge_count[e] = 6;
  }
  Context context;
  const Intervals n = assign_intervals(c.model, c.scheme, options, context);
  expect_consistent(c, n);
  EXPECT_NE(n.unmet.find("must have 6 mesh edges"), std::string::npos) << n.unmet;
  EXPECT_TRUE(n.unmet.ends_with("."));
  int n_faces = 0, n_edges = 0;
  for (const std::string& name : n.unmet_entities) {
    n_faces += name.starts_with("Face");
    n_edges += name.starts_with("Edge");
  }
  EXPECT_GE(n_faces, 1);
  EXPECT_GE(n_edges, 2);
  const Intervals free = assign_intervals(c.model, c.scheme, {.size = 4.0}, context);
  EXPECT_TRUE(free.unmet.empty() && free.unmet_entities.empty());
}

/// A wall with rows of windows of different sizes: whole numbers that take some search.
TopoDS_Shape wall_of_windows() {
  const auto rectangle = [](double x, double z, double dx, double dz) {
    return std::vector<gp_Pnt>{{x, 0, z}, {x + dx, 0, z}, {x + dx, 0, z + dz}, {x, 0, z + dz}};
  };
  std::vector<std::vector<gp_Pnt>> loops = {rectangle(0, 0, 83, 61)};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      loops.push_back(rectangle(7 + 19.3 * column + 1.7 * row, 6 + 17.1 * row + 1.3 * column,
                                9.1 + 0.7 * row, 8.3 + 0.9 * column));
  return testing::prism(loops, gp_Vec(0, 9, 0));
}

/// The clock decides how far the solver comes: whatever it is, the answer is whole or a sentence.
TEST(AssignIntervals, TheBestSolutionInTimeIsUsedAndReported) {
  int n_cut_short = 0;
  const Case c = upright(wall_of_windows());
  for (const double limit : {1e-6, 1e-4, 1e-3, 1e-2})
    for (const double size : {0.9, 2.9}) {
      SCOPED_TRACE(limit);
      Context context;
      const IntervalOptions options{.size = size, .layers = 31, .time_limit_seconds = limit};
      try {
        const Intervals n = assign_intervals(c.model, c.scheme, options, context);
        expect_consistent(c, n);
        n_cut_short += !n.is_optimal;
      } catch (const SolverError& error) {  // nothing at all was found by then
        EXPECT_TRUE(std::string(error.what()).ends_with("."));
        ++n_cut_short;
      }
    }
  EXPECT_GT(n_cut_short, 0);
}

TEST(AssignIntervals, TooFewLayersForTheLevels) {
  const Case c = upright(step_block());
  thrown_by<SolverError>(c, {.size = 2.0, .layers = 1});
}

TEST(AssignIntervals, RefusesSenselessOptions) {
  const Case c = upright(testing::box(10, 20, 30));
  const EdgeId edge = c.model.edges()[0], unknown{99};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  thrown_by<InputError>(c, {.size = 0.0});
  thrown_by<InputError>(c, {.size = -1.0});
  thrown_by<InputError>(c, {.size = nan});
  thrown_by<InputError>(c, {.size = 1e-12});
  thrown_by<InputError>(c, {.size = 1.0, .layers = 0});
  thrown_by<InputError>(c, {.size = 1.0, .edge_size = {{edge, 0.0}}});
  thrown_by<InputError>(c, {.size = 1.0, .edge_count = {{edge, 0}}});
  thrown_by<InputError>(c, {.size = 1.0, .edge_count = {{unknown, 2}}});
  thrown_by<InputError>(c, {.size = 1.0, .edge_bias = {{edge, Bias{0.0}}}});
  thrown_by<InputError>(c, {.size = 1.0, .sweep_bias = Bias{-1.0}});
  thrown_by<InputError>(c, {.size = 1.0, .equal_edges = {{edge, unknown}}});
  thrown_by<InputError>(c, {.size = 1.0, .max_turn = 0.0});
}

TEST(ExpectedElements, GrowsWithTheCubeOfTheInverseSize) {
  const Model model = model_of(testing::box(10, 20, 30));
  EXPECT_NEAR(expected_elements(model, {.size = 1.0}), 6000.0, 1e-6);
  EXPECT_NEAR(expected_elements(model, {.size = 1e-3}), 6e12, 1e3);
  EXPECT_EQ(expected_elements(model, {.size = 1e6}), 12.0);
}

TEST(AssignIntervals, ManySidesAreNoCliff) {
  const Case c = upright(testing::regular_prism(660, 300, 10));
  Context context;
  const Intervals n = assign_intervals(c.model, c.scheme, {.size = 1.3}, context);
  expect_consistent(c, n);
  EXPECT_TRUE(n.is_optimal);
}

}  // namespace
}  // namespace sweepmesh
