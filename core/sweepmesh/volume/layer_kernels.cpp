#include "sweepmesh/volume/layer_kernels.h"

// Compiled for wide vectors where the machine has them. No fused multiply-add: bits are the same on
// all.
#if defined(__x86_64__) && defined(__GNUC__)
#define SWEEPMESH_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define SWEEPMESH_WIDE
#endif

namespace sweepmesh::kernels {

namespace {

/// Eight floats at any address; the compiler takes one register or two for them.
using Eight [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;

const Eight& eight(const float* p) {
  return *reinterpret_cast<const Eight*>(p);
}
Eight& eight(float* p) {
  return *reinterpret_cast<Eight*>(p);
}

}  // namespace

SWEEPMESH_WIDE void weighted_sum(float* y, const float* const* x, const float* a, int m,
                                 const float* s, long n) {
  long i = 0;
  for (; i + 32 <= n; i += 32) {  // the sums stay in registers over all j
    Eight s0 = {}, s1 = {}, s2 = {}, s3 = {};
    for (int j = 0; j < m; ++j) {
      const float* p = x[j] + i;
      s0 += a[j] * eight(p);
      s1 += a[j] * eight(p + 8);
      s2 += a[j] * eight(p + 16);
      s3 += a[j] * eight(p + 24);
    }
    eight(y + i) = s0 * eight(s + i);
    eight(y + i + 8) = s1 * eight(s + i + 8);
    eight(y + i + 16) = s2 * eight(s + i + 16);
    eight(y + i + 24) = s3 * eight(s + i + 24);
  }
  for (; i + 8 <= n; i += 8) {
    Eight sum = {};
    for (int j = 0; j < m; ++j) sum += a[j] * eight(x[j] + i);
    eight(y + i) = sum * eight(s + i);
  }
  for (; i < n; ++i) {
    float sum = 0.0f;
    for (int j = 0; j < m; ++j) sum += a[j] * x[j][i];
    y[i] = s[i] * sum;
  }
}

SWEEPMESH_WIDE void add_scaled(float* __restrict y, const float* __restrict x, float a, long n) {
  for (long i = 0; i < n; ++i) y[i] += a * x[i];
}

SWEEPMESH_WIDE void scale_and_add(float* __restrict y, const float* __restrict x, float a, long n) {
  for (long i = 0; i < n; ++i) y[i] = a * y[i] + x[i];
}

SWEEPMESH_WIDE void subtract(float* __restrict y, const float* __restrict x, long n) {
  for (long i = 0; i < n; ++i) y[i] -= x[i];
}

SWEEPMESH_WIDE void add_product(float* __restrict y, const float* __restrict x,
                                const float* __restrict s, float a, long n) {
  for (long i = 0; i < n; ++i) y[i] += a * s[i] * x[i];
}

SWEEPMESH_WIDE double dot(const float* __restrict x, const float* __restrict y, long n) {
  constexpr int lanes = 16;
  float sum[lanes] = {};
  long i = 0;
  for (; i + lanes <= n; i += lanes)
    for (int l = 0; l < lanes; ++l) sum[l] += x[i + l] * y[i + l];
  double total = 0.0;
  for (; i < n; ++i) total += static_cast<double>(x[i]) * y[i];
  for (int l = 0; l < lanes; ++l) total += sum[l];
  return total;
}

SWEEPMESH_WIDE void add_layers(float* __restrict y, const float* __restrict x,
                               const float* __restrict s, float lower, float upper, float across,
                               long n) {
  for (long i = 0; i < n; ++i) y[i] += s[i] * (lower * x[i] - across * x[i + 3]);
  for (long i = 0; i < n; ++i) y[i + 3] += s[i] * (upper * x[i + 3] - across * x[i]);
}

void solve_tridiagonal(const float* __restrict r, const float* __restrict pivot,
                       const float* __restrict coupling, float* __restrict z, long n) {
  float last[3] = {};
  for (long k = 0; k < n; ++k) {
    const float c = k > 0 ? coupling[k - 1] : 0.0f;
    for (int d = 0; d < 3; ++d) z[3 * k + d] = last[d] = pivot[k] * (r[3 * k + d] + c * last[d]);
  }
  for (long k = n - 2; k >= 0; --k) {
    const float f = pivot[k] * coupling[k];
    for (int d = 0; d < 3; ++d) z[3 * k + d] = last[d] = z[3 * k + d] + f * last[d];
  }
}

SWEEPMESH_WIDE void advance(float* __restrict x, float* __restrict d, const float* __restrict z,
                            float a, float b, long n) {
  for (long i = 0; i < n; ++i) {
    d[i] = a * d[i] + b * z[i];
    x[i] += d[i];
  }
}

}  // namespace sweepmesh::kernels
