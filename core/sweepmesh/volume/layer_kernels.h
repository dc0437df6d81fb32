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

/// Columns that are found from one of them, by steps of three floats.
struct Neighbours {
  const float* own;
  const int* step;

  const float* operator[](int j) const { return own + 3L * step[j]; }
};
void subtract_weighted_sum(float* y, const float* b, const Neighbours& x, const float* a, int m,
                           const float* s, long n);

/// One column's share of A x. Arrays over levels hold everything three times.
struct ColumnProduct {
  const float* x;         ///< the column's own; may be read three floats beyond its ends
  Neighbours neighbours;  ///< all that its base row has, itself too; `n_neighbours` of them
  const float* weight;
  int n_neighbours;
  const float* share;
  const float *up, *down;                ///< springs to the next node of the column; 0 at its ends
  const float *up_beyond, *down_beyond;  ///< springs from its ends to what is fixed; 0 elsewhere
  float lower, upper, across;            ///< masses of the springs `up`, `down`, and of both
  float below, above;                    ///< masses of those beyond
};

/// y = A x, or b - A x where there is a b. `n` floats; y is no other vector.
void multiply(const ColumnProduct& column, const float* b, float* y, long n);

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
