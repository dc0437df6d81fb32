// Model over solids made in code: loops, orientation, angles and numbers must be right for each.
#include "sweepmesh/model/model.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <cstdio>
#include <numbers>

#include "sweepmesh/base/errors.h"
#include "to_model.h"

namespace sweepmesh {
namespace {

constexpr double pi = std::numbers::pi;

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}
TopoDS_Shape cylinder(double r, double h) {
  return BRepPrimAPI_MakeCylinder(r, h).Shape();
}

TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}

TopoDS_Shape l_solid() {
  return BRepAlgoAPI_Cut(box(2, 2, 1), BRepPrimAPI_MakeBox(gp_Pnt(1, 1, -1), 2, 2, 3).Shape())
      .Shape();
}

std::vector<std::pair<std::string, TopoDS_Shape>> family() {
  const TopoDS_Shape plate =
      BRepAlgoAPI_Cut(
          box(4, 4, 1),
          BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 2, -1), gp_Dir(0, 0, 1)), 1, 3).Shape())
          .Shape();
  return {{"box", box(1, 2, 3)},
          {"cylinder", cylinder(1, 2)},
          {"cone", BRepPrimAPI_MakeCone(2, 1, 3).Shape()},
          {"pointed cone", BRepPrimAPI_MakeCone(2, 0, 3).Shape()},
          {"sphere", BRepPrimAPI_MakeSphere(1).Shape()},
          {"torus", BRepPrimAPI_MakeTorus(3, 1).Shape()},
          {"plate with a hole", plate},
          {"L", l_solid()},
          {"mirrored plate", mirrored(plate)},
          {"reversed box", box(1, 2, 3).Reversed()}};
}

double middle_of(const std::pair<double, double>& range) {
  return (range.first + range.second) / 2;
}

Point2 middle_uv(const Model& model, const Coedge& c) {
  return model.uv(c, middle_of(model.range(c)));
}

/// The classifier, unlike Model, needs the shell the right way round.
TopoDS_Shape oriented_outwards(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass() < 0 ? shape.Reversed() : shape;
}

TEST(Model, loops_are_closed_and_have_the_face_on_their_left) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Model model = test::to_model(shape);
    for (const FaceId f : model.faces())
      for (const Loop& loop : model.loops(f)) {
        double area = 0;
        Point2 last = Point2::Zero();
        bool first = true;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const Coedge& c = loop[i];
          EXPECT_EQ(c.end, loop[(i + 1) % loop.size()].start);
          const auto [a, b] = model.range(c);
          for (int s = 0; s <= 64; ++s) {
            const double x = s / 64.0;
            const Point2 p = model.uv(c, c.reversed ? b + (a - b) * x : a + (b - a) * x);
            if (!first) area += cross2(last, p);
            last = p, first = false;
          }
        }
        EXPECT_EQ(area > 0, &loop == &model.loops(f).front()) << name_of(f);
      }
  }
}

TEST(Model, normals_point_out_of_the_solid) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Model model = test::to_model(shape);
    const double step = 1e-3;
    BRepClass3d_SolidClassifier classifier(oriented_outwards(shape));
    for (const FaceId f : model.faces())
      for (const Coedge& c : model.loops(f)[0]) {
        if (!c.edge.is_valid()) continue;
        const double t = middle_of(model.range(c));
        const Point3 along = model.tangent(c.edge, t) * (c.reversed ? -1 : 1);
        const Point3 normal = model.normal(f, model.uv(c, t));
        const Point3 inside = model.point(c.edge, t) + 4 * step * normal.cross(along);
        for (const double side : {-1.0, 1.0}) {
          const Point3 p = inside + side * step * normal;
          classifier.Perform(gp_Pnt(p.x(), p.y(), p.z()), 1e-7);
          EXPECT_EQ(classifier.State(), side > 0 ? TopAbs_OUT : TopAbs_IN) << name_of(f);
        }
      }
  }
}

TEST(Model, box_has_right_angles_inside_and_between_its_faces) {
  for (const TopoDS_Shape& shape :
       {box(1, 2, 3), box(1, 2, 3).Reversed(), mirrored(box(1, 2, 3))}) {
    const Model model = test::to_model(shape);
    ASSERT_EQ(model.faces().size(), 6u);
    const Point3 centre = (model.bounding_box().first + model.bounding_box().second) / 2;
    for (const EdgeId e : model.edges()) EXPECT_NEAR(model.dihedral(e), pi / 2, 1e-9);
    for (const FaceId f : model.faces()) {
      ASSERT_EQ(model.loops(f).size(), 1u);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(model.interior_angle(f, 0, i), pi / 2, 1e-9);
      const Point2 uv = middle_uv(model, model.loops(f)[0][0]);
      EXPECT_GT(model.normal(f, uv).dot(model.point(f, uv) - centre), 0);
    }
    EXPECT_NEAR(model.volume(), 6, 1e-9);
  }
}

TEST(Model, l_solid_has_one_concave_edge_and_two_reflex_angles) {
  const Model model = test::to_model(l_solid());
  int n_concave = 0, n_reflex = 0;
  for (const EdgeId e : model.edges())
    if (std::abs(model.dihedral(e) - 1.5 * pi) < 1e-9) ++n_concave;
  for (const FaceId f : model.faces())
    for (int i = 0; i < static_cast<int>(model.loops(f)[0].size()); ++i)
      if (std::abs(model.interior_angle(f, 0, i) - 1.5 * pi) < 1e-9) ++n_reflex;
  EXPECT_EQ(n_concave, 1);
  EXPECT_EQ(n_reflex, 2);
}

TEST(Model, cylinder_wall_is_four_sided_through_its_seam) {
  const Model model = test::to_model(cylinder(1, 2));
  int n_walls = 0;
  for (const FaceId f : model.faces()) {
    if (model.is_planar(f)) continue;
    ++n_walls;
    const Loop& loop = model.loops(f)[0];
    ASSERT_EQ(loop.size(), 4u);
    int n_seams = 0;
    for (int i = 0; i < 4; ++i) {
      n_seams += loop[i].seam;
      EXPECT_NEAR(model.interior_angle(f, 0, i), pi / 2, 1e-9);
      if (loop[i].seam) {
        EXPECT_EQ(model.partner(loop[i]).face, f);
        EXPECT_NEAR((middle_uv(model, loop[i]) - middle_uv(model, model.partner(loop[i]))).norm(),
                    2 * pi, 1e-9);
      }
    }
    EXPECT_EQ(n_seams, 2);
  }
  EXPECT_EQ(n_walls, 1);
}

TEST(Model, uv_of_coedges_lies_on_the_edge) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Model model = test::to_model(shape);
    for (const EdgeId e : model.edges())
      for (const Coedge& c : model.coedges(e))
        for (const double t : model.at_length_fractions(e, {0.0, 0.3, 0.77, 1.0}))
          EXPECT_LT((model.point(c.face, model.uv(c, t)) - model.point(e, t)).norm(),
                    10 * model.tolerances().point);
  }
}

TEST(Model, length_fractions_divide_the_length) {
  const Model model = test::to_model(BRepPrimAPI_MakeTorus(3, 1, pi / 2).Shape());
  for (const EdgeId e : model.edges()) {
    std::vector<double> fractions;
    for (int i = 0; i <= 50; ++i) fractions.push_back(i / 50.0);
    const auto t = model.at_length_fractions(e, fractions);
    const double chord = (model.point(e, t[1]) - model.point(e, t[0])).norm();
    for (int i = 1; i <= 50; ++i)
      EXPECT_NEAR((model.point(e, t[i]) - model.point(e, t[i - 1])).norm(), chord, 1e-5);
  }
}

TEST(Model, nearest_face_and_distance_agree) {
  const Model model = test::to_model(box(10, 10, 10));
  for (const FaceId f : model.faces()) {
    const Point2 uv = (model.uv_bounds(f).first + model.uv_bounds(f).second) / 2;
    EXPECT_EQ(model.nearest_face(model.point(f, uv)), f);
    EXPECT_NEAR(model.distance(f, model.point(f, uv) + 0.5 * model.normal(f, uv)), 0.5, 1e-9);
    EXPECT_LT((model.project(f, model.point(f, uv)) - uv).norm(), 1e-6);
  }
}

TEST(Model, projection_onto_an_edge_finds_its_own_points) {
  for (const auto& [name, shape] : family()) {
    SCOPED_TRACE(name);
    const Model model = test::to_model(shape);
    for (const EdgeId e : model.edges())
      for (const double t : model.at_length_fractions(e, {0.0, 0.21, 0.5, 0.9, 1.0})) {
        const Point3 p = model.point(e, t);
        EXPECT_LT((model.point(e, model.project(e, p)) - p).norm(), 1e-6);
      }
  }
}

TEST(Model, what_is_no_solid_is_refused_in_a_sentence) {
  const auto refuses = [](const TopoDS_Shape& shape, const std::string& part) {
    try {
      test::to_model(shape);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_EQ(error.stage(), "read");
    }
  };
  refuses(TopExp_Explorer(box(1, 1, 1), TopAbs_FACE).Current(), "open shell");
  refuses(TopExp_Explorer(box(1, 1, 1), TopAbs_WIRE).Current(), "no solid");
  EXPECT_THROW(Model::from_brep(""), InputError);
  EXPECT_THROW(Model::from_brep("nonsense"), InputError);
  EXPECT_THROW(Model::from_file("/no/such/file.step"), InputError);
}

/// Over a regular polygon.
TopoDS_Shape prism_with_sides(int n_sides) {
  BRepBuilderAPI_MakePolygon outline;
  for (int s = 0; s < n_sides; ++s) {
    const double a = 2 * pi * s / n_sides;
    outline.Add(gp_Pnt(100 * std::cos(a), 100 * std::sin(a), 0));
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10));
}

TEST(Model, LongLoopsComeOutOfFilesAsTheyWentIn) {
  const std::string path = testing::TempDir() + "long_loops.step";
  for (const int n_sides : {12, 600}) {  // healed in full, and without the cubic search
    STEPControl_Writer writer;
    writer.Transfer(prism_with_sides(n_sides), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    const Model model = Model::from_file(path);
    EXPECT_EQ(model.faces().size(), n_sides + 2u);
    EXPECT_EQ(model.edges().size(), 3u * n_sides);
    const double area = 0.5 * n_sides * 100 * 100 * std::sin(2 * pi / n_sides);
    EXPECT_NEAR(model.volume(), 10 * area, 1e-6 * area);
  }
  std::remove(path.c_str());
}

}  // namespace
}  // namespace sweepmesh
