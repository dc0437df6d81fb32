// One row for every method of placement on one solid: inverted elements, least and mean scaled
// Jacobian, seconds. All start from the same mesh of the boundary.
//
//     sweepmesh_bench_methods [--quick] NAME SHAPE SIZE [source x y z ...] [target x y z ...]
//
// Points pick the faces nearest to them. --quick leaves out the methods that take every pair of
// an inner and a boundary node.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/scheme_mesh.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/volume/assemble.h"
#include "sweepmesh/volume/place.h"

namespace {

using namespace sweepmesh;

Picks read_picks(const Model& model, int argc, char** argv) {
  Picks picks;
  for (int i = 4; i + 3 < argc; i += 4) {
    const Point3 p(std::atof(argv[i + 1]), std::atof(argv[i + 2]), std::atof(argv[i + 3]));
    auto& list = std::strcmp(argv[i], "source") == 0 ? picks.sources : picks.targets;
    list.push_back(model.nearest_face(p));
  }
  return picks;
}

Assembly assemble_boundary(const Model& model, const Picks& picks, double size, Context& context) {
  const Assessment assessment = assess(model, picks, context);
  if (!assessment.is_sweepable()) throw InputError("assess", assessment.reasons.front().text);
  const Scheme& scheme = assessment.schemes.front();
  const SweepOptions options{.size = size};
  const auto [match, counts] = lay_out(model, scheme, options, size, context);
  const BoundaryMesh boundary =
      mesh_matched(model, scheme, match, counts, interval_options(model, options, size),
                   CellKind::quad, context);
  return assemble(boundary.surface, boundary.columns, boundary.runs);
}

void print_row(const char* name, const Assembly& assembly, PlacementMethod method) {
  Points points = assembly.points;
  PlacementOptions options;
  options.method = method;
  Context context;
  std::string note;
  const auto start = std::chrono::steady_clock::now();
  try {
    place_interior(assembly.extrusion, assembly.fixed, points, options, context);
  } catch (const InvalidMeshError& e) {
    note = e.what();
  } catch (const Error& e) {
    std::printf("%-30s %-18s %7s %7s %8s %8s %8s  %s\n", name, name_of(method).c_str(), "-", "-",
                "-", "-", "-", e.what());
    return;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const QualityReport q = measure_quality(assembly.extrusion, points, {}, context);
  std::printf("%-30s %-18s %7ld %7ld %8.4f %8.4f %8.3f  %s\n", name, name_of(method).c_str(),
              q.n_elements, q.n_inverted, q.scaled_jacobian.min, q.scaled_jacobian.mean,
              seconds.count(), note.c_str());
  std::fflush(stdout);
}

bool takes_every_pair(PlacementMethod method) {
  return method == PlacementMethod::mean_value || method == PlacementMethod::green;
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  if (is_quick) --argc, ++argv;
  if (argc < 4) return 2;
  try {
    Context context;
    const Model model = Model::from_file(argv[2]);
    const Assembly assembly =
        assemble_boundary(model, read_picks(model, argc, argv), std::atof(argv[3]), context);
    for (const PlacementMethod method : all_placement_methods())
      if (!is_quick || !takes_every_pair(method)) print_row(argv[1], assembly, method);
  } catch (const Error& e) {
    std::printf("%-30s %s: %s\n", argv[1], e.stage().c_str(), e.what());
  }
}
