#include "sweepmesh/volume/layered_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>

#include "sweepmesh/volume/layer_kernels.h"
#include "sweepmesh/volume/layered_columns.h"

namespace sweepmesh {
namespace {

/// The hierarchy and one V-cycle on it.
class Multigrid {
 public:
  Multigrid(const LayeredSystem& finest, ThreadTeam& team) : team_(team) {
    for (const LayeredSystem* level = &finest;; level = coarser_.back().get()) {
      levels_.push_back(std::make_unique<LayeredColumns>(*level, team));
      BaseMatrix p = make_prolongation(*level, team);
      if (p.n_cols == 0 || 4 * p.n_cols > 3 * (p.n_rows - n_empty(*level))) break;
      BaseMatrix r = transposed(p);
      coarser_.push_back(std::make_unique<LayeredSystem>(make_coarser(*level, p, r, team)));
      down_.emplace_back(std::move(r));
      up_.emplace_back(std::move(p));
      vectors_.emplace_back(*coarser_.back());
    }
    for (int l = 0; l + 1 < n_levels(); ++l) reach_down_.push_back(reach_down(l));
  }

  const LayeredColumns& finest() const { return *levels_.front(); }
  int n_levels() const { return static_cast<int>(levels_.size()); }

  /// b -= alpha w, then x = one V-cycle for the right-hand side b, from zero; w is work space.
  /// Returns b . x.
  double cycle(float alpha, Floats& b, Floats& x, Floats& w, const Context& context) {
    std::vector<double> dots(finest().n_chunks());
    std::vector<ChunkStage> first;
    if (alpha != 0.0f)
      first.push_back({finest().n_chunks(), nullptr, [&](int chunk) {
                         const auto [begin, n] = finest().range(chunk);
                         kernels::add_scaled(b.data() + begin, w.data() + begin, -alpha, n);
                       }});
    cycle(0, b, x, w, dots.data(), std::move(first), context);
    return std::accumulate(dots.begin(), dots.end(), 0.0);
  }

 private:
  /// Those of a coarser level.
  struct Vectors {
    Floats right, solution, work;
    explicit Vectors(const LayeredSystem& s)
        : right(make_vector(s)), solution(make_vector(s)), work(make_vector(s)) {}
  };

  static int n_empty(const LayeredSystem& system) {
    int n = 0;
    for (int c = 0; c < system.n_columns(); ++c) n += system.high[c] < system.low[c];
    return n;
  }

  /// The cycle from level `l` on; `stages` are done before, with it.
  void cycle(int l, const Floats& b, Floats& x, Floats& w, double* dots,
             std::vector<ChunkStage> stages, const Context& context) {
    context.check("place");
    const LayeredColumns& level = *levels_[l];
    if (l + 1 == n_levels()) {
      level.add_smoother_from_zero(b, x, w, stages);
      level.add_smoother(b, x, w, nullptr, stages);
      level.add_smoother(b, x, w, dots, stages);
      return run_stages(stages, team_);
    }
    Vectors& v = vectors_[l];
    level.add_smoother_from_zero(b, w, x, stages);
    level.add_residual(b, w, x, stages);
    stages.push_back({levels_[l + 1]->n_chunks(), &reach_down_[l],
                      [&, l](int chunk) { restrict_to(l, chunk, x, v.right); }});
    run_stages(stages, team_);
    cycle(l + 1, v.right, v.solution, v.work, nullptr, {}, context);
    context.check("place");
    stages.assign(
        1, {level.n_chunks(), nullptr, [&, l](int chunk) { prolong(l, chunk, v.solution, w, x); }});
    level.add_smoother(b, x, w, dots, stages);
    run_stages(stages, team_);
  }

  /// Per chunk of level l + 1: how many chunks of level l its columns are restricted from.
  std::vector<int> reach_down(int l) const {
    std::vector<int> reach;
    for (int chunk = 0; chunk < levels_[l + 1]->n_chunks(); ++chunk) {
      int end = 0;
      levels_[l + 1]->for_columns(chunk, [&](int c) {
        down_[l].for_row(c, [&](int column, float) { end = std::max(end, column + 1); });
      });
      reach.push_back(levels_[l]->chunks_before(end));
    }
    return reach;
  }

  /// coarse = P^T fine, over the levels that both hulls share.
  void restrict_to(int l, int chunk, const Floats& fine, Floats& coarse) const {
    const LayeredSystem &f = levels_[l]->system(), &s = levels_[l + 1]->system();
    levels_[l + 1]->for_columns(chunk, [&](int c) {
      set_to_entries(down_[l].row(c), f, fine, nullptr, s.low[c], s.high[c],
                     coarse.data() + s.offset[c]);
    });
  }
  /// to = from + P coarse; what is not free in a hull stays zero.
  void prolong(int l, int chunk, const Floats& coarse, const Floats& from, Floats& to) const {
    const LayeredSystem &s = levels_[l]->system(), &t = levels_[l + 1]->system();
    levels_[l]->for_columns(chunk, [&](int c) {
      if (!levels_[l]->is_whole(c))
        std::fill_n(to.data() + s.offset[c], levels_[l]->length(c), 0.0f);
      for_free_bands(s, c, [&](const BaseRows&, int first, int last) {
        set_to_entries(up_[l].row(c), t, coarse, s.at(from.data(), c, first), first, last - 1,
                       s.at(to.data(), c, first));
      });
    });
  }
  /// out = base (zero if null) + a row's entries times a vector of the system `f`, for the levels
  /// low .. high.
  static void set_to_entries(const BaseMatrix::Row& row, const LayeredSystem& f, const Floats& from,
                             const float* base, int low, int high, float* out) {
    constexpr int few = 64;
    const float* streams[few];
    const int n_entries = row.n;
    const int* columns = row.column;
    const float* weights = row.value;
    const long n = 3L * (high - low + 1);
    bool are_covered = n_entries <= few;
    for (int e = 0; e < n_entries && are_covered; ++e) {
      are_covered = f.low[columns[e]] <= low && high <= f.high[columns[e]];
      streams[e] = f.at(from.data(), columns[e], low);
    }
    if (are_covered) return kernels::sum_scaled(out, base, streams, weights, n_entries, n);
    base ? void(std::copy_n(base, n, out)) : void(std::fill_n(out, n, 0.0f));
    for (int e = 0; e < n_entries; ++e) {
      const int b = columns[e], first = std::max(low, f.low[b]), last = std::min(high, f.high[b]);
      if (first <= last)
        kernels::add_scaled(out + 3L * (first - low), f.at(from.data(), b, first), weights[e],
                            3L * (last - first + 1));
    }
  }

  ThreadTeam& team_;
  std::vector<std::unique_ptr<LayeredSystem>> coarser_;
  std::vector<std::unique_ptr<LayeredColumns>> levels_;
  std::vector<BaseMatrix> down_, up_;  ///< between level l and l + 1
  std::vector<std::vector<int>> reach_down_;
  std::vector<Vectors> vectors_;  ///< of level l + 1
};

/// Conjugate gradients for A x = r. The solution and the residual follow a step later, when p and
/// A p are read anyway.
class Steps {
 public:
  /// `r` is spoiled.
  Steps(const LayeredSystem& s, Multigrid& multigrid, Floats& r, ThreadTeam& team)
      : system_(s), multigrid_(multigrid), level_(multigrid.finest()), team_(team), r_(r) {
    for (Floats* v : {&z_, &p_, &w_}) *v = make_vector(s);
  }

  /// z = one V-cycle for the residual. Returns r . z.
  double precondition(const Context& context) {
    return multigrid_.cycle(alpha_, r_, z_, w_, context);
  }

  /// p = z + a p (z the first time), w = A p, then a step along p to where r . z was `rz`.
  void step(float a, double rz) {
    std::vector<ChunkStage> stages;
    if (n_steps_ == 0)
      std::swap(p_, z_);
    else
      stages.push_back({level_.n_chunks(), nullptr, [&](int chunk) { turn(chunk, a); }});
    if (n_steps_ == 1) x_ = make_vector(system_);
    std::vector<double> dots(level_.n_chunks());
    stages.push_back({level_.n_chunks(), &level_.reach(),
                      [&](int chunk) { dots[chunk] = level_.multiply(chunk, p_, w_); }});
    run_stages(stages, team_);
    alpha_ = static_cast<float>(rz / std::accumulate(dots.begin(), dots.end(), 0.0));
    ++n_steps_;
  }

  /// The solution with z added.
  Floats finish() {
    if (n_steps_ > 0)
      team_.for_chunks(level_.n_chunks(), 1, [&](long chunk, long, long) {
        const auto [begin, n] = level_.range(static_cast<int>(chunk));
        const float* p = p_.data() + begin;
        float* z = z_.data() + begin;
        if (n_steps_ == 1) return kernels::add_scaled(z, p, alpha_, n);
        float* x = x_.data() + begin;
        kernels::add_scaled(x, p, alpha_, n);
        kernels::add_scaled(x, z, 1.0f, n);
      });
    return std::move(n_steps_ > 1 ? x_ : z_);
  }

 private:
  /// x += alpha p for the last step (x = alpha p if it was the first), p = z + a p.
  void turn(int chunk, float a) {
    const auto [begin, n] = level_.range(chunk);
    float *x = x_.data() + begin, *p = p_.data() + begin;
    const float* along[] = {p};
    if (n_steps_ == 1)
      kernels::sum_scaled(x, nullptr, along, &alpha_, 1, n);
    else
      kernels::add_scaled(x, p, alpha_, n);
    kernels::combine(p, z_.data() + begin, a, 1.0f, n);
  }

  const LayeredSystem& system_;
  Multigrid& multigrid_;
  const LayeredColumns& level_;
  ThreadTeam& team_;
  Floats& r_;
  Floats x_, z_, p_, w_;
  float alpha_ = 0.0f;  ///< length of the last step, which x and r do not contain yet
  int n_steps_ = 0;
};

/// Bound of the factor by which one V-cycle alone reduces the error, when conjugate gradients with
/// it reduce it by `rate`: of a spectrum 1 - d .. 1 they make (1 - s) / (1 + s), s^2 = 1 - d.
double contraction(double rate) {
  const double s = std::max(0.0, 1.0 - rate) / (1.0 + rate);
  return 1.0 - s * s;
}

}  // namespace

SolverReport solve(const LayeredSystem& finest, Floats& x, const SolverOptions& options,
                   ThreadTeam& team, const Context& context) {
  Multigrid multigrid(finest, team);
  Steps steps(finest, multigrid, x, team);
  SolverReport report = {0, multigrid.n_levels(), 1.0};
  double first = 0.0, last = 0.0;
  while (true) {
    context.check("place");
    const double rz = steps.precondition(context);
    const bool is_first = report.n_iterations == 0;
    if (is_first) first = last = rz;
    if (rz > 0.0) report.reduction = std::sqrt(rz / first) * contraction(std::sqrt(rz / last));
    if (!(rz > 0.0) || report.reduction <= options.reduction) break;  // this cycle counts too
    if (++report.n_iterations > options.max_iterations)
      throw SolverError("place", "The harmonic system did not converge in " +
                                     std::to_string(options.max_iterations) + " iterations.");
    steps.step(is_first ? 0.0f : static_cast<float>(rz / last), rz);
    last = rz;
  }
  x = steps.finish();
  return report;
}

}  // namespace sweepmesh
