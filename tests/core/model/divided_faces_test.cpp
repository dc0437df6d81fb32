// Faces cut along curves: every curve has a piece on either side, seen from outside the solid.
#include "sweepmesh/model/divided_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solids.h"
#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

/// The face of a 10 x 10 x 10 box whose normal is nearest to `up`.
FaceId face_towards(const Model& box, const Point3& up) {
  const Point3 middle(5, 5, 5);
  return box.nearest_face(middle + 4.9 * up);
}

int n_pieces_at(const DividedFaces& divided, int curve, bool is_left) {
  return static_cast<int>(
      std::count_if(divided.pieces.begin(), divided.pieces.end(),
                    [&](const FacePiece& p) { return p.curve == curve && p.is_left == is_left; }));
}

TEST(DividedFaces, ALineAcrossGivesAPieceOnEitherSide) {
  const Model box = test::box(10, 10, 10);
  for (const Point3& up : {Point3(0, 0, 1), Point3(0, 0, -1)}) {
    const FaceId face = face_towards(box, up);
    const double z = up.z() > 0 ? 10 : 0;
    const DividedFaces out = divide_faces({{box, face, {{{{3, 0, z}, {4, 10, z}}, 0, 1}}}});
    ASSERT_EQ(out.pieces.size(), 2u);
    EXPECT_EQ(n_pieces_at(out, 0, true), 1);
    EXPECT_EQ(n_pieces_at(out, 0, false), 1);
  }
}

TEST(DividedFaces, ClosedAndBentCurvesCut) {
  const Model box = test::box(10, 10, 10);
  const FaceId top = face_towards(box, Point3::UnitZ());
  std::vector<Point3> circle;
  for (int i = 0; i <= 24; ++i) {
    const double a = 2 * std::numbers::pi * (i % 24) / 24;
    circle.push_back({5 + 2 * std::cos(a), 5 + 2 * std::sin(a), 10});
  }
  const std::vector<Point3> bent = {{1, 0, 10}, {1, 9, 10}, {10, 9, 10}};
  const DividedFaces out = divide_faces({{box, top, {{circle, 0, 0}, {bent, 1, 2}}}});
  EXPECT_EQ(out.pieces.size(), 3u);
  EXPECT_EQ(n_pieces_at(out, 0, true), 1) << "inside of the circle";
}

TEST(DividedFaces, CurvesThatMeetShareTheirVertex) {
  const Model box = test::box(10, 10, 10);
  const FaceId top = face_towards(box, Point3::UnitZ());
  const Point3 centre(5, 5, 10);
  const DividedFaces out = divide_faces({{box,
                                          top,
                                          {{{centre, {5, 0, 10}}, 0, 1},
                                           {{centre, {10, 8, 10}}, 0, 2},
                                           {{centre, {0, 8, 10}}, 0, 3}}}});
  EXPECT_EQ(out.pieces.size(), 3u);
}

TEST(DividedFaces, WithoutCurvesAFaceStaysWhole) {
  const Model box = test::box(10, 10, 10);
  const DividedFaces out = divide_faces({{box, FaceId{0}, {}}, {box, FaceId{3}, {}}});
  ASSERT_EQ(out.pieces.size(), 2u);
  EXPECT_EQ(out.pieces[1].division, 1);
  EXPECT_EQ(out.pieces[0].curve, -1);
}

TEST(DividedFaces, ACurveThatDoesNotCutIsAnErrorThatNamesTheFace) {
  const Model box = test::box(10, 10, 10);
  const FaceId top = face_towards(box, Point3::UnitZ());
  const std::vector<std::vector<Point3>> wrong = {{{3, 0, 12}, {3, 10, 12}},  // off the face
                                                  {{3, 2, 10}, {3, 8, 10}}};  // ends inside
  for (const auto& points : wrong) try {
      divide_faces({{box, top, {{points, 0, 1}}}});
      FAIL();
    } catch (const SolverError& e) {
      EXPECT_EQ(e.entities(), std::vector<std::string>{name_of(top)});
      EXPECT_EQ(e.stage(), "imprint");
    }
}

}  // namespace
}  // namespace sweepmesh
