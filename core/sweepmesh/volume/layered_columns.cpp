#include "sweepmesh/volume/layered_columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sweepmesh/volume/layer_kernels.h"

namespace sweepmesh {

namespace {

/// Calls f(class, first, last) for the layers first .. last - 1 of each class with both ends in
/// `low` .. `high`, and for the layers that only touch it from below or above.
template <class F>
void for_layers(const LayeredSystem& s, int low, int high, F&& f) {
  for (int t = 0; t < s.n_bands(); ++t) {
    const int end = s.band_begin[t + 1];
    if (end - 1 < low - 1) continue;
    if (s.band_begin[t] > high) break;
    const int first = std::max(low - 1, s.band_begin[t]), last = std::min(high + 1, end - 1);
    if (first < last) f(s.layers[2 * t], first, last);
    if (end - 1 <= high && t + 1 < s.n_bands()) f(s.layers[2 * t + 1], end - 1, end);
  }
}

}  // namespace

/// What a thread needs for the columns it works at.
struct LayeredColumns::Scratch {
  std::vector<const float*> streams;
  Floats memory;
  float *right, *spring, *work;  ///< for n_abreast columns

  /// For columns of `length` floats.
  void fit(long length) {
    constexpr long n = kernels::n_abreast;
    const long n_right = n * length + 1, n_spring = n * (length / 3), n_work = 4 * n_spring;
    if (static_cast<long>(memory.size()) < n_right + n_spring + n_work)
      memory.resize(n_right + n_spring + n_work);
    right = memory.data();
    spring = right + n_right;
    work = spring + n_spring;
    right[n * length] = 0.0f;
  }
  /// The neighbours' values from level `first` on.
  const float* const* gather(const LayeredSystem& s, const BaseMatrix::Row& row, const float* x,
                             int first) {
    if (static_cast<int>(streams.size()) < row.n) streams.resize(row.n);
    for (int e = 0; e < row.n; ++e) streams[e] = s.at(x, row.column[e], first);
    return streams.data();
  }
};

LayeredColumns::LayeredColumns(const LayeredSystem& system, ThreadTeam& team)
    : s_(system), team_(team) {
  set_springs();
  make_chunks();
  find_reach();
  find_whole();
  find_runs();
  find_steps();
  factor();
  find_radius();
}

void LayeredColumns::set_springs() {
  const long n_layers = static_cast<long>(s_.spring.size()) / 3;
  spring_.resize(n_layers);
  for (Floats* v : {&up_, &down_, &up_beyond_, &down_beyond_}) v->assign(s_.share.size(), 0.0f);
  int t = 0;
  for (long k = 0; k < n_layers; ++k) {
    spring_[k] = s_.spring[3 * k];
    const bool is_last = k + 1 == s_.band_begin[t + 1];
    if (is_last) ++t;
    std::fill_n((is_last ? up_beyond_ : up_).begin() + 3 * k, 3, spring_[k]);
    std::fill_n((is_last ? down_beyond_ : down_).begin() + 3 * (k + 1), 3, spring_[k]);
  }
}

void LayeredColumns::make_chunks() {
  constexpr long least = 1L << 12, most = 1L << 13;  // floats: several stages' stay in the cache
  const long grain = ThreadTeam::grain_of(size(), least, most);
  chunk_.push_back(0);
  for (int c = 0; c < s_.n_columns(); ++c)
    if (s_.offset[c + 1] - s_.offset[chunk_.back()] >= grain) chunk_.push_back(c + 1);
  if (chunk_.back() != s_.n_columns()) chunk_.push_back(s_.n_columns());
}

int LayeredColumns::chunks_before(int column) const {
  return static_cast<int>(std::lower_bound(chunk_.begin(), chunk_.end(), column) - chunk_.begin());
}

void LayeredColumns::find_reach() {
  reach_.resize(n_chunks());
  team_.for_chunks(n_chunks(), 1, [&](long chunk, long, long) {
    int end = chunk_[chunk + 1];
    for (const BaseRows& rows : s_.rows)
      for (int c = chunk_[chunk]; c < chunk_[chunk + 1]; ++c)
        rows.matrix.for_row(c, [&](int b, float) { end = std::max(end, b + 1); });
    reach_[chunk] = chunks_before(end);
  });
}

void LayeredColumns::find_whole() {
  whole_band_.assign(s_.n_columns(), -1);
  for_columns([&](int c) {
    for (int t = 0; t < s_.n_bands(); ++t)
      if (s_.band_begin[t] == s_.low[c] && s_.band_begin[t + 1] == s_.high[c] + 1)
        whole_band_[c] = t;
  });
}

void LayeredColumns::find_runs() {
  run_end_.resize(s_.n_columns());
  team_.for_chunks(n_chunks(), 1, [&](long chunk, long, long) {
    const int end = chunk_[chunk + 1];
    for (int c = end - 1; c >= chunk_[chunk]; --c) {
      const bool goes_on = c + 1 < end && is_whole(c) && whole_band_[c] == whole_band_[c + 1];
      run_end_[c] = goes_on ? run_end_[c + 1] : c + 1;
    }
  });
}

void LayeredColumns::find_steps() {
  const int n = s_.n_columns();
  row_begin_.assign(n + 1, 0);
  for_columns([&](int c) {
    if (is_whole(c)) row_begin_[c + 1] = s_.rows[whole_band_[c]].matrix.row(c).n;
  });
  std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
  step_.resize(row_begin_.back());
  weight_.resize(row_begin_.back());
  for_columns([&](int c) {
    if (!is_whole(c)) return;
    int e = row_begin_[c];
    s_.rows[whole_band_[c]].matrix.for_row(c, [&](int b, float w) {
      step_[e] = static_cast<int>((s_.start[b] - s_.start[c]) / 3);
      weight_[e++] = w;
    });
  });
}

void LayeredColumns::factor() {
  pivot_.resize(s_.size() / 3);
  for_columns([&](int c) {
    const int low = s_.low[c], high = s_.high[c];
    thread_local std::vector<double> diagonal, across;
    diagonal.assign(high - low + 1, 0.0);
    across.assign(high - low + 2, 0.0);
    for_free_bands(s_, c, [&](const BaseRows& rows, int first, int last) {
      for (int k = first; k < last; ++k)
        diagonal[k - low] = static_cast<double>(rows.diagonal[c]) * s_.share[3L * k];
    });
    for_layers(s_, low, high, [&](const LayerClass& l, int first, int last) {
      for (int k = first; k < last; ++k) {
        const double spring = spring_[k];
        if (k >= low && k <= high) diagonal[k - low] += spring * l.lower[c];
        if (k + 1 >= low && k + 1 <= high) diagonal[k + 1 - low] += spring * l.upper[c];
        if (k >= low && k + 1 <= high) across[k + 1 - low] = spring * l.across[c];
      }
    });
    double pivot = 0.0;
    for (int i = high - low; i >= 0; --i) {
      const double d = diagonal[i] - across[i + 1] * across[i + 1] * pivot;
      pivot = diagonal[i] > 0.0 && d > 0.0 ? 1.0 / d : 0.0;
      pivot_[s_.offset[c] / 3 + i] = static_cast<float>(pivot);
    }
  });
}

void LayeredColumns::find_radius() {
  std::vector<double> radius(chunk_.size(), radius_);
  team_.for_chunks(static_cast<long>(chunk_.size()) - 1, 1, [&](long chunk, long, long) {
    for (const BaseRows& rows : s_.rows)
      for (int c = chunk_[chunk]; c < chunk_[chunk + 1]; ++c) {
        if (rows.diagonal[c] <= 0.0f) continue;
        double sum = 0.0;
        rows.matrix.for_row(c, [&](int, float w) { sum += std::abs(w); });
        radius[chunk] = std::max(radius[chunk], sum / rows.diagonal[c]);
      }
  });
  radius_ = *std::max_element(radius.begin(), radius.end());
}

void LayeredColumns::multiply_run(int first, int end, const float* b, const float* x,
                                  float* y) const {
  const int t = whole_band_[first], low = s_.low[first];
  const auto mass = [&](int v, const Floats LayerClass::*which) -> const float* {
    if (v < 0 || (s_.layers[v].*which).empty()) return nullptr;
    return (s_.layers[v].*which).data() + first;
  };
  const long level = 3L * low, at = s_.offset[first];
  const kernels::ColumnSprings springs = {s_.share.data() + level,
                                          up_.data() + level,
                                          down_.data() + level,
                                          up_beyond_.data() + level,
                                          down_beyond_.data() + level,
                                          mass(2 * t, &LayerClass::lower),
                                          mass(2 * t, &LayerClass::upper),
                                          mass(2 * t, &LayerClass::across),
                                          mass(2 * t - 1, &LayerClass::upper),
                                          mass(2 * t + 1, &LayerClass::lower)};
  kernels::multiply(rows(first, end - first), springs, b ? b + at : nullptr, x + at, y + at);
}

void LayeredColumns::multiply_any(const float* x, int column, Scratch& scratch, float* y) const {
  const int low = s_.low[column], high = s_.high[column];
  std::fill_n(y, length(column), 0.0f);
  for_free_bands(s_, column, [&](const BaseRows& rows, int first, int last) {
    const BaseMatrix::Row row = rows.matrix.row(column);
    const float* const* streams = scratch.gather(s_, row, x, first);
    kernels::weighted_sum(y + 3L * (first - low), streams, row.value, row.n,
                          s_.share.data() + 3L * first, 3L * (last - first));
  });
  const float* own = s_.at(x, column, low);
  const auto add = [&](int k, int other, float weight) {
    for (int d = 0; d < 3; ++d) y[3L * (k - low) + d] += weight * own[3L * (other - low) + d];
  };
  for_layers(s_, low, high, [&](const LayerClass& l, int first, int last) {
    for (int k = first; k < last; ++k) {
      if (k >= low) add(k, k, spring_[k] * l.lower[column]);
      if (k < high) add(k + 1, k + 1, spring_[k] * l.upper[column]);
      if (k < low || k >= high) continue;
      add(k, k + 1, -spring_[k] * l.across[column]);
      add(k + 1, k, -spring_[k] * l.across[column]);
    }
  });
}

void LayeredColumns::multiply(int chunk, const float* b, const float* x, float* y) const {
  thread_local Scratch scratch;
  for (int c = chunk_[chunk], next = c; c < chunk_[chunk + 1]; c = next) {
    next = run_end_[c];
    if (length(c) == 0) continue;
    if (is_whole(c)) {
      multiply_run(c, next, b, x, y);
      continue;
    }
    float* out = y + s_.offset[c];
    multiply_any(x, c, scratch, out);
    if (b) kernels::combine(out, b + s_.offset[c], -1.0f, 1.0f, length(c));
  }
}

double LayeredColumns::multiply(int chunk, const Floats& x, Floats& y) const {
  multiply(chunk, nullptr, x.data(), y.data());
  return dot(chunk, x, y);
}

double LayeredColumns::dot(int chunk, const Floats& x, const Floats& y) const {
  constexpr long few = 1L << 10;  // are summed up in single precision
  double sum = 0.0;
  const long end = s_.offset[chunk_[chunk + 1]];
  for (long i = s_.offset[chunk_[chunk]]; i < end; i += few)
    sum += kernels::dot(x.data() + i, y.data() + i, std::min(few, end - i));
  return sum;
}

void LayeredColumns::add_stage(std::function<void(int)> work,
                               std::vector<ChunkStage>& stages) const {
  stages.push_back({n_chunks(), &reach_, std::move(work)});
}

void LayeredColumns::add_residual(const Floats& b, const Floats& x, Floats& r,
                                  std::vector<ChunkStage>& stages) const {
  add_stage([this, &b, &x, &r](int chunk) { multiply(chunk, b.data(), x.data(), r.data()); },
            stages);
}

void LayeredColumns::right_of(const float* b, const float* y, int column, Scratch& scratch,
                              float* out) const {
  std::copy_n(b, length(column), out);
  for_free_bands(s_, column, [&](const BaseRows& rows, int first, int last) {
    const BaseMatrix::Row all = rows.matrix.row(column),
                          row = {all.column + 1, all.value + 1, all.n - 1};  // but the diagonal
    const float* const* streams = scratch.gather(s_, row, y, first);
    const long from = 3L * (first - s_.low[column]);
    kernels::subtract_weighted_sum(out + from, b + from, streams, row.value, row.n,
                                   s_.share.data() + 3L * first, 3L * (last - first));
  });
}

void LayeredColumns::couplings_of(int column, float* out) const {
  const int low = s_.low[column], high = s_.high[column];
  for_layers(s_, low, high, [&](const LayerClass& l, int first, int last) {
    for (int k = std::max(first, low); k < std::min(last, high); ++k)
      out[k - low] = l.across[column] * spring_[k];
  });
}

bool LayeredColumns::are_alike(int first, int n) const {
  if (is_whole(first) && first + n <= run_end_[first]) return true;
  for (int c = first + 1; c < first + n; ++c)
    if (s_.low[c] != s_.low[first] || s_.high[c] != s_.high[first]) return false;
  return true;
}

void LayeredColumns::step_columns(const Floats& b, const Floats* y, const Mix& mix, int first,
                                  int n, Scratch& scratch, Floats& result) const {
  constexpr float one[kernels::n_abreast] = {1.0f, 1.0f, 1.0f, 1.0f};
  const long each = length(first), at = s_.offset[first];
  scratch.fit(each);
  const bool are_whole = is_whole(first) && first + n <= run_end_[first];
  if (y && are_whole)
    kernels::subtract_others(rows(first, n), b.data() + at, y->data() + at,
                             s_.share.data() + 3L * s_.low[first], scratch.right);
  for (int i = 0; i < n && y && !are_whole; ++i)
    right_of(b.data() + at + i * each, y->data(), first + i, scratch, scratch.right + i * each);
  kernels::ColumnSystems systems = {
      y ? scratch.right : b.data() + at, pivot_.data() + at / 3, nullptr, 0, one, each / 3};
  if (are_whole && each > 3) {
    systems.spring = spring_.data() + s_.low[first];
    systems.across = s_.layers[2 * whole_band_[first]].across.data() + first;
  } else {
    for (int i = 0; i < n; ++i) couplings_of(first + i, scratch.spring + i * (each / 3));
    systems.spring = scratch.spring;
    systems.spring_stride = each / 3;
  }
  kernels::solve_columns(systems, n, mix.alpha, (y ? *y : b).data() + at, mix.beta, mix.gamma,
                         result.data() + at, scratch.work);
}

void LayeredColumns::step(int chunk, const Floats& b, const Floats* y, const Mix& mix,
                          Floats& result) const {
  thread_local Scratch scratch;
  const int end = chunk_[chunk + 1];
  for (int c = chunk_[chunk], n = 1; c < end; c += n) {
    n = c + kernels::n_abreast <= end && are_alike(c, kernels::n_abreast) ? kernels::n_abreast : 1;
    if (length(c) == 0) continue;
    step_columns(b, y, mix, c, n, scratch, result);
  }
}

LayeredColumns::Chebyshev LayeredColumns::polynomial() const {
  // For the interval [radius / 5, radius] (Saad, Iterative methods, 12.3.2).
  const double upper = radius_, lower = radius_ / 5.0;
  const double theta = 0.5 * (upper + lower), delta = 0.5 * (upper - lower), sigma = theta / delta;
  const double rho = 1.0 / sigma, next = 1.0 / (2.0 * sigma - rho);
  return {static_cast<float>(1.0 / theta), static_cast<float>(next * rho),
          static_cast<float>(2.0 * next / delta)};
}

void LayeredColumns::add_smoother_from_zero(const Floats& b, Floats& x, Floats& work,
                                            std::vector<ChunkStage>& stages) const {
  const Chebyshev p = polynomial();
  const Mix first = {0.0f, p.first, 0.0f}, second = {1.0f + p.again - p.second, p.second, 0.0f};
  add_stage([=, this, &b, &work](int c) { step(c, b, nullptr, first, work); }, stages);
  add_stage([=, this, &b, &work, &x](int c) { step(c, b, &work, second, x); }, stages);
}

void LayeredColumns::add_smoother(const Floats& b, Floats& x, Floats& work, double* dots,
                                  std::vector<ChunkStage>& stages) const {
  const Chebyshev p = polynomial();
  const Mix first = {1.0f - p.first, p.first, 0.0f},
            second = {1.0f + p.again - p.second, p.second, -p.again};
  add_stage([=, this, &b, &work, &x](int c) { step(c, b, &x, first, work); }, stages);
  add_stage(
      [=, this, &b, &work, &x](int c) {
        step(c, b, &work, second, x);
        if (dots) dots[c] = dot(c, b, x);
      },
      stages);
}

}  // namespace sweepmesh
