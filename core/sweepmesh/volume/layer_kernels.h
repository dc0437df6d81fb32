// The innermost loops of the layered solver, on plain arrays of n floats.
#pragma once

namespace sweepmesh::kernels {

void add_scaled(float* y, const float* x, float a, long n);                   ///< y += a x
void scale_and_add(float* y, const float* x, float a, long n);                ///< y = a y + x
void subtract(float* y, const float* x, long n);                              ///< y -= x
void multiply(float* y, const float* x, long n);                              ///< y *= x
void add_product(float* y, const float* x, const float* s, float a, long n);  ///< y += a s x
/// y = s (sum over j < m of a[j] x[j]), where x[j] points to n floats.
void weighted_sum(float* y, const float* const* x, const float* a, int m, const float* s, long n);
double dot(const float* x, const float* y, long n);

/// For every layer i of n / 3: y[i] += s[i] (lower x[i] - across x[i + 1]) and
/// y[i + 1] += s[i] (upper x[i + 1] - across x[i]); x and y hold n + 3 floats.
void add_layers(float* y, const float* x, const float* s, float lower, float upper, float across,
                long n);

/// z = T^-1 r for the tridiagonal matrix with off-diagonals -coupling[k] and the inverse pivots of
/// its Cholesky factorisation; n nodes of three floats.
void solve_tridiagonal(const float* r, const float* pivot, const float* coupling, float* z, long n);

/// d = a d + b z; x += d.
void advance(float* x, float* d, const float* z, float a, float b, long n);

}  // namespace sweepmesh::kernels
