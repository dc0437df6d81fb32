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

/// Floats at any address; the compiler takes one register or two for eight.
using Eight [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
using Four [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

const Eight& eight(const float* p) {
  return *reinterpret_cast<const Eight*>(p);
}
Eight& eight(float* p) {
  return *reinterpret_cast<Eight*>(p);
}
const Four& four(const float* p) {
  return *reinterpret_cast<const Four*>(p);
}
Four& four(float* p) {
  return *reinterpret_cast<Four*>(p);
}

/// Writes put(place, sum over j of a[j] x[j]) for all n places, eight at a time. The last places
/// are done twice rather than one by one.
template <class Streams, class Put>
[[gnu::always_inline]] inline void sum_streams(const Streams& x, const float* a, int m, long n,
                                               Put&& put) {
  if (n < 8) {
    for (long i = 0; i < n; ++i) {
      float sum = 0.0f;
      for (int j = 0; j < m; ++j) sum += a[j] * x[j][i];
      put(i, sum);
    }
    return;
  }
  for (long i = 0; i < n; i += 32) {  // the sums stay in registers over all j
    const long last = n - 8, i0 = i < last ? i : last, i1 = i + 8 < last ? i + 8 : last,
               i2 = i + 16 < last ? i + 16 : last, i3 = i + 24 < last ? i + 24 : last;
    Eight s0 = {}, s1 = {}, s2 = {}, s3 = {};
    for (int j = 0; j < m; ++j) {
      const float* p = x[j];
      s0 += a[j] * eight(p + i0);
      s1 += a[j] * eight(p + i1);
      s2 += a[j] * eight(p + i2);
      s3 += a[j] * eight(p + i3);
    }
    put(i0, s0);
    put(i1, s1);
    put(i2, s2);
    put(i3, s3);
  }
}

struct Plain {
  float* y;
  [[gnu::always_inline]] void operator()(long i, float sum) const { y[i] = sum; }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const { eight(y + i) = sum; }
};

struct Added {
  float* y;
  const float* b;
  [[gnu::always_inline]] void operator()(long i, float sum) const { y[i] = b[i] + sum; }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const {
    eight(y + i) = eight(b + i) + sum;
  }
};

struct Scaled {
  float* y;
  const float* s;
  [[gnu::always_inline]] void operator()(long i, float sum) const { y[i] = s[i] * sum; }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const {
    eight(y + i) = eight(s + i) * sum;
  }
};

struct Subtracted {
  float* y;
  const float *b, *s;
  [[gnu::always_inline]] void operator()(long i, float sum) const { y[i] = b[i] - s[i] * sum; }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const {
    eight(y + i) = eight(b + i) - eight(s + i) * sum;
  }
};

/// Columns that are found from one of them.
struct Neighbours {
  const float* own;
  const int* step;

  [[gnu::always_inline]] const float* operator[](int j) const { return own + 3L * step[j]; }
};

/// Masses of the springs of one column.
struct Masses {
  float lower, upper, across, below, above;

  Masses(const ColumnSprings& s, int column) {
    const auto of = [column](const float* all) { return all ? all[column] : 0.0f; };
    lower = of(s.lower);
    upper = of(s.upper);
    across = of(s.across);
    below = of(s.below);
    above = of(s.above);
  }
};

/// A x at some places, given the sum over the base row there.
struct Product {
  const ColumnSprings& c;
  const Masses& mass;
  const float* x;
  float* y;

  template <class T, class At>
  [[gnu::always_inline]] T value(long i, const T& sum, At&& at) const {
    const T up = at(c.up + i), down = at(c.down + i);
    const T diagonal = mass.lower * up + mass.upper * down + mass.above * at(c.up_beyond + i) +
                       mass.below * at(c.down_beyond + i);
    return at(c.share + i) * sum + diagonal * at(x + i) -
           mass.across * (down * at(x + i - 3) + up * at(x + i + 3));
  }
  [[gnu::always_inline]] float at(long i, float sum) const {
    return value(i, sum, [](const float* p) { return *p; });
  }
  [[gnu::always_inline]] Eight at(long i, const Eight& sum) const {
    return value(i, sum, [](const float* p) { return eight(p); });
  }
  [[gnu::always_inline]] void operator()(long i, float sum) const { y[i] = at(i, sum); }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const {
    eight(y + i) = at(i, sum);
  }
};

struct ProductRest {
  Product product;
  const float* b;

  [[gnu::always_inline]] void operator()(long i, float sum) const {
    product.y[i] = b[i] - product.at(i, sum);
  }
  [[gnu::always_inline]] void operator()(long i, const Eight& sum) const {
    eight(product.y + i) = eight(b + i) - product.at(i, sum);
  }
};

[[gnu::always_inline]] inline double inner_product(const float* x, const float* y, long n) {
  Eight s0 = {}, s1 = {};
  long i = 0;
  for (; i + 16 <= n; i += 16) {
    s0 += eight(x + i) * eight(y + i);
    s1 += eight(x + i + 8) * eight(y + i + 8);
  }
  if (i + 8 <= n) {
    s0 += eight(x + i) * eight(y + i);
    i += 8;
  }
  s0 += s1;
  double total = 0.0;
  for (int l = 0; l < 8; ++l) total += s0[l];
  for (; i < n; ++i) total += static_cast<double>(x[i]) * y[i];
  return total;
}

Four load_three(const float* p) {
  return Four{p[0], p[1], p[2], 0.0f};
}
void store_three(float* p, const Four& v) {
  p[0] = v[0];
  p[1] = v[1];
  p[2] = v[2];
}

/// Of node k of n: of the last one nothing is read or written beyond its three floats.
[[gnu::always_inline]] inline Four load(const float* p, long k, long n) {
  return k + 1 < n ? four(p + 3 * k) : load_three(p + 3 * k);
}

/// y = alpha x + beta z + gamma y.
struct Mix {
  float alpha, beta, gamma;
  const float* x;
  float* y;
};

/// From the last node down to the first: the right-hand sides, eliminated, to `work`.
template <int m>
[[gnu::always_inline]] inline void eliminate(const ColumnSystems& c, const float (&across)[m],
                                             float* work) {
  const long n = c.n_nodes;
  Four last[m] = {};
  for (long k = n - 1; k >= 0; --k)
    for (int i = 0; i < m; ++i) {
      const float f = k + 1 < n ? across[i] * c.spring[i * c.spring_stride + k] : 0.0f;
      last[i] = c.pivot[i * n + k] * (four(c.r + 3 * (i * n + k)) + f * last[i]);
      four(work + 4 * (m * k + i)) = last[i];
    }
}

/// From the first node up.
template <int m, bool has_old>
[[gnu::always_inline]] inline void substitute(const ColumnSystems& c, const float (&across)[m],
                                              const Mix& mix, const float* work) {
  const long n = c.n_nodes;
  Four z[m] = {}, old[m] = {};
  if constexpr (has_old)
    for (int i = 0; i < m; ++i) old[i] = load(mix.y + 3 * i * n, 0, n);
  for (long k = 0; k < n; ++k)
    for (int i = 0; i < m; ++i) {
      float* y = mix.y + 3 * i * n;
      const float spring = k > 0 ? c.spring[i * c.spring_stride + k - 1] : 0.0f;
      z[i] = four(work + 4 * (m * k + i)) + c.pivot[i * n + k] * (across[i] * spring) * z[i];
      Four v = mix.alpha * load(mix.x + 3 * i * n, k, n) + mix.beta * z[i];
      if constexpr (has_old) v += mix.gamma * old[i];
      if (k + 1 == n) {
        store_three(y + 3 * k, v);
        continue;
      }
      if constexpr (has_old) old[i] = load(y, k + 1, n);
      four(y + 3 * k) = v;  // the fourth is written over by the next
    }
}

template <int m>
[[gnu::always_inline]] inline void solve_abreast(const ColumnSystems& systems, const Mix& mix,
                                                 float* work) {
  const ColumnSystems c = systems;
  float across[m];
  for (int i = 0; i < m; ++i) across[i] = c.across[i];
  eliminate(c, across, work);
  if (mix.gamma != 0.0f)
    substitute<m, true>(c, across, mix, work);
  else
    substitute<m, false>(c, across, mix, work);
}

}  // namespace

SWEEPMESH_WIDE void sum_scaled(float* y, const float* b, const float* const* x, const float* a,
                               int m, long n) {
  if (b)
    sum_streams(x, a, m, n, Added{y, b});
  else
    sum_streams(x, a, m, n, Plain{y});
}

SWEEPMESH_WIDE void weighted_sum(float* y, const float* const* x, const float* a, int m,
                                 const float* s, long n) {
  sum_streams(x, a, m, n, Scaled{y, s});
}

SWEEPMESH_WIDE void subtract_weighted_sum(float* y, const float* b, const float* const* x,
                                          const float* a, int m, const float* s, long n) {
  sum_streams(x, a, m, n, Subtracted{y, b, s});
}

SWEEPMESH_WIDE void subtract_others(const ColumnRows& rows, const float* b, const float* x,
                                    const float* share, float* y) {
  const ColumnRows r = rows;
  for (int c = 0; c < r.n_columns; ++c) {
    const int first = r.row_begin[c] + 1;
    sum_streams(Neighbours{x + c * r.n, r.step + first}, r.weight + first,
                r.row_begin[c + 1] - first, r.n, Subtracted{y + c * r.n, b + c * r.n, share});
  }
}

SWEEPMESH_WIDE void add_scaled(float* __restrict y, const float* __restrict x, float a, long n) {
  for (long i = 0; i < n; ++i) y[i] += a * x[i];
}

SWEEPMESH_WIDE void combine(float* __restrict y, const float* __restrict x, float a, float b,
                            long n) {
  for (long i = 0; i < n; ++i) y[i] = a * y[i] + b * x[i];
}

SWEEPMESH_WIDE double dot(const float* x, const float* y, long n) {
  return inner_product(x, y, n);
}

SWEEPMESH_WIDE void multiply(const ColumnRows& rows, const ColumnSprings& springs, const float* b,
                             const float* x, float* y) {
  const ColumnRows r = rows;
  const ColumnSprings s = springs;
  for (int c = 0; c < r.n_columns; ++c) {
    const int first = r.row_begin[c], m = r.row_begin[c + 1] - first;
    const Neighbours all = {x + c * r.n, r.step + first};
    const Masses masses(s, c);
    const Product product = {s, masses, x + c * r.n, y + c * r.n};
    if (b)
      sum_streams(all, r.weight + first, m, r.n, ProductRest{product, b + c * r.n});
    else
      sum_streams(all, r.weight + first, m, r.n, product);
  }
}

SWEEPMESH_WIDE void solve_columns(const ColumnSystems& systems, int n_columns, float alpha,
                                  const float* x, float beta, float gamma, float* y, float* work) {
  const Mix mix = {alpha, beta, gamma, x, y};
  if (n_columns == n_abreast)
    solve_abreast<n_abreast>(systems, mix, work);
  else
    solve_abreast<1>(systems, mix, work);
}

}  // namespace sweepmesh::kernels
