// Plane meshes of given boundaries: invariants over families, determinism, errors.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <thread>

#include "cap_shapes.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/numerics/gmsh/temporary_directory.h"
#include "sweepmesh/numerics/gmsh/worker.h"
#include "sweepmesh/surface/delaunay_quads.h"
#include "sweepmesh/surface/quad_cleanup.h"
#include "sweepmesh/surface/quad_mesher.h"
#include "sweepmesh/surface/regular_cells.h"

namespace sweepmesh {
namespace {

using namespace test;

double area_of(const PlanarMesh& mesh, int c) {
  std::vector<Point2> corners;
  for (const int node : mesh.cell(c)) corners.push_back(mesh.points[node]);
  return signed_area(corners);
}

/// Every inside edge has a cell on either side, the edges with one side are the loops' own.
void expect_mesh_of(const PlanarLoops& loops, const PlanarMesh& mesh, std::size_t cell_size) {
  const std::vector<Point2> boundary = flattened(loops);
  ASSERT_EQ(mesh.n_boundary, static_cast<int>(boundary.size()));
  for (int i = 0; i < mesh.n_boundary; ++i) EXPECT_EQ(mesh.points[i], boundary[i]);
  std::map<std::pair<int, int>, int> sides;
  double area = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    ASSERT_EQ(cell.size(), cell_size);
    EXPECT_GT(scaled_jacobian(mesh.points, cell), 0.0);
    area += area_of(mesh, c);
    for (std::size_t i = 0; i < cell.size(); ++i)
      EXPECT_EQ((++sides[{cell[i], cell[(i + 1) % cell.size()]}]), 1) << "an edge is used twice";
  }
  double expected_area = 0.0;
  int first = 0;
  std::map<std::pair<int, int>, int> border;
  for (const auto& loop : loops) {
    expected_area += signed_area(loop);
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) border[{first + i, first + (i + 1) % n}] = 1;
    first += n;
  }
  EXPECT_NEAR(area, expected_area, 1e-9 * expected_area);
  for (const auto& [edge, count] : sides)
    EXPECT_NE(sides.contains({edge.second, edge.first}), border.contains(edge));
  for (const auto& [edge, one] : border) EXPECT_TRUE(sides.contains(edge));
}

class CapOutlines : public testing::TestWithParam<Outline> {};

TEST_P(CapOutlines, quads_fill_the_domain_and_keep_its_boundary) {
  Context context;
  PlanarMeshOptions options;
  options.size = GetParam().size;
  const PlanarMesh mesh = mesh_planar(GetParam().loops, options, context);
  expect_mesh_of(GetParam().loops, mesh, 4);
  const PlanarQuality q = quality(mesh.points, mesh);
  EXPECT_GT(q.min, 0.35);
  EXPECT_GT(q.mean, 0.85);
}

TEST_P(CapOutlines, triangles_fill_the_domain_and_keep_its_boundary) {
  Context context;
  PlanarMeshOptions options;
  options.size = GetParam().size;
  options.kind = CellKind::triangle;
  const PlanarMesh mesh = mesh_planar(GetParam().loops, options, context);
  expect_mesh_of(GetParam().loops, mesh, 3);
  EXPECT_GT(quality(mesh.points, mesh).min, 0.25);
}

TEST_P(CapOutlines, paired_delaunay_triangles_fill_the_domain_without_another_mesher) {
  Context context;
  const auto quads = delaunay_quads(GetParam().loops, GetParam().size);
  ASSERT_TRUE(quads);
  const BoundaryAngles angles = {interior_angles(GetParam().loops)};
  const auto cleaned = [&](const PlanarMesh& mesh) {
    return smoothed(with_regular_valences(smoothed(mesh, {}, context), angles), {}, context);
  };
  PlanarMesh mesh = cleaned(*quads);
  const PlanarMesh ringed = cleaned(with_rings(mesh, GetParam().loops, angles));
  if (overall_quality(ringed) > overall_quality(mesh)) mesh = ringed;
  expect_mesh_of(GetParam().loops, mesh, 4);
  EXPECT_GT(quality(mesh.points, mesh).mean, 0.6);
}

TEST_P(CapOutlines, same_input_gives_the_same_mesh) {
  PlanarMeshOptions options;
  options.size = GetParam().size;
  Context one(1), many(4);
  const PlanarMesh a = mesh_planar(GetParam().loops, options, one);
  const PlanarMesh b = mesh_planar(GetParam().loops, options, many);
  EXPECT_EQ(a.cell_nodes, b.cell_nodes);
  EXPECT_EQ(a.points, b.points);
}

INSTANTIATE_TEST_SUITE_P(Families, CapOutlines, testing::ValuesIn(outlines()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(CapPlanar, a_rectangle_is_mapped) {
  Context context;
  PlanarMeshOptions options;
  options.size = 2.0;
  const PlanarMesh mesh = mesh_planar({rectangle({0, 0}, {20, 10}, 2)}, options, context);
  EXPECT_EQ(mesh.n_cells(), 50);
  EXPECT_NEAR(quality(mesh.points, mesh).min, 1.0, 1e-6);
}

TEST(CapPlanar, a_disc_has_no_flat_corner_at_its_boundary) {
  Context context;
  PlanarMeshOptions options;
  for (const int n : {12, 18, 40, 62}) {
    options.size = 2.0 * pi * 10.0 / n;
    const PlanarMesh mesh = mesh_planar({circle(n, 10, {0, 0})}, options, context);
    const NodeCells at = cells_at_nodes(mesh);
    for (int i = 0; i < mesh.n_boundary; ++i) EXPECT_GE(at.of(i).size(), 2u);
    EXPECT_GT(quality(mesh.points, mesh).min, 0.6);
  }
}

TEST(CapPlanar, a_stretched_metric_makes_cells_square_on_the_surface) {
  Context context;
  PlanarMeshOptions options;
  options.size = 2.0;
  const Eigen::Matrix2d stretch = Point2(2.0, 1.0).asDiagonal();
  options.metric = [&](const Point2&) { return stretch; };
  const PlanarLoops loops = {moved(circle(40, 10, {0, 0}), {0, 0}, 0, 1, {0, 0})};
  const PlanarMesh mesh = mesh_planar(loops, options, context);
  EXPECT_GT(quality(mesh.points, mesh, options.metric).min, 0.5);
}

TEST(CapPlanar, triangles_left_over_are_paired_whatever_their_distance) {
  // A row of quads with a triangle at either end.
  for (int n : {1, 2, 7, 40}) {
    PlanarMesh mesh;
    for (int i = 0; i <= n; ++i) mesh.points.insert(mesh.points.end(), {{i, 0}, {i, 1}});
    mesh.points.insert(mesh.points.end(), {{-0.8, 0.5}, {n + 0.8, 0.5}});
    mesh.n_boundary = mesh.n_nodes();
    mesh.add_cell(std::vector<int>{0, 1, 2 * n + 2});
    for (int i = 0; i < n; ++i)
      mesh.add_cell(std::vector<int>{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    mesh.add_cell(std::vector<int>{2 * n + 1, 2 * n, 2 * n + 3});
    const auto quads = with_triangles_paired(mesh);
    ASSERT_TRUE(quads);
    EXPECT_EQ(quads->n_cells(), n + 1);
    for (int c = 0; c < quads->n_cells(); ++c) EXPECT_EQ(quads->cell(c).size(), 4u);
  }
}

TEST(CapPlanar, one_triangle_alone_cannot_be_paired) {
  PlanarMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.n_boundary = 3;
  mesh.add_cell(std::vector<int>{0, 1, 2});
  EXPECT_FALSE(with_triangles_paired(mesh));
}

TEST(CapPlanar, refining_triangles_gives_quads_on_the_finer_boundary) {
  const PlanarLoops fine = {circle(12, 5, {0, 0})};
  PlanarMesh coarse;
  for (int i = 0; i < 12; i += 2) coarse.points.push_back(fine[0][i]);
  coarse.n_boundary = 6;
  coarse.points.emplace_back(0, 0);
  for (int i = 0; i < 6; ++i) coarse.add_cell(std::vector<int>{i, (i + 1) % 6, 6});
  expect_mesh_of(fine, refined_to_quads(coarse, fine), 4);
}

TEST(CapPlanar, bad_input_is_refused) {
  Context context;
  PlanarMeshOptions options;
  const auto square = rectangle({0, 0}, {10, 10}, 2);
  EXPECT_THROW(mesh_planar({}, options, context), InputError);
  EXPECT_THROW(mesh_planar({{{0, 0}, {1, 0}}}, options, context), InputError);
  EXPECT_THROW(mesh_planar({as_hole(square)}, options, context), InputError);
  EXPECT_THROW(mesh_planar({square, circle(8, 2, {5, 5})}, options, context), InputError);
  EXPECT_THROW(mesh_planar({square, as_hole(circle(8, 3, {8, 5}))}, options, context), InputError);
  EXPECT_THROW(mesh_planar({circle(21, 10, {0, 0})}, options, context), InputError);
  for (const double size : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.size = size;
    EXPECT_THROW(mesh_planar({square}, options, context), InputError);
  }
}

TEST(CapPlanar, a_cancelled_run_stops) {
  Context context;
  context.cancel();
  PlanarMeshOptions options;
  options.size = 1.0;
  EXPECT_THROW(mesh_planar({gear_outline(20)}, options, context), Cancelled);
}

/// A worker that answers as the shell's commands say.
std::string fake_worker(const TemporaryDirectory& directory, const std::string& commands) {
  const auto file = directory.path() / "worker";
  std::ofstream(file) << "#!/bin/sh\n" << commands << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file.string();
}

TEST(GmshWorker, tells_the_status_of_each_job) {
  const Context context;
  const TemporaryDirectory directory;
  GmshWorker worker(
      fake_worker(directory, "n=0; while read d; do n=$((n + 1)); echo $n >&0; done"));
  EXPECT_EQ(worker.run(directory.path(), context), 1);
  EXPECT_EQ(worker.run(directory.path(), context), 2);
}

TEST(GmshWorker, goes_on_after_a_job_that_failed) {
  const Context context;
  const TemporaryDirectory full;
  std::ofstream(full.path() / "cap.geo")
      << "Point(1)={0,0,0,1};Point(2)={1,0,0,1};Point(3)={0,1,0,1};"
         "Line(1)={1,2};Line(2)={2,3};Line(3)={3,1};Line Loop(4)={1:3};Plane Surface(1)={4};";
  GmshWorker worker;
  EXPECT_NE(worker.run(full.path() / "nowhere", context), 0);
  EXPECT_EQ(worker.run(full.path(), context), 0);
  EXPECT_TRUE(std::filesystem::exists(full.path() / "cap.msh"));
}

TEST(GmshWorker, its_absence_and_its_end_are_told) {
  const Context context;
  const TemporaryDirectory directory;
  EXPECT_THROW(GmshWorker("no-such-program-anywhere"), SolverError);
  GmshWorker worker(fake_worker(directory, "read d; kill -SEGV $$"));
  EXPECT_THROW(worker.run(directory.path(), context), SolverError);
  EXPECT_THROW(worker.run(directory.path(), context), SolverError);
}

TEST(GmshWorker, is_not_waited_for_when_cancelled) {
  Context context;
  const TemporaryDirectory directory;
  std::thread watcher([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    context.cancel();
  });
  const auto start = std::chrono::steady_clock::now();
  {
    GmshWorker worker(fake_worker(directory, "read d; sleep 30"));
    EXPECT_THROW(worker.run(directory.path(), context), Cancelled);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  watcher.join();
}

TEST(TemporaryDirectory, goes_with_its_owner) {
  std::filesystem::path path;
  {
    const TemporaryDirectory directory;
    path = directory.path();
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace sweepmesh
