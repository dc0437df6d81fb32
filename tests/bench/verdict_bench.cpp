// Time of the whole verdict (assess_or_divide) against the number of faces, for solids that can be
// swept, that have to be divided along their rounds first, and that are refused: at once, or after
// schemes with poor angles were laid out. Prints one line a solid: what came of it, faces,
// milliseconds (least of three runs of processor time), and milliseconds a face. CAD files named on
// the command line follow.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "sweepmesh/pipeline/divided_sweep.h"
#include "to_model.h"

namespace {

using namespace sweepmesh;

constexpr double pitch = 20;

TopoDS_Shape block(double x, double y, double z, double a, double b, double c) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), a, b, c).Shape();
}

TopoDS_Shape rod(const gp_Pnt& foot, const gp_Dir& axis, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, axis), radius, height).Shape();
}

Model with_tools(const TopoDS_Shape& base, const TopTools_ListOfShape& tools,
                 BRepAlgoAPI_BooleanOperation&& boolean) {
  TopTools_ListOfShape arguments;
  arguments.Append(base);
  boolean.SetArguments(arguments);
  boolean.SetTools(tools);
  boolean.Build();
  ShapeUpgrade_UnifySameDomain unify(boolean.Shape(), true, true, false);
  unify.Build();
  return test::to_model(unify.Shape());
}

/// Runs `add(x, y, i, j)` over an n x n grid and gives the slab below it.
template <class Add>
TopoDS_Shape slab(int n, double thickness, Add&& add) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) add(pitch * i, pitch * j, i, j);
  return block(0, 0, 0, pitch * n, pitch * n, thickness);
}

/// Bosses above and below whose outlines cross.
Model terraced(int n) {
  TopTools_ListOfShape tools;
  const TopoDS_Shape base = slab(n, 10, [&](double x, double y, int i, int j) {
    tools.Append(block(x + 2, y + 3, 10, 12, 12, 4 + (3 * i + 5 * j) % 7));
    tools.Append(block(x + 6, y + 7, -4 - (2 * i + 7 * j) % 5, 12, 12, 10));
  });
  return with_tools(base, tools, BRepAlgoAPI_Fuse());
}

/// A bar with bores from above, and others across it.
Model drilled(int n) {
  TopTools_ListOfShape tools;
  for (int i = 0; i < n; ++i) {
    tools.Append(rod({pitch * (i + 0.25), 10, -1}, {0, 0, 1}, 3, 30));
    tools.Append(rod({pitch * (i + 0.75), -1, 10}, {0, 1, 0}, 3, 30));
  }
  return with_tools(block(0, 0, 0, pitch * n, 20, 20), tools, BRepAlgoAPI_Cut());
}

/// Hollows within: nothing links their walls.
Model hollow(int n) {
  TopTools_ListOfShape tools;
  const TopoDS_Shape base = slab(n, 20, [&](double x, double y, int, int) {
    tools.Append(BRepPrimAPI_MakeSphere(gp_Pnt(x + 10, y + 10, 10), 4).Shape());
  });
  return with_tools(base, tools, BRepAlgoAPI_Cut());
}

/// Posts that lean far over, to all sides, above and below.
Model leaning(int n) {
  TopTools_ListOfShape tools;
  const TopoDS_Shape base = slab(n, 6, [&](double x, double y, int i, int j) {
    const double a = (i + j) % 2 ? 1 : 0, sign = i % 2 ? 1 : -1;
    tools.Append(rod({x + 10, y + 10, 3}, {sign * a, sign * (1 - a), 0.35}, 2, 12));
    tools.Append(rod({x + 10, y + 10, 3}, {sign * a, sign * (1 - a), -0.35}, 2, 12));
  });
  return with_tools(base, tools, BRepAlgoAPI_Fuse());
}

/// Cones let into all sides of a bar.
Model countersunk(int n) {
  TopTools_ListOfShape tools;
  const auto cone = [&](const gp_Pnt& foot, const gp_Dir& axis) {
    tools.Append(BRepPrimAPI_MakeCone(gp_Ax2(foot, axis), 4, 1, 6).Shape());
  };
  for (int i = 0; i < n; ++i) {
    cone({pitch * (i + 0.5), 10, 0}, {0, 0, 1});
    cone({pitch * (i + 0.5), 0, 10}, {0, 1, 0});
    cone({pitch * (i + 0.5), 20, 10}, {0, -1, 0});
  }
  return with_tools(block(0, 0, 0, pitch * n, 20, 20), tools, BRepAlgoAPI_Cut());
}

const char* outcome_of(const Model& model, const Assessment& verdict) {
  if (!verdict.is_sweepable()) return "refused";
  const auto is_divided = [](FaceRole role) { return role == FaceRole::divided; };
  (void)model;
  return std::ranges::any_of(verdict.schemes.front().face_role, is_divided) ? "divided"
                                                                            : "sweepable";
}

void measure(const char* name, const Model& model) {
  double least = 1e9;
  const char* outcome = "";
  for (int i = 0; i < 3; ++i) {
    Context context;
    const std::clock_t start = std::clock();
    const Assessment verdict = assess_or_divide(model, {}, context);
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    outcome = outcome_of(model, verdict);
  }
  const std::size_t n = model.faces().size();
  std::printf("%-14s %-10s %6zu %10.1f %8.3f\n", name, outcome, n, 1e3 * least, 1e3 * least / n);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("%-14s %-10s %6s %10s %8s\n", "family", "verdict", "faces", "ms", "ms/face");
  for (const int n : {1, 2, 3, 4, 6}) measure("terraced", terraced(n));
  for (const int n : {1, 2, 4, 8, 16, 32}) measure("drilled", drilled(n));
  for (const int n : {2, 4, 8, 12}) measure("hollow", hollow(n));
  for (const int n : {1, 2, 4, 8, 16, 32}) measure("countersunk", countersunk(n));
  for (const int n : {1, 2, 3, 4, 6}) measure("leaning", leaning(n));
  for (int a = 1; a < argc; ++a) measure(argv[a], Model::from_file(argv[a]));
}
