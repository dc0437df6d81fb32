// The innermost loops of the layered solver, on plain arrays of floats: three for every node of a
// column, from the lowest up.
#pragma once

namespace sweepmesh::kernels {

void add_scaled(float* y, const float* x, float a, long n);        ///< y += a x
void combine(float* y, const float* x, float a, float b, long n);  ///< y = a y + b x
double dot(const float* x, const float* y, long n);
/// y = b + sum over j < m of a[j] x[j], where x[j] points to n floats; b may be null for zero. y is
/// none of them.
void sum_scaled(float* y, const float* b, const float* const* x, const float* a, int m, long n);
/// y = s (sum over j < m of a[j] x[j]); y is none of x.
void weighted_sum(float* y, const float* const* x, const float* a, int m, const float* s, long n);
/// y = b - s (sum over j < m of a[j] x[j]); y is neither b nor one of x.
void subtract_weighted_sum(float* y, const float* b, const float* const* x, const float* a, int m,
                           const float* s, long n);

/// Columns of one length, one behind the other in every vector, with a row of a base matrix each.
/// Column i of them has the entries row_begin[i] .. row_begin[i + 1] - 1 of `step` and `weight`,
/// the diagonal first: to a column that stands step[e] times three floats from it.
struct ColumnRows {
  int n_columns;
  long n;  ///< floats of a column
  const int *row_begin, *step;
  const float* weight;
};

/// y = b - O x, with O the rows without their diagonals, every level times its share. y is neither
/// b nor x.
void subtract_others(const ColumnRows& rows, const float* b, const float* x, const float* share,
                     float* y);

/// What stands on the diagonal of A, and beside it within columns. Arrays over levels hold
/// everything three times.
struct ColumnSprings {
  const float* share;
  const float *up, *down;                ///< springs to the next node of the column; 0 at its ends
  const float *up_beyond, *down_beyond;  ///< springs from its ends to what is fixed; 0 elsewhere
  /// Per column, null for zero: masses of the springs `up`, `down`, and of both.
  const float *lower, *upper, *across;
  const float *below, *above;  ///< per column, null for zero: masses of those beyond
};

/// y = A x, or b - A x where there is a b. y is no other vector; x may be read three floats beyond
/// the ends of the columns.
void multiply(const ColumnRows& rows, const ColumnSprings& springs, const float* b, const float* x,
              float* y);

/// Columns that are best solved at a time: one alone would wait for its own last result at every
/// step.
constexpr int n_abreast = 4;

/// Columns of `n_nodes` each, one behind the other in every array.
struct ColumnSystems {
  const float* r;       ///< right-hand sides; one float more behind the last, which is not used
  const float* pivot;   ///< inverse pivots of the factors, from the last node down to the first
  const float* spring;  ///< per layer inside a column
  long spring_stride;   ///< from column to column; 0: the same for all
  const float* across;  ///< per column
  long n_nodes;
};

/// For `n_columns` (1 or n_abreast): z = T^-1 r for the tridiagonal matrices with off-diagonals
/// -across spring, then y = alpha x + beta z + gamma y, where y is not read if gamma is 0.
/// `work` has 4 n_columns floats a node.
void solve_columns(const ColumnSystems& systems, int n_columns, float alpha, const float* x,
                   float beta, float gamma, float* y, float* work);

}  // namespace sweepmesh::kernels
