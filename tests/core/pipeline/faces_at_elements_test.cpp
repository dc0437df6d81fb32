// Elements and the CAD faces beside them, on a box of 3 x 3 x 3 hexahedra.
#include "sweepmesh/pipeline/faces_at_elements.h"

#include <gtest/gtest.h>

#include <set>

#include "solids.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/pipeline/boundary.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {
namespace {

struct Meshed {
  BoundaryMesh boundary;
  Assembly assembly;
};

Meshed meshed_box() {
  const Model model = test::box(3, 3, 3);
  Context context;
  const Scheme scheme = assess(model, {}, context).schemes.front();
  IntervalOptions options;
  options.size = 1.0;
  const Intervals intervals = assign_intervals(model, scheme, options, context);
  Meshed out;
  out.boundary = mesh_boundary(model, scheme, intervals, options, CellKind::quad, context);
  out.assembly = assemble(out.boundary.surface, out.boundary.columns, out.boundary.runs);
  return out;
}

TEST(FacesAtElements, CornersHaveThreeFacesAndTheMiddleNone) {
  const Meshed box = meshed_box();
  std::multiset<std::size_t> counts;
  for (long e = 0; e < 27; ++e)
    counts.insert(faces_at_elements(box.boundary.surface, box.assembly, {e}).size());
  EXPECT_EQ(counts.count(3), 8u);
  EXPECT_EQ(counts.count(2), 12u);
  EXPECT_EQ(counts.count(1), 6u);
  EXPECT_EQ(counts.count(0), 1u);
}

TEST(FacesAtElements, AllElementsHaveAllFaces) {
  const Meshed box = meshed_box();
  std::vector<long> all(27);
  for (long e = 0; e < 27; ++e) all[e] = e;
  const auto names = faces_at_elements(box.boundary.surface, box.assembly, all);
  EXPECT_EQ(names.size(), 6u);
  EXPECT_EQ(names.front(), "Face1");
}

}  // namespace
}  // namespace sweepmesh
