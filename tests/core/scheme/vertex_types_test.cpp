#include "sweepmesh/scheme/vertex_types.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

constexpr double kDegree = kQuarterTurn / 90;
using enum VertexType;

FaceCorners corners_of(const std::vector<std::vector<double>>& degrees) {
  FaceCorners out;
  int vertex = 0;
  for (const auto& loop : degrees) {
    out.emplace_back();
    for (double angle : loop) out.back().push_back({VertexId{vertex++}, {}, 0.0, angle * kDegree});
  }
  return out;
}

std::variant<VertexTypes, std::vector<Reason>> solve(const FaceCorners& corners,
                                                     const TypeOptions& options = {}) {
  Context context;
  return solve_vertex_types(corners, options, context);
}

VertexTypes types_of(const FaceCorners& corners, const TypeOptions& options = {}) {
  const auto solved = solve(corners, options);
  EXPECT_TRUE(std::holds_alternative<VertexTypes>(solved));
  return std::holds_alternative<VertexTypes>(solved) ? std::get<VertexTypes>(solved)
                                                     : VertexTypes{};
}

TypeOptions reference() {
  TypeOptions out;
  out.model = TypeModel::ruiz_girones;
  return out;
}

TEST(NearestType, RoundsAsInEquation61) {
  const std::vector<std::pair<double, VertexType>> expected = {
      {10, end},   {90, end},     {134, end},    {135, end},      {136, side},    {180, side},
      {224, side}, {226, corner}, {270, corner}, {316, reversal}, {359, reversal}};
  for (const auto& [angle, type] : expected)
    EXPECT_EQ(nearest_type(angle * kDegree), type) << angle;
}

// Figures 6.1 and 6.8: a slanted step of 222 and 130 degrees, whose nearest types add up to five.
const std::vector<std::vector<double>> kAmbiguous = {{90, 90, 90, 222, 130, 98}};

TEST(VertexTypes, AmbiguousAnglesTakeTheLeastChange) {
  const VertexTypes types = types_of(corners_of(kAmbiguous));
  EXPECT_EQ(types.type[0], (std::vector{end, end, end, corner, end, end}));
  EXPECT_EQ(types.n_changed, 1);
}

TEST(VertexTypes, UserReachesTheOtherClassification) {
  TypeOptions options;
  options.fixed = {{0, 4, side}};
  const VertexTypes types = types_of(corners_of(kAmbiguous), options);
  EXPECT_EQ(types.type[0], (std::vector{end, end, end, side, side, end}));
}

// Figure 6.6: a cusp of 350 degrees between two smooth shoulders.
const std::vector<std::vector<double>> kCusp = {{90, 90, 90, 180, 350, 180, 90}};

TEST(VertexTypes, CuspIsFlattenedAndTheReferenceCannot) {
  const VertexTypes types = types_of(corners_of(kCusp));
  EXPECT_EQ(types.type[0][4], side);
  EXPECT_EQ(types.n_changed, 1);
  // The reference may not change it by two; all that is left to it is an END on a straight
  // shoulder, which no grid has.
  const VertexTypes other = types_of(corners_of(kCusp), reference());
  EXPECT_NE(other.type[0][4], side);
  EXPECT_TRUE(other.type[0][3] == end || other.type[0][5] == end);
}

// The same without shoulders to bend: there the bound on the change leaves the reference no way at
// all.
TEST(VertexTypes, ReferenceFailsWhereAChangeOfTwoIsNeeded) {
  const FaceCorners corners = corners_of({{90, 90, 90, 350, 90}});
  EXPECT_EQ(types_of(corners).type[0][3], side);
  EXPECT_TRUE(std::holds_alternative<std::vector<Reason>>(solve(corners, reference())));
}

// Figure A.2: a wide notch of 246 degrees; both models agree.
TEST(VertexTypes, WideNotchBecomesSide) {
  const FaceCorners corners = corners_of({{90, 90, 57, 246, 57}});
  EXPECT_EQ(types_of(corners).type[0], (std::vector{end, end, end, side, end}));
  EXPECT_EQ(types_of(corners, reference()).type[0], (std::vector{end, end, end, side, end}));
}

TEST(VertexTypes, RightAnglesStayAsTheyAre) {
  const FaceCorners corners = corners_of(
      {{90, 90, 90, 270, 90, 270, 90, 90}, {270, 270, 270, 270}, {270, 270, 270, 90, 270, 270}});
  const VertexTypes types = types_of(corners);
  EXPECT_EQ(types.n_changed, 0);
  EXPECT_NEAR(types.change, 0.0, 1e-12);
}

TEST(VertexTypes, EndNeedsAnAngleBelowAHalfTurn) {
  const auto solved = solve(corners_of({{90, 90, 90, 180}}));
  ASSERT_TRUE(std::holds_alternative<std::vector<Reason>>(solved));
  const Reason& reason = std::get<std::vector<Reason>>(solved).front();
  EXPECT_EQ(reason.kind, ReasonKind::geometric);
  EXPECT_EQ(reason.entities.size(), 4u);
}

TEST(VertexTypes, ContradictionNamesTheVerticesThatMakeIt) {
  const FaceCorners corners = corners_of({{90, 90, 90, 90, 180}});
  TypeOptions options;
  options.fixed = {{0, 4, side}, {0, 1, side}, {0, 2, end}};
  const auto solved = solve(corners, options);
  ASSERT_TRUE(std::holds_alternative<std::vector<Reason>>(solved));
  const Reason& reason = std::get<std::vector<Reason>>(solved).front();
  EXPECT_EQ(reason.kind, ReasonKind::prescribed);
  // Fixing Vertex2 as SIDE leaves three ENDs at most, whatever the others are.
  EXPECT_EQ(reason.entities, (std::vector<std::string>{"Vertex2"}));
  EXPECT_NE(reason.text.find("Vertex2 as SIDE"), std::string::npos);
}

TEST(VertexTypes, CornerThatIsNotThereIsAnInputError) {
  TypeOptions options;
  options.fixed = {{0, 9, side}};
  EXPECT_THROW(solve(corners_of({{90, 90, 90, 90}}), options), InputError);
}

/// Least number of changes, then least change of angle, by trying all types of one loop.
std::optional<std::pair<int, double>> best_by_trial(const std::vector<FaceCorner>& loop, int sum) {
  std::optional<std::pair<int, double>> best;
  long n_cases = 1;
  for (std::size_t i = 0; i < loop.size(); ++i) n_cases *= 4;
  for (long number = 0; number < n_cases; ++number) {
    long rest = number;
    int total = 0, n_changed = 0;
    double change = 0.0;
    bool is_allowed = true;
    for (const FaceCorner& corner : loop) {
      const VertexType type = std::array{end, side, VertexType::corner, reversal}[rest % 4];
      rest /= 4;
      total += static_cast<int>(type);
      n_changed += type != nearest_type(corner.angle);
      change += std::abs(corner.angle - ideal_angle(type));
      is_allowed &= is_vertex_allowed(corner.angle, type, {});
    }
    if (!is_allowed || total != sum) continue;
    const std::pair candidate(n_changed, change);
    if (!best || n_changed < best->first || (n_changed == best->first && change < best->second))
      best = candidate;
  }
  return best;
}

TEST(VertexTypes, ProgramAgreesWithTryingEverything) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle(15.0, 355.0);
  int n_solved = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<std::vector<double>> degrees(2);
    for (int c = 0; c < 4 + round % 4; ++c)
      degrees[0].push_back(angle(random) / (round % 2 ? 1 : 2));
    for (int c = 0; c < 3 + round % 3; ++c) degrees[1].push_back(angle(random));
    const FaceCorners corners = corners_of(degrees);
    const auto outer = best_by_trial(corners[0], 4), hole = best_by_trial(corners[1], -4);
    const auto solved = solve(corners);
    ASSERT_EQ(std::holds_alternative<VertexTypes>(solved), outer && hole) << round;
    if (!outer || !hole) continue;
    ++n_solved;
    const VertexTypes& types = std::get<VertexTypes>(solved);
    EXPECT_EQ(types.n_changed, outer->first + hole->first);
    EXPECT_NEAR(types.change, outer->second + hole->second, 1e-6);
  }
  EXPECT_GT(n_solved, 20);
}

/// A rectilinear outline: a square whose sides were pushed in and out, with holes made the same
/// way.
std::vector<double> random_outline(std::mt19937& random, bool is_hole) {
  std::vector<double> out;
  for (int s = 0; s < 4; ++s) {
    out.push_back(is_hole ? 270 : 90);
    for (std::uint32_t bump = random() % 3; bump > 0; --bump)
      for (double angle :
           random() % 2 ? std::array{90., 270., 270., 90.} : std::array{270., 90., 90., 270.})
        out.push_back(angle);
  }
  return out;
}

TEST(VertexTypes, NoiseOnRectilinearFacesIsRepaired) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 12.0);
  int n_right = 0;
  constexpr int kFaces = 200;
  for (int round = 0; round < kFaces; ++round) {
    std::vector<std::vector<double>> exact = {random_outline(random, false)};
    for (std::uint32_t hole = random() % 3; hole > 0; --hole)
      exact.push_back(random_outline(random, true));
    auto noisy = exact;
    for (auto& loop : noisy)
      for (double& angle : loop) angle += std::clamp(noise(random), -40.0, 40.0);
    n_right += types_of(corners_of(noisy)).type == types_of(corners_of(exact)).type;
  }
  EXPECT_EQ(n_right, kFaces);
}

}  // namespace
}  // namespace sweepmesh
