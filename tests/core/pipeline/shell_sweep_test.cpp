// Sweeps through the thickness of a wall, from model to mesh.
#include <gtest/gtest.h>

#include "sweepmesh/pipeline/sweep.h"
#include "walled.h"

namespace sweepmesh {
namespace {

constexpr double size = 4.0;

SweepResult swept(const test::Walled& w, double element_size, int n_threads = 0) {
  SweepOptions options;
  options.size = element_size;
  Context context(n_threads);
  return sweep(w.model, w.picks, options, context);
}

class ShellSweep : public testing::TestWithParam<test::Walled> {};

TEST_P(ShellSweep, fills_the_wall_with_good_elements) {
  const SweepResult result = swept(GetParam(), size);
  ASSERT_FALSE(result.mesh.hexahedra.empty());
  EXPECT_EQ(result.quality.n_inverted, 0);
  EXPECT_GT(result.quality.scaled_jacobian.min, 0.25);
  EXPECT_NEAR(result.quality.total_volume / GetParam().model.volume(), 1.0, 0.06);
}

TEST_P(ShellSweep, is_the_same_on_one_thread_and_on_many) {
  const Points one = swept(GetParam(), size, 1).mesh.points;
  const Points many = swept(GetParam(), size, 4).mesh.points;
  ASSERT_EQ(one.rows(), many.rows());
  EXPECT_TRUE((one.array() == many.array()).all());
}

INSTANTIATE_TEST_SUITE_P(Walled, ShellSweep, testing::ValuesIn(test::walled_solids()),
                         [](const auto& info) { return info.param.name; });

/// Candidates of a mesh may change places by rounding where they are equally good, so counts may
/// differ a little; nothing may fail.
TEST(ShellSweeps, MeshWhereverTheyStand) {
  for (const double scale : {1e-2, 1e2})
    for (const test::Walled& w : test::walled_solids(1.1, scale)) {
      SCOPED_TRACE(w.name);
      const SweepResult result = swept(w, size * scale);
      ASSERT_FALSE(result.mesh.hexahedra.empty());
      EXPECT_GT(result.quality.scaled_jacobian.min, 0.2);
    }
}

}  // namespace
}  // namespace sweepmesh
