#include "sweepmesh/volume/base_matrix.h"

#include <algorithm>

namespace sweepmesh {

BaseMatrix join_rows(int n_cols, const std::vector<BaseMatrix>& parts, ThreadTeam& team) {
  BaseMatrix all;
  all.n_cols = n_cols;
  std::vector<std::size_t> first_row(1, 0), first_entry(1, 0);
  for (const BaseMatrix& part : parts) {
    first_row.push_back(first_row.back() + part.n_rows());
    first_entry.push_back(first_entry.back() + part.column.size());
  }
  all.offset.resize(first_row.back() + 1);
  all.column.resize(first_entry.back());
  all.value.resize(first_entry.back());
  team.for_chunks(static_cast<long>(parts.size()), 1, [&](long p, long, long) {
    const BaseMatrix& part = parts[p];
    for (int row = 0; row < part.n_rows(); ++row)
      all.offset[first_row[p] + row + 1] = static_cast<int>(first_entry[p]) + part.offset[row + 1];
    std::copy(part.column.begin(), part.column.end(), all.column.begin() + first_entry[p]);
    std::copy(part.value.begin(), part.value.end(), all.value.begin() + first_entry[p]);
  });
  return all;
}

BaseMatrix product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team) {
  if (a.is_zero() || b.is_zero()) {
    BaseMatrix zero;
    zero.n_cols = b.n_cols;
    zero.offset.assign(a.n_rows() + 1, 0);
    return zero;
  }
  return build_rows(a.n_rows(), b.n_cols, team, [&](int row, RowSum& sum) {
    a.for_row(row, [&](int middle, double v) {
      b.for_row(middle, [&](int column, double w) { sum.add(column, v * w); });
    });
  });
}

BaseMatrix transposed(const BaseMatrix& a) {
  BaseMatrix t;
  t.n_cols = a.n_rows();
  t.offset.assign(a.n_cols + 1, 0);
  t.column.resize(a.column.size());
  t.value.resize(a.column.size());
  for (const int c : a.column) ++t.offset[c + 1];
  for (int c = 0; c < a.n_cols; ++c) t.offset[c + 1] += t.offset[c];
  std::vector<int> next(t.offset.begin(), t.offset.end() - 1);
  for (int row = 0; row < a.n_rows(); ++row)
    a.for_row(row, [&](int column, double v) {
      const int slot = next[column]++;
      t.column[slot] = row;
      t.value[slot] = v;
    });
  return t;
}

}  // namespace sweepmesh
