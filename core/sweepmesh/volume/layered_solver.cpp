#include "sweepmesh/volume/layered_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "sweepmesh/volume/layer_kernels.h"

namespace sweepmesh {
namespace {

using Vector = std::vector<float>;

constexpr long floats_per_chunk = 1L << 16;

/// Base matrices in compressed rows, for transfers between levels.
struct Transfer {
  std::vector<int> offset, column;
  std::vector<float> weight;

  explicit Transfer(BaseMatrix m)
      : offset(std::move(m.offset)),
        column(std::move(m.column)),
        weight(m.value.begin(), m.value.end()) {}
};

/// One level of the cycle: the system, its factored columns and its work space.
class Level {
 public:
  Level(const LayeredSystem& system, ThreadTeam& team) : s_(system), team_(team) {
    make_chunks();
    factor();
    find_radius();
  }

  long size() const { return s_.size(); }
  const LayeredSystem& system() const { return s_; }

  /// Calls f(column) for all columns that hold something; sums what it returns in a fixed order.
  template <class F>
  double for_columns(F&& f) const {
    return team_.sum_chunks(static_cast<long>(chunk_.size()) - 1, 1, 0.0, [&](long chunk, long) {
      double sum = 0.0;
      for (int c = chunk_[chunk]; c < chunk_[chunk + 1]; ++c)
        if (s_.high[c] >= s_.low[c]) sum += f(c);
      return sum;
    });
  }

  /// y = A x for one column.
  void apply(const float* x, int column, float* y) const;
  /// y = y - A x.
  void subtract_product(const float* x, Vector& y) const {
    for_columns([&](int c) {
      thread_local Vector product;
      product.resize(length(c));
      apply(x, c, product.data());
      kernels::subtract(y.data() + s_.offset[c], product.data(), length(c));
      return 0.0;
    });
  }

  /// x += polynomial(D^-1 A) D^-1 r, where D is A without couplings between columns. On return r is
  /// the new residual if asked for; otherwise it is spoiled.
  void smooth(Vector& x, Vector& r, Vector& d, bool needs_residual) const;

  long length(int c) const { return s_.offset[c + 1] - s_.offset[c]; }

 private:
  void make_chunks();
  void factor();
  void find_radius();
  /// d = a d + b D^-1 r; x += d.
  void step(Vector& x, const Vector& r, Vector& d, float a, float b) const;

  const LayeredSystem& s_;
  ThreadTeam& team_;
  std::vector<int> chunk_;  ///< first column of every chunk, and the end
  Vector pivot_;            ///< inverse pivots of the columns, one a node
  double radius_ = 2.0;     ///< bound of the spectrum of D^-1 A
};

void Level::make_chunks() {
  chunk_.push_back(0);
  for (int c = 0; c < s_.n_columns(); ++c)
    if (s_.offset[c + 1] - s_.offset[chunk_.back()] >= floats_per_chunk) chunk_.push_back(c + 1);
  if (chunk_.back() != s_.n_columns()) chunk_.push_back(s_.n_columns());
}

/// Calls f(class, first, last) for the layers first .. last - 1 of each class with both ends in
/// `low` .. `high`, and for the layers that only touch it from below or above.
template <class F>
void for_layers(const LayeredSystem& s, int low, int high, F&& f) {
  for (int t = 0; t < s.n_bands(); ++t) {
    const int end = s.band_begin[t + 1];
    if (end - 1 < low - 1) continue;
    if (s.band_begin[t] > high) break;
    const int first = std::max(low - 1, s.band_begin[t]), last = std::min(high + 1, end - 1);
    if (first < last) f(2 * t, first, last);
    if (end - 1 >= low - 1 && end - 1 <= high && t + 1 < s.n_bands()) f(2 * t + 1, end - 1, end);
  }
}

void Level::apply(const float* x, int column, float* y) const {
  const int low = s_.low[column], high = s_.high[column];
  thread_local std::vector<const float*> streams;
  std::fill(y, y + length(column), 0.0f);
  for (int t = 0; t < s_.n_bands(); ++t) {
    const BaseRows& rows = s_.rows[t];
    const int first = std::max(low, s_.band_begin[t]);
    const int last = std::min(high + 1, s_.band_begin[t + 1]);
    if (first >= last || rows.diagonal[column] == 0.0f) continue;
    const long n = 3L * (last - first);
    float* out = s_.at(y - s_.offset[column], column, first);
    streams.clear();
    for (int e = rows.offset[column]; e < rows.offset[column + 1]; ++e)
      streams.push_back(s_.at(x, rows.neighbour[e], first));
    kernels::weighted_sum(out, streams.data(), rows.weight.data() + rows.offset[column],
                          static_cast<int>(streams.size()), s_.share.data() + 3L * first, n);
  }
  const float* in = x + s_.offset[column] - 3L * low;
  float* out = y - 3L * low;
  for_layers(s_, low, high, [&](int c, int first, int last) {
    const LayerClass& l = s_.layers[c];
    const float* spring = s_.spring.data();
    if (first < low && last >= low) {  // the layer below the hull
      kernels::add_product(out + 3L * low, in + 3L * low, spring + 3L * (low - 1), l.upper[column],
                           3);
    }
    if (first <= high && last > high) {  // the layer above it
      kernels::add_product(out + 3L * high, in + 3L * high, spring + 3L * high, l.lower[column], 3);
    }
    const int a = std::max(first, low), b = std::min(last, high);
    if (a < b)
      kernels::add_layers(out + 3L * a, in + 3L * a, spring + 3L * a, l.lower[column],
                          l.upper[column], l.across[column], 3L * (b - a));
  });
}

void Level::factor() {
  pivot_.assign(s_.size() / 3, 0.0f);
  for_columns([&](int c) {
    const int low = s_.low[c], high = s_.high[c];
    thread_local std::vector<double> diagonal, across;
    diagonal.assign(high - low + 1, 0.0);
    across.assign(high - low + 1, 0.0);
    for (int t = 0; t < s_.n_bands(); ++t)
      for (int k = std::max(low, s_.band_begin[t]); k < std::min(high + 1, s_.band_begin[t + 1]);
           ++k)
        diagonal[k - low] = static_cast<double>(s_.rows[t].diagonal[c]) * s_.share[3L * k];
    for_layers(s_, low, high, [&](int v, int first, int last) {
      const LayerClass& l = s_.layers[v];
      for (int k = first; k < last; ++k) {
        const double spring = s_.spring[3L * k];
        if (k >= low && k <= high) diagonal[k - low] += spring * l.lower[c];
        if (k + 1 >= low && k + 1 <= high) diagonal[k + 1 - low] += spring * l.upper[c];
        if (k >= low && k + 1 <= high) across[k - low] = spring * l.across[c];
      }
    });
    double pivot = 0.0, last_across = 0.0;
    for (int i = 0; i <= high - low; ++i) {
      const double d = diagonal[i] - last_across * last_across * pivot;
      pivot = diagonal[i] > 0.0 && d > 0.0 ? 1.0 / d : 0.0;
      pivot_[s_.offset[c] / 3 + i] = static_cast<float>(pivot);
      last_across = across[i];
    }
    return 0.0;
  });
}

void Level::find_radius() {
  std::vector<double> radius(chunk_.size(), radius_);
  team_.for_chunks(static_cast<long>(chunk_.size()) - 1, 1, [&](long chunk, long, long) {
    for (const BaseRows& rows : s_.rows)
      for (int c = chunk_[chunk]; c < chunk_[chunk + 1]; ++c) {
        if (rows.diagonal[c] <= 0.0f) continue;
        double sum = 0.0;
        for (int e = rows.offset[c]; e < rows.offset[c + 1]; ++e) sum += std::abs(rows.weight[e]);
        radius[chunk] = std::max(radius[chunk], sum / rows.diagonal[c]);
      }
  });
  radius_ = *std::max_element(radius.begin(), radius.end());
}

void Level::step(Vector& x, const Vector& r, Vector& d, float a, float b) const {
  for_columns([&](int c) {
    thread_local Vector z, couplings;
    const long n = length(c);
    const int low = s_.low[c], high = s_.high[c];
    z.resize(n);
    couplings.assign(n / 3 + 1, 0.0f);
    for_layers(s_, low, high, [&](int v, int first, int last) {
      const float across = s_.layers[v].across[c];
      for (int k = std::max(first, low); k < std::min(last, high); ++k)
        couplings[k - low] = across * s_.spring[3L * k];
    });
    kernels::solve_tridiagonal(r.data() + s_.offset[c], pivot_.data() + s_.offset[c] / 3,
                               couplings.data(), z.data(), n / 3);
    kernels::advance(x.data() + s_.offset[c], d.data() + s_.offset[c], z.data(), a, b, n);
    return 0.0;
  });
}

void Level::smooth(Vector& x, Vector& r, Vector& d, bool needs_residual) const {
  // Chebyshev iteration for the interval [radius / 5, radius] (Saad, Iterative methods, 12.3.2).
  const double upper = radius_, lower = radius_ / 5.0;
  const double theta = 0.5 * (upper + lower), delta = 0.5 * (upper - lower), sigma = theta / delta;
  const double rho = 1.0 / sigma, next = 1.0 / (2.0 * sigma - rho);
  step(x, r, d, 0.0f, static_cast<float>(1.0 / theta));
  subtract_product(d.data(), r);
  step(x, r, d, static_cast<float>(next * rho), static_cast<float>(2.0 * next / delta));
  if (needs_residual) subtract_product(d.data(), r);
}

/// The hierarchy and one V-cycle on it.
class Multigrid {
 public:
  Multigrid(const LayeredLevel& finest, ThreadTeam& team) {
    for (const LayeredLevel* level = &finest;; level = coarser_.back().get()) {
      levels_.push_back(std::make_unique<Level>(level->system, team));
      BaseMatrix p = make_prolongation(*level, team);
      if (p.n_cols == 0 || 4 * p.n_cols > 3 * (p.n_rows() - n_empty(level->system))) break;
      BaseMatrix r = transposed(p);
      coarser_.push_back(std::make_unique<LayeredLevel>(make_coarser(*level, p, r, team)));
      down_.emplace_back(std::move(r));
      up_.emplace_back(std::move(p));
    }
    for (std::size_t l = 1; l < levels_.size(); ++l) {
      right_.emplace_back(levels_[l]->size());
      solution_.emplace_back(levels_[l]->size());
      direction_.emplace_back(levels_[l]->size());
    }
  }

  const Level& finest() const { return *levels_.front(); }
  int n_levels() const { return static_cast<int>(levels_.size()); }

  /// x = one V-cycle for the right-hand side b, from zero; r and d are work space.
  void cycle(const Vector& b, Vector& x, Vector& r, Vector& d, const Context& context) {
    cycle(0, b, x, r, d, context);
  }

 private:
  static int n_empty(const LayeredSystem& system) {
    int n = 0;
    for (int c = 0; c < system.n_columns(); ++c) n += system.high[c] < system.low[c];
    return n;
  }

  void cycle(int l, const Vector& b, Vector& x, Vector& r, Vector& d, const Context& context) {
    context.check("place");
    const Level& level = *levels_[l];
    std::fill(x.begin(), x.end(), 0.0f);
    r = b;
    level.smooth(x, r, d, true);
    if (l + 1 == n_levels()) {
      level.smooth(x, r, d, true);
      level.smooth(x, r, d, false);
      return;
    }
    restrict_to(l, r, right_[l]);
    Vector work(right_[l].size());
    cycle(l + 1, right_[l], solution_[l], work, direction_[l], context);
    context.check("place");
    prolong(l, solution_[l], d);
    level.for_columns([&](int c) {
      const long begin = level.system().offset[c];
      kernels::add_scaled(x.data() + begin, d.data() + begin, 1.0f, level.length(c));
      return 0.0;
    });
    level.subtract_product(d.data(), r);
    level.smooth(x, r, d, false);
  }

  /// to = P^T from, over the levels that both hulls share.
  void transfer(const Transfer& p, const Level& from_level, const Vector& from,
                const Level& to_level, Vector& to) const {
    const LayeredSystem &f = from_level.system(), &t = to_level.system();
    to_level.for_columns([&](int c) {
      std::fill(to.begin() + t.offset[c], to.begin() + t.offset[c + 1], 0.0f);
      for (int e = p.offset[c]; e < p.offset[c + 1]; ++e) {
        const int b = p.column[e];
        const int low = std::max(t.low[c], f.low[b]), high = std::min(t.high[c], f.high[b]);
        if (low <= high)
          kernels::add_scaled(t.at(to.data(), c, low), f.at(from.data(), b, low), p.weight[e],
                              3L * (high - low + 1));
      }
      return 0.0;
    });
  }
  void restrict_to(int l, const Vector& fine, Vector& coarse) const {
    transfer(down_[l], *levels_[l], fine, *levels_[l + 1], coarse);
  }
  void prolong(int l, const Vector& coarse, Vector& fine) const {
    transfer(up_[l], *levels_[l + 1], coarse, *levels_[l], fine);
    const LayeredSystem& s = levels_[l]->system();
    levels_[l]->for_columns([&](int c) {  // what is not free in a hull stays zero
      for (int t = 0; t < s.n_bands(); ++t) {
        const int low = std::max(s.low[c], s.band_begin[t]);
        const int high = std::min(s.high[c] + 1, s.band_begin[t + 1]);
        if (low < high && s.rows[t].diagonal[c] == 0.0f)
          std::fill_n(s.at(fine.data(), c, low), 3L * (high - low), 0.0f);
      }
      return 0.0;
    });
  }

  std::vector<std::unique_ptr<LayeredLevel>> coarser_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::vector<Transfer> down_, up_;  ///< between level l and l + 1
  std::vector<Vector> right_, solution_, direction_;
};

double dot(const Level& level, const Vector& a, const Vector& b) {
  return level.for_columns([&](int c) {
    const long begin = level.system().offset[c];
    return kernels::dot(a.data() + begin, b.data() + begin, level.length(c));
  });
}

}  // namespace

SolverReport solve(const LayeredLevel& finest, std::vector<float>& x, const SolverOptions& options,
                   ThreadTeam& team, const Context& context) {
  Multigrid multigrid(finest, team);
  const Level& level = multigrid.finest();
  Vector r = std::move(x), z(r.size()), p(r.size(), 0.0f), q(r.size()), d(r.size());
  x.assign(r.size(), 0.0f);
  SolverReport report = {0, multigrid.n_levels(), 1.0};
  double first = 0.0, last = 1.0;
  while (true) {
    context.check("place");
    multigrid.cycle(r, z, q, d, context);
    const double rz = dot(level, r, z);
    if (report.n_iterations == 0) first = rz;
    if (!(rz > 0.0)) break;
    report.reduction = std::sqrt(rz / first);
    if (report.reduction <= options.reduction) break;
    if (++report.n_iterations > options.max_iterations)
      throw SolverError("place", "The harmonic system did not converge in " +
                                     std::to_string(options.max_iterations) + " iterations.");
    const float beta = report.n_iterations == 1 ? 0.0f : static_cast<float>(rz / last);
    last = rz;
    level.for_columns([&](int c) {
      const long begin = level.system().offset[c];
      kernels::scale_and_add(p.data() + begin, z.data() + begin, beta, level.length(c));
      return 0.0;
    });
    const double pq = level.for_columns([&](int c) {
      const long begin = level.system().offset[c];
      level.apply(p.data(), c, q.data() + begin);
      return kernels::dot(p.data() + begin, q.data() + begin, level.length(c));
    });
    const float alpha = static_cast<float>(rz / pq);
    level.for_columns([&](int c) {
      const long begin = level.system().offset[c], n = level.length(c);
      kernels::add_scaled(x.data() + begin, p.data() + begin, alpha, n);
      kernels::add_scaled(r.data() + begin, q.data() + begin, -alpha, n);
      return 0.0;
    });
  }
  return report;
}

}  // namespace sweepmesh
