#include "sweepmesh/volume/base_matrix.h"

#include <algorithm>

namespace sweepmesh {
namespace {

void add_product_row(const BaseMatrix& a, const BaseMatrix& b, int row, RowSum& sum) {
  a.for_row(row, [&](int middle, double v) {
    b.for_row(middle, [&](int column, double w) { sum.add(column, v * w); });
  });
}

}  // namespace

BaseMatrix product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team) {
  return build_rows(a.n_rows, b.n_cols, team,
                    [&](int row, RowSum& sum) { add_product_row(a, b, row, sum); });
}

BaseMatrix square_product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team) {
  return build_rows(a.n_rows, b.n_cols, team, [&](int row, RowSum& sum) {
    sum.add(row, 0.0);
    add_product_row(a, b, row, sum);
  });
}

BaseMatrix transposed(const BaseMatrix& a) {
  BaseMatrix t;
  t.n_rows = a.n_cols;
  t.n_cols = a.n_rows;
  t.shift = 30;  // one part
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
