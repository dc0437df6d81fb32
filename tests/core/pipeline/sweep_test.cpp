// The whole pipeline over families of solids: what must be true of every swept mesh.
#include "sweepmesh/pipeline/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "named_cases.h"
#include "solids.h"

namespace sweepmesh {
namespace {

using Quad = std::array<int, 4>;

Quad sorted(Quad q) {
  std::sort(q.begin(), q.end());
  return q;
}

/// Faces of all hexahedra with the number of hexahedra at each.
std::map<Quad, int> quads_of(const VolumeMesh& mesh) {
  constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<Quad, int> count;
  for (const auto& hex : mesh.hexahedra)
    for (const auto& f : faces) ++count[sorted({hex[f[0]], hex[f[1]], hex[f[2]], hex[f[3]]})];
  return count;
}

/// Every inner quad has two hexahedra; every outer one is a boundary cell of a CAD face.
void expect_conforming(const VolumeMesh& mesh) {
  auto quads = quads_of(mesh);
  for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
    ASSERT_EQ(mesh.boundary_offset[c + 1] - mesh.boundary_offset[c], 4);
    const int* n = &mesh.boundary_nodes[mesh.boundary_offset[c]];
    ++quads[sorted({n[0], n[1], n[2], n[3]})];
  }
  for (const auto& [quad, n] : quads) ASSERT_EQ(n, 2);
}

double distance_to_owner(const Model& model, const Owner& owner, const Point3& p) {
  switch (owner.kind) {
    case EntityKind::vertex:
      return (model.point(VertexId{owner.index}) - p).norm();
    case EntityKind::edge:
      return model.distance(EdgeId{owner.index}, p);
    case EntityKind::face:
      return model.distance(FaceId{owner.index}, p);
  }
  return std::numeric_limits<double>::infinity();
}

void expect_on_cad(const Model& model, const VolumeMesh& mesh) {
  const long n = mesh.points.rows();
  const long stride = std::max(1L, n / 400);  // exact distances are slow; a sample is enough
  for (long i = 0; i < n; i += stride)
    if (mesh.owner[i].index >= 0) {
      EXPECT_LT(distance_to_owner(model, mesh.owner[i], mesh.points.row(i)),
                10 * model.tolerances().point);
    }
}

void expect_every_face_covered(const Model& model, const VolumeMesh& mesh) {
  std::map<FaceId, double> area;
  for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
    const int* n = &mesh.boundary_nodes[mesh.boundary_offset[c]];
    const auto p = [&](int i) { return Point3(mesh.points.row(n[i])); };
    area[mesh.boundary_face[c]] += (p(2) - p(0)).cross(p(3) - p(1)).norm() / 2;
  }
  for (const FaceId f : model.faces()) EXPECT_NEAR(area[f] / model.area(f), 1, 0.06) << name_of(f);
}

void expect_valid_sweep(const Model& model, const SweepResult& result) {
  ASSERT_TRUE(result.assessment.is_sweepable());
  ASSERT_FALSE(result.mesh.hexahedra.empty());
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_GT(result.quality.scaled_jacobian.min, 0);
  EXPECT_NEAR(result.quality.total_volume / model.volume(), 1, 0.05);
  expect_conforming(result.mesh);
  expect_on_cad(model, result.mesh);
  expect_every_face_covered(model, result.mesh);
}

SweepResult swept(const Model& model, const SweepOptions& options = {}, const Picks& picks = {}) {
  Context context;
  return sweep(model, picks, options, context);
}

class EverySweep : public testing::TestWithParam<test::NamedModel> {};

TEST_P(EverySweep, meshes_without_picks) {
  expect_valid_sweep(GetParam().model, swept(GetParam().model));
}

TEST_P(EverySweep, is_the_same_on_every_run_and_any_number_of_threads) {
  Context one(1), two(2);
  const SweepResult a = sweep(GetParam().model, {}, {}, one);
  const SweepResult b = sweep(GetParam().model, {}, {}, two);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.hexahedra, b.mesh.hexahedra);
}

TEST_P(EverySweep, second_order_keeps_the_corners_and_nears_the_volume) {
  SweepOptions options;
  const SweepResult first = swept(GetParam().model, options);
  options.order = 2;
  const SweepResult second = swept(GetParam().model, options);
  ASSERT_EQ(second.mesh.hexahedra, first.mesh.hexahedra);
  EXPECT_EQ(second.mesh.hexahedron_mid_nodes.size(), second.mesh.hexahedra.size());
  EXPECT_EQ(second.mesh.points.topRows(first.mesh.points.rows()), first.mesh.points);
  expect_on_cad(GetParam().model, second.mesh);
}

INSTANTIATE_TEST_SUITE_P(Prisms, EverySweep, testing::ValuesIn(test::prisms()), test::name_of_case);
INSTANTIATE_TEST_SUITE_P(General, EverySweep, testing::ValuesIn(test::general_one_to_one()),
                         test::name_of_case);

INSTANTIATE_TEST_SUITE_P(ManyToOne, EverySweep, testing::ValuesIn(test::many_to_one()),
                         test::name_of_case);

TEST(Sweep, size_and_layers_are_kept) {
  SweepOptions options;
  options.size = 2.5;
  options.layers = 7;
  Picks picks;
  const Model model = test::box(10, 10, 14);
  picks.sources = {model.nearest_face({5, 5, 14})};
  picks.targets = {model.nearest_face({5, 5, 0})};
  const SweepResult result = swept(model, options, picks);
  expect_valid_sweep(model, result);
  EXPECT_EQ(result.intervals.n_layers, 7);
  EXPECT_EQ(result.mesh.hexahedra.size(), 4u * 4u * 7u);
  EXPECT_EQ(result.assessment.schemes.front().face_role[picks.sources[0].index], FaceRole::source);
}

TEST(Sweep, solids_without_a_sweep_are_refused_with_reasons) {
  for (const auto& [name, model] : test::unsweepable()) {
    if (name == "box with a ball cut out") continue;  // is divided along its rounds
    SCOPED_TRACE(name);
    const SweepResult result = swept(model);
    EXPECT_FALSE(result.assessment.is_sweepable());
    EXPECT_FALSE(result.assessment.reasons.empty());
    EXPECT_TRUE(result.mesh.hexahedra.empty());
  }
}

TEST(Sweep, options_that_make_no_sense_are_refused) {
  const Model model = test::box(1, 1, 1);
  for (const double size :
       {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-6}) {
    SweepOptions options;
    options.size = size;
    EXPECT_THROW(swept(model, options), InputError) << size;
  }
  SweepOptions layers;
  layers.layers = 0;
  EXPECT_THROW(swept(model, layers), InputError);
  SweepOptions order;
  order.order = 3;
  EXPECT_THROW(swept(model, order), InputError);
  Picks picks;
  picks.sources = picks.targets = {FaceId{0}};
  EXPECT_THROW(swept(model, {}, picks), InputError);
  picks.targets = {FaceId{99}};
  EXPECT_THROW(swept(model, {}, picks), InputError);
}

TEST(Sweep, cancel_ends_it) {
  Context context;
  context.cancel();
  EXPECT_THROW(sweep(test::box(1, 1, 1), {}, {}, context), Cancelled);
}

}  // namespace
}  // namespace sweepmesh
