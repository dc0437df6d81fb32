// Sparse matrices over the columns of a base mesh, made row by row on several threads.
//
// A row's entries stand in the order in which they were first added, so a matrix depends on what is
// added to its rows, not on the threads that do it.
#pragma once

#include <vector>

#include "sweepmesh/base/parallel.h"

namespace sweepmesh {

/// Compressed rows. Entries are never zero.
struct BaseMatrix {
  int n_cols = 0;
  std::vector<int> offset = {0};
  std::vector<int> column;
  std::vector<double> value;

  int n_rows() const { return static_cast<int>(offset.size()) - 1; }
  bool is_zero() const { return column.empty(); }

  /// Calls f(column, value) for the entries of a row.
  template <class F>
  void for_row(int row, F&& f) const {
    for (int e = offset[row]; e < offset[row + 1]; ++e) f(column[e], value[e]);
  }
};

/// Sums up the entries of one row at a time.
class RowSum {
 public:
  void start(int n_cols) {
    if (static_cast<int>(place_.size()) < n_cols) place_.resize(n_cols, -1);
  }
  void add(int column, double value) {
    const int place = place_[column];
    if (place >= 0) {
      value_[place] += value;
    } else {
      place_[column] = n_;
      append(column, value);
    }
  }
  /// The first and only time that the row gets this column.
  void append(int column, double value) {
    if (n_ == static_cast<int>(column_.size())) grow();
    column_[n_] = column;
    value_[n_++] = value;
  }
  /// Appends what is not zero to a matrix and forgets it.
  void finish_row(BaseMatrix& matrix) {
    const std::size_t first = matrix.column.size();
    matrix.column.resize(first + n_);
    matrix.value.resize(first + n_);
    std::size_t end = first;
    for (int i = 0; i < n_; ++i) {
      place_[column_[i]] = -1;
      matrix.column[end] = column_[i];
      matrix.value[end] = value_[i];
      end += value_[i] != 0.0 ? 1 : 0;
    }
    matrix.column.resize(end);
    matrix.value.resize(end);
    matrix.offset.push_back(static_cast<int>(end));
    n_ = 0;
  }

 private:
  void grow() {
    column_.resize(2 * column_.size() + 64);
    value_.resize(column_.size());
  }

  std::vector<int> place_;  ///< per column of the matrix: index in the row, or -1
  int n_ = 0;
  std::vector<int> column_;
  std::vector<double> value_;
};

/// Joins parts, one below the other.
BaseMatrix join_rows(int n_cols, const std::vector<BaseMatrix>& parts, ThreadTeam& team);

/// The matrix whose rows f(row, RowSum&) adds up. Linear in what is added.
template <class F>
BaseMatrix build_rows(int n_rows, int n_cols, ThreadTeam& team, F&& f) {
  constexpr long least = 1L << 8, most = 1L << 12;
  const long grain = ThreadTeam::grain_of(n_rows, least, most);
  std::vector<BaseMatrix> parts(ThreadTeam::n_chunks(n_rows, grain));
  team.for_chunks(n_rows, grain, [&](long begin, long end, long chunk) {
    thread_local RowSum sum;
    sum.start(n_cols);
    for (int row = static_cast<int>(begin); row < end; ++row) {
      f(row, sum);
      sum.finish_row(parts[chunk]);
    }
  });
  return join_rows(n_cols, parts, team);
}

BaseMatrix product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team);

/// Rows of the result are ascending.
BaseMatrix transposed(const BaseMatrix& a);

}  // namespace sweepmesh
