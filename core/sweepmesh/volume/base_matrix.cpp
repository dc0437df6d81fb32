#include "sweepmesh/volume/base_matrix.h"

#include <algorithm>

namespace sweepmesh {
namespace {

/// Shift of matrices whose rows are one part.
constexpr int one_part = 31;

void add_product_row(const BaseMatrix& a, const BaseMatrix& b, int row, RowSum& sum) {
  a.for_row(row, [&](int middle, double v) {
    b.for_row(middle, [&](int column, double w) { sum.add(column, v * w); });
  });
}

}  // namespace

BaseMatrix zero_matrix(int n_rows, int n_cols) {
  BaseMatrix zero;
  zero.n_rows = n_rows;
  zero.n_cols = n_cols;
  zero.shift = one_part;
  zero.parts.emplace_back().offset.assign(n_rows + 1, 0);
  return zero;
}

BaseMatrix product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team) {
  if (a.is_zero() || b.is_zero()) return zero_matrix(a.n_rows, b.n_cols);
  return build_rows(a.n_rows, b.n_cols, team,
                    [&](int row, RowSum& sum) { add_product_row(a, b, row, sum); });
}

BaseMatrix square_product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team) {
  if (a.is_zero() || b.is_zero()) return zero_matrix(a.n_rows, b.n_cols);
  return build_rows(a.n_rows, b.n_cols, team, [&](int row, RowSum& sum) {
    sum.add(row, 0.0);
    add_product_row(a, b, row, sum);
  });
}

BaseMatrix transposed(const BaseMatrix& a) {
  BaseMatrix t;
  t.n_rows = a.n_cols;
  t.n_cols = a.n_rows;
  t.shift = one_part;
  BaseMatrix::Part& all = t.parts.emplace_back();
  all.offset.assign(t.n_rows + 1, 0);
  for (const BaseMatrix::Part& part : a.parts)
    for (const int c : part.column) ++all.offset[c + 1];
  for (int c = 0; c < t.n_rows; ++c) all.offset[c + 1] += all.offset[c];
  all.column.resize(all.offset.back());
  all.value.resize(all.offset.back());
  std::vector<int> next(all.offset.begin(), all.offset.end() - 1);
  for (int row = 0; row < a.n_rows; ++row)
    a.for_row(row, [&](int column, float v) {
      const int slot = next[column]++;
      all.column[slot] = row;
      all.value[slot] = v;
    });
  return t;
}

}  // namespace sweepmesh
