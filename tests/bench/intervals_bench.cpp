// Time of interval assignment and of the linking grids against the number of edges of one solid.
// Prints one line a solid: family, edges, unknown size, seconds (least of three runs).
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "simple_scheme.h"
#include "solids.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/surface/linking_faces.h"

namespace {

using namespace sweepmesh;
using namespace sweepmesh::testing;

/// A plate with n x n square holes, their sides of many lengths.
TopoDS_Shape perforated(int n) {
  const auto square = [](double x, double y, double a) {
    return std::vector<gp_Pnt>{gp_Pnt(x, y, 0), gp_Pnt(x + a, y, 0), gp_Pnt(x + a, y + a, 0),
                               gp_Pnt(x, y + a, 0)};
  };
  std::vector<std::vector<gp_Pnt>> loops{square(0, 0, 20.0 * n)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      loops.push_back(square(20 * i + 4, 20 * j + 4, 5 + (7 * i + 3 * j) % 8));
  return prism(loops, gp_Vec(0, 0, 10));
}

/// A staircase of n steps of many sizes: n + 1 levels, every side face of 2 n + 2 sides.
TopoDS_Shape stairs(int n) {
  std::vector<gp_Pnt> outline{gp_Pnt(0, 0, 0)};
  double x = 0.0, z = 0.0;
  std::vector<gp_Pnt> steps;
  for (int s = 0; s < n; ++s) {
    z += 4 + s % 5;
    steps.emplace_back(x, 0, z);
    x += 5 + s % 3;
    steps.emplace_back(x, 0, z);
  }
  outline.emplace_back(x, 0, 0);
  outline.insert(outline.end(), steps.rbegin(), steps.rend());
  return prism({outline}, gp_Vec(0, 15, 0));
}

/// A wall with n x n windows, every sill a source and every lintel a target.
TopoDS_Shape windows(int n) {
  const auto frame = [](double x, double z, double w, double h) {
    return std::vector<gp_Pnt>{gp_Pnt(x, 0, z), gp_Pnt(x + w, 0, z), gp_Pnt(x + w, 0, z + h),
                               gp_Pnt(x, 0, z + h)};
  };
  std::vector<std::vector<gp_Pnt>> loops{frame(0, 0, 20.0 * n, 20.0 * n)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      loops.push_back(frame(20 * i + 5, 20 * j + 5, 6 + (i + j) % 5, 6 + (2 * i + j) % 4));
  return prism(loops, gp_Vec(0, 8, 0));
}

double seconds(const std::function<void()>& work) {
  double least = 1e9;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  return least;
}

void measure(const std::string& family, const TopoDS_Shape& shape) {
  const Model model = model_of(shape);
  const Scheme scheme = simple_scheme(model, faces_facing(model, 1), faces_facing(model, -1));
  const IntervalOptions options{.size = 2.3};
  Context context;
  Intervals intervals;
  const double to_assign =
      seconds([&] { intervals = assign_intervals(model, scheme, options, context); });
  int n_cells = 0;
  const double to_mesh = seconds([&] {
    SurfaceMesh mesh;
    const auto edges =
        mesh_edges(model, intervals, place_edge_nodes(model, intervals, options), mesh);
    mesh_linking_faces(model, scheme, intervals, edges, context, mesh);
    n_cells = mesh.n_cells();
  });
  std::printf("%-12s %6zu edges %5d layers %8d quads  assign %8.3f s  mesh %8.3f s  %s\n",
              family.c_str(), model.edges().size(), intervals.n_layers, n_cells, to_assign, to_mesh,
              intervals.is_optimal ? "" : "time limit");
  std::fflush(stdout);
}

}  // namespace

int main() {
  for (const int n : {10, 40, 160, 660}) measure("polygon", regular_prism(n, n, 10));
  for (const int n : {2, 4, 8, 13}) measure("perforated", perforated(n));
  for (const int n : {5, 20, 80, 330}) measure("stairs", stairs(n));
  for (const int n : {2, 4, 8, 13}) measure("windows", windows(n));
}
