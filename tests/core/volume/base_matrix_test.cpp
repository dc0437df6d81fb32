// Base matrices against dense ones, for sizes of one part and of many.
#include "sweepmesh/volume/base_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>

namespace sweepmesh {
namespace {

Eigen::MatrixXd dense(const BaseMatrix& m) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m.n_rows, m.n_cols);
  for (int r = 0; r < m.n_rows; ++r)
    m.for_row(r, [&](int c, float v) {
      EXPECT_NE(v, 0.0f);
      out(r, c) += v;
    });
  return out;
}

/// Small whole numbers, so that sums are exact; some rows are empty.
BaseMatrix random_matrix(int n_rows, int n_cols, unsigned seed, ThreadTeam& team) {
  return build_rows(n_rows, n_cols, team, [&](int row, RowSum& sum) {
    std::mt19937 random(seed + row);
    for (unsigned n = random() % 6; n > 0; --n)
      sum.add(static_cast<int>(random() % n_cols), static_cast<double>(random() % 7) - 3.0);
  });
}

TEST(BaseMatrix, products_and_transposes_are_those_of_dense_matrices) {
  for (const auto [n, m] : {std::pair{1, 1}, {40, 9}, {700, 80}, {9000, 30}}) {
    ThreadTeam team(3);
    const BaseMatrix a = random_matrix(n, m, 1, team), b = random_matrix(m, 25, 2, team);
    EXPECT_EQ(dense(product(a, b, team)), dense(a) * dense(b));
    EXPECT_EQ(dense(transposed(a)), dense(a).transpose());
    EXPECT_TRUE(product(zero_matrix(7, n), a, team).is_zero());
  }
}

TEST(BaseMatrix, square_products_have_the_diagonal_first) {
  ThreadTeam team(2);
  const BaseMatrix a = random_matrix(300, 40, 3, team), b = random_matrix(40, 300, 4, team),
                   c = square_product(a, b, team);
  EXPECT_EQ(dense(c), dense(a) * dense(b));
  for (int r = 0; r < c.n_rows; ++r)
    c.for_row(r, [&, first = true](int column, float) mutable {
      EXPECT_TRUE(first || column != r) << "row " << r;
      first = false;
    });
}

TEST(BaseMatrix, does_not_depend_on_the_number_of_threads) {
  ThreadTeam one(1), many(5);
  const BaseMatrix a = random_matrix(5000, 5000, 5, one), b = random_matrix(5000, 5000, 5, many);
  for (int r = 0; r < a.n_rows; ++r) {
    const BaseMatrix::Row x = a.row(r), y = b.row(r);
    ASSERT_EQ(x.n, y.n);
    for (int i = 0; i < x.n; ++i)
      ASSERT_TRUE(x.column[i] == y.column[i] && x.value[i] == y.value[i]);
  }
}

}  // namespace
}  // namespace sweepmesh
