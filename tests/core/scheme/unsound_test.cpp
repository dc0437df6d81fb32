// Solids that are not sound, made by breaking sound ones at random: each has a verdict or a typed
// error, in bounded time.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <ctime>
#include <gp_Ax2.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <sstream>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {
namespace {

/// Of the processor, so that a busy machine does not count.
constexpr double kMostSeconds = 2.0;

using Random = std::mt19937;

int below(Random& random, int n) {
  return static_cast<int>(random() % static_cast<unsigned>(n));
}

gp_Ax2 at(double x, double y, double z) {
  return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)};
}

TopoDS_Shape bored_block() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 8, 6).Shape(),
                         BRepPrimAPI_MakeCylinder(at(5, 4, -1), 2, 8).Shape())
      .Shape();
}

TopoDS_Shape hollow_ball() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(10).Shape(), BRepPrimAPI_MakeSphere(4).Shape())
      .Shape();
}

/// The same, cut in halves through the poles of its faces.
TopoDS_Shape half_hollow_ball() {
  const TopoDS_Shape half = BRepPrimAPI_MakeBox(gp_Pnt(0, -20, -20), gp_Pnt(20, 20, 20)).Shape();
  return BRepAlgoAPI_Cut(hollow_ball(), half).Shape();
}

/// Two boxes that share one edge only: four faces meet there.
TopoDS_Shape boxes_at_an_edge() {
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(2, 2, 2).Shape(),
                          BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 0), 2, 2, 2).Shape())
      .Shape();
}

std::vector<TopoDS_Shape> sound_shapes() {
  return {BRepPrimAPI_MakeBox(3, 2, 1).Shape(),
          BRepPrimAPI_MakeCylinder(2, 5).Shape(),
          BRepPrimAPI_MakeCone(4, 2, 5).Shape(),
          BRepPrimAPI_MakeCone(4, 0, 5).Shape(),
          BRepPrimAPI_MakeSphere(5).Shape(),
          BRepPrimAPI_MakeTorus(6, 2).Shape(),
          bored_block(),
          hollow_ball(),
          half_hollow_ball(),
          boxes_at_an_edge()};
}

std::vector<TopoDS_Shape> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> out;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) out.push_back(e.Current());
  return out;
}

TopoDS_Shell shell_of(const std::vector<TopoDS_Shape>& faces) {
  BRep_Builder builder;
  TopoDS_Shell out;
  builder.MakeShell(out);
  for (const TopoDS_Shape& f : faces) builder.Add(out, f);
  return out;
}

TopoDS_Shape solid_of(const std::vector<TopoDS_Shell>& shells) {
  BRep_Builder builder;
  TopoDS_Solid out;
  builder.MakeSolid(out);
  for (const TopoDS_Shell& s : shells) builder.Add(out, s);
  return out;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x) {
  gp_Trsf by;
  by.SetTranslation(gp_Vec(x, 0, 0));
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

TopoDS_Shape squashed(const TopoDS_Shape& shape, double by) {
  gp_GTrsf scale;
  scale.SetValue(3, 3, by);
  return BRepBuilderAPI_GTransform(shape, scale, true).Shape();
}

/// One of the faces left out, turned round, twice there, a little off, or of a solid far away.
std::vector<TopoDS_Shape> with_a_broken_face(std::vector<TopoDS_Shape> faces, Random& random) {
  const int f = below(random, static_cast<int>(faces.size()));
  const TopoDS_Shape face = faces[f];
  switch (below(random, 5)) {
    case 0:
      faces.erase(faces.begin() + f);
      break;
    case 1:
      faces[f] = face.Reversed();
      break;
    case 2:
      faces.push_back(face);
      break;
    case 3:
      faces[f] = moved(face, 1e-4);
      break;
    default:
      faces[f] = moved(face, 100.0);
  }
  return faces;
}

TopoDS_Shape inside_out(const std::vector<TopoDS_Shape>& faces) {
  std::vector<TopoDS_Shape> turned;
  for (const TopoDS_Shape& f : faces) turned.push_back(f.Reversed());
  return solid_of({shell_of(turned)});
}

TopoDS_Shape compound_of(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  BRep_Builder builder;
  TopoDS_Compound out;
  builder.MakeCompound(out);
  builder.Add(out, a);
  builder.Add(out, b);
  return out;
}

/// Something that may be no solid at all.
TopoDS_Shape broken(const TopoDS_Shape& shape, Random& random) {
  const auto faces = faces_of(shape);
  switch (below(random, 7)) {
    case 0:
      return inside_out(faces);
    case 1:  // overlapping shells, or a void outside
      return solid_of(
          {shell_of(faces), shell_of(faces_of(moved(shape, below(random, 2) ? 1 : 50)))});
    case 2:
      return squashed(shape, below(random, 2) ? 1e-4 : 1e-9);
    case 3:
      return compound_of(shape, faces.front());
    case 4:
      return solid_of({});
    default: {
      auto left = faces;
      for (int n = 1 + below(random, 3); n > 0 && !left.empty(); --n)
        left = with_a_broken_face(left, random);
      return solid_of({shell_of(left)});
    }
  }
}

std::string brep(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out);
  return out.str();
}

/// Nothing, or some faces in some roles and a vertex type.
Picks random_picks(const Model& model, Random& random) {
  const auto any = [&] { return model.faces()[below(random, model.faces().size())]; };
  Picks out;
  if (below(random, 2)) out.sources.push_back(any());
  if (below(random, 2)) out.targets.push_back(any());
  if (below(random, 4) == 0) out.pairs.emplace_back(any(), any());
  if (below(random, 4) == 0 && !model.vertices().empty())
    out.types.push_back({any(), model.vertices().front(), VertexType::corner});
  return out;
}

void expect_verdict(const Assessment& found) {
  EXPECT_NE(found.is_sweepable(), !found.reasons.empty());
  for (const Reason& r : found.reasons) EXPECT_TRUE(r.text.ends_with(".")) << r.text;
}

/// Whatever is no Error ends the test.
void expect_an_answer(const std::string& text, Random& random) {
  const std::clock_t start = std::clock();
  try {
    const Model model = Model::from_brep(text);
    Context context(1);
    expect_verdict(assess(model, {}, context));
    expect_verdict(assess(model, random_picks(model, random), context));
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()), "");
    EXPECT_FALSE(error.stage().empty());
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kMostSeconds);
}

class Unsound : public testing::TestWithParam<int> {};

TEST_P(Unsound, HasAVerdictOrATypedError) {
  Random random(GetParam());
  for (const TopoDS_Shape& shape : sound_shapes())
    for (int i = 0; i < 4; ++i) expect_an_answer(brep(broken(shape, random)), random);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Unsound, testing::Range(0, 10));

TEST(UnsoundOnes, ShapesAsTheyAre) {
  Random random(99);
  for (const TopoDS_Shape& shape : sound_shapes()) expect_an_answer(brep(shape), random);
}

TEST(UnsoundOnes, TextThatIsNoShape) {
  for (const char* text : {"", "nonsense", "DBRep_DrawableShape\n\nCASCADE Topology V1"})
    EXPECT_THROW(Model::from_brep(text), InputError) << text;
  EXPECT_THROW(Model::from_brep(brep(TopoDS_Compound())), InputError);
}

}  // namespace
}  // namespace sweepmesh
