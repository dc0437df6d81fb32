// Time of imprinting against the number of curves: a slab with bosses on both sides, whose outlines
// cross when seen along the sweep. Prints one line a solid: transverse edges, patches, milliseconds
// (least of three runs), and the time for each edge against that of the smallest solid.
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <chrono>
#include <cstdio>
#include <sstream>

#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/sweep_levels.h"
#include "sweepmesh/imprint/walls.h"
#include "terraces.h"
#include "to_model.h"

namespace {

using namespace sweepmesh;

/// n x n bosses above and as many below, moved by less than half of their side, at many levels.
Model bosses(int n) {
  constexpr double pitch = 20, side = 12, thickness = 10;
  const auto block = [](double x, double y, double z, double a, double b, double c) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), a, b, c).Shape();
  };
  TopTools_ListOfShape slab, tools;
  slab.Append(block(0, 0, 0, pitch * n + 6, pitch * n + 6, thickness));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double up = 4 + (3 * i + 5 * j) % 7, down = 4 + (2 * i + 7 * j) % 5;
      tools.Append(block(pitch * i + 3, pitch * j + 4, thickness, side, side, up));
      tools.Append(block(pitch * i + 7, pitch * j + 9, -down, side, side, down));
    }
  BRepAlgoAPI_Fuse fuse;
  fuse.SetArguments(slab);
  fuse.SetTools(tools);
  fuse.Build();
  ShapeUpgrade_UnifySameDomain unify(fuse.Shape(), true, true, false);
  unify.Build();
  return test::to_model(unify.Shape());
}

struct Timing {
  int n_edges;
  std::size_t n_patches;
  double seconds;
};

Timing measure(int n) {
  const Model model = bosses(n);
  const Scheme scheme = test::upright_scheme(model);
  const Context context;
  const ImprintOptions options{.size = 4.0};
  Timing run{static_cast<int>(find_walls(model, scheme, sweep_levels(model, scheme)).edges.size()),
             0, 1e9};
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run.n_patches = imprint_caps(model, scheme, options, context).patches.size();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    run.seconds = std::min(run.seconds, took.count());
  }
  return run;
}

}  // namespace

int main() {
  std::printf("%8s %8s %12s %14s\n", "edges", "patches", "ms", "ms per edge");
  for (const int n : {1, 2, 3, 4, 6, 8}) {
    const Timing run = measure(n);
    std::printf("%8d %8zu %12.2f %14.4f\n", run.n_edges, run.n_patches, 1e3 * run.seconds,
                1e3 * run.seconds / run.n_edges);
    std::fflush(stdout);
  }
}
