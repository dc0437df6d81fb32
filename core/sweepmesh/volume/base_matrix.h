// Sparse matrices over the columns of a base mesh, made row by row on several threads.
//
// Rows stand in parts of equal numbers, each made and kept as a whole by one thread. A row's
// entries stand in the order in which they were first added, so a matrix depends on what is added
// to its rows, not on the threads that do it.
#pragma once

#include <vector>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/floats.h"

namespace sweepmesh {

/// Entries are never zero. Single precision: what is made of matrices is a preconditioner, or
/// multiplied in single precision.
struct BaseMatrix {
  struct Part {
    std::vector<int> offset = {0};
    Ints column;
    Floats value;
  };
  struct Row {
    const int* column;
    const float* value;
    int n;
  };
  int n_rows = 0, n_cols = 0;
  int shift = 0;  ///< parts have 2^shift rows
  std::vector<Part> parts;

  Row row(int r) const {
    const Part& part = parts[r >> shift];
    const int* offset = part.offset.data() + (r - (r >> shift << shift));
    return {part.column.data() + offset[0], part.value.data() + offset[0], offset[1] - offset[0]};
  }
  bool is_zero() const {
    for (const Part& part : parts)
      if (!part.column.empty()) return false;
    return true;
  }
  /// Calls f(column, value) for the entries of a row.
  template <class F>
  void for_row(int r, F&& f) const {
    const Row e = row(r);
    for (int i = 0; i < e.n; ++i) f(e.column[i], e.value[i]);
  }
};

/// Sums up the entries of one row at a time, in double precision, and keeps the rows of a part.
class RowSum {
 public:
  void start(int n_cols) {
    if (static_cast<int>(place_.size()) < n_cols) place_.resize(n_cols, -1);
  }
  void add(int column, double value) {
    const int place = place_[column];
    if (place >= 0) {
      value_[place] += value;
      return;
    }
    place_[column] = n_;
    if (n_ == static_cast<int>(value_.size())) value_.resize(2 * value_.size() + 64);
    if (first_ + n_ == static_cast<int>(column_.size())) column_.resize(2 * column_.size() + 1024);
    column_[first_ + n_] = column;
    value_[n_++] = value;
  }
  /// Ends a row: what is not zero of it is kept.
  void finish_row() {
    if (rounded_.size() < column_.size()) rounded_.resize(column_.size());
    int end = first_;
    for (int i = 0; i < n_; ++i) {
      const int column = column_[first_ + i];
      const float value = static_cast<float>(value_[i]);
      place_[column] = -1;
      column_[end] = column;
      rounded_[end] = value;
      end += value != 0.0f ? 1 : 0;
    }
    offset_.push_back(end);
    first_ = end;
    n_ = 0;
  }
  /// Moves the rows that were kept to a part.
  void finish_part(BaseMatrix::Part& part) {
    part.offset = offset_;
    part.column.assign(column_.begin(), column_.begin() + first_);
    part.value.assign(rounded_.begin(), rounded_.begin() + first_);
    offset_.resize(1);
    first_ = 0;
  }

 private:
  std::vector<int> place_;  ///< per column of the matrix: index in the row, or -1
  int n_ = 0;               ///< entries of the row
  std::vector<double> value_;
  int first_ = 0;  ///< entries that are kept; the row's columns stand behind them
  std::vector<int> column_, offset_ = {0};
  std::vector<float> rounded_;
};

/// The matrix whose rows f(row, RowSum&) adds up. Linear in what is added.
template <class F>
BaseMatrix build_rows(int n_rows, int n_cols, ThreadTeam& team, F&& f) {
  constexpr int least = 8, most = 12;
  BaseMatrix matrix;
  matrix.n_rows = n_rows;
  matrix.n_cols = n_cols;
  matrix.shift = least;
  while (matrix.shift < most && n_rows >> matrix.shift >= 32) ++matrix.shift;
  const long grain = 1L << matrix.shift;
  matrix.parts.resize(ThreadTeam::n_chunks(n_rows, grain));
  team.for_chunks(n_rows, grain, [&](long begin, long end, long chunk) {
    thread_local RowSum sum;
    sum.start(n_cols);
    for (int row = static_cast<int>(begin); row < end; ++row) {
      f(row, sum);
      sum.finish_row();
    }
    sum.finish_part(matrix.parts[chunk]);
  });
  return matrix;
}

BaseMatrix zero_matrix(int n_rows, int n_cols);

BaseMatrix product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team);

/// A product with as many rows as columns; the diagonal's entry is the first of every row.
BaseMatrix square_product(const BaseMatrix& a, const BaseMatrix& b, ThreadTeam& team);

/// Rows of the result are ascending.
BaseMatrix transposed(const BaseMatrix& a);

}  // namespace sweepmesh
