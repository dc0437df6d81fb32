#include "sweepmesh/volume/layered_system.h"

#include <algorithm>
#include <atomic>

namespace sweepmesh {
namespace {

/// Calls f(column) for all columns, on all threads.
template <class F>
void for_columns(std::size_t n_columns, ThreadTeam& team, F&& f) {
  constexpr long least = 1L << 7, most = 1L << 12;
  const long n = static_cast<long>(n_columns);
  team.for_chunks(n, ThreadTeam::grain_of(n, least, most), [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c) f(c);
  });
}

/// Per level, whether a run begins or ends there.
std::vector<char> ends_of_runs(const Extrusion& x, int first, int last) {
  std::vector<char> is_end(last - first + 1, 0);
  for (int c = 0; c < x.n_cells(); ++c)
    is_end[x.cell_k_low[c] - first] = is_end[x.cell_k_high[c] - first] = 1;
  return is_end;
}

/// Levels at which a column begins, ends, or turns from free to fixed or back, and where a run
/// begins or ends (its last level has half of the matrix, so it is a band of its own).
std::vector<int> find_bands(const Extrusion& x, const std::vector<char>& fixed, int first, int last,
                            ThreadTeam& team) {
  std::vector<std::atomic<char>> begins(last - first + 2);
  const auto mark = [&](int k) {
    std::atomic<char>& b = begins[k - first];
    if (!b.load(std::memory_order_relaxed)) b.store(1, std::memory_order_relaxed);
  };
  mark(first);
  mark(last + 1);
  for_columns(x.k_low.size(), team, [&](int c) {
    mark(x.k_low[c]);
    mark(x.k_high[c] + 1);
    for (int k = x.k_low[c] + 1; k <= x.k_high[c]; ++k)
      if ((fixed[x.node(c, k)] != 0) != (fixed[x.node(c, k - 1)] != 0)) mark(k);
  });
  for_columns(x.cell_k_low.size(), team, [&](int c) {
    for (const int k : {x.cell_k_low[c], x.cell_k_high[c]}) {
      mark(k);
      mark(k + 1);
    }
  });
  std::vector<int> bands;
  for (std::size_t k = 0; k < begins.size(); ++k)
    if (begins[k]) bands.push_back(static_cast<int>(k));
  return bands;
}

BaseRows rows_of(BaseMatrix matrix, ThreadTeam& team) {
  BaseRows rows = {std::move(matrix), {}};
  rows.diagonal.resize(rows.matrix.n_rows);
  for_columns(rows.diagonal.size(), team, [&](int c) {
    const BaseMatrix::Row row = rows.matrix.row(c);
    rows.diagonal[c] = row.n > 0 ? row.value[0] : 0.0f;
  });
  return rows;
}

BaseRows band_rows(const Extrusion& x, const CellsOfColumns& cells, const BaseMetric& metric,
                   const std::vector<char>& is_free, int k, ThreadTeam& team) {
  if (std::find(is_free.begin(), is_free.end(), 1) == is_free.end())
    return rows_of(zero_matrix(x.n_columns(), x.n_columns()), team);
  const auto add_row = [&](int c, RowSum& sum) {
    if (!is_free[c]) return;
    double diagonal = 0.0;
    sum.add(c, 0.0);
    for (int i = cells.offset[c]; i < cells.offset[c + 1]; ++i) {
      const int cell = cells.cell[i], low = x.cell_k_low[cell], high = x.cell_k_high[cell];
      if (k < low || k > high) continue;
      const double part = k == low || k == high ? 0.5 : 1.0;
      for_pairs(x, metric, cell, cells.corner[i], [&](int other, double w) {
        diagonal += part * w;
        if (is_free[other]) sum.add(other, -part * w);
      });
    }
    sum.add(c, diagonal);
  };
  return rows_of(build_rows(x.n_columns(), x.n_columns(), team, add_row), team);
}

/// Mass of every column in the layer above level k.
Floats masses(const Extrusion& x, const CellsOfColumns& cells, const BaseMetric& metric, int k,
              ThreadTeam& team) {
  Floats out(x.n_columns());
  for_columns(out.size(), team, [&](int c) {
    double mass = 0.0;
    for (int i = cells.offset[c]; i < cells.offset[c + 1]; ++i) {
      const int cell = cells.cell[i];
      if (x.cell_k_low[cell] <= k && k < x.cell_k_high[cell])
        mass += metric.corner_mass[x.cell_offset[cell] + cells.corner[i]];
    }
    out[c] = static_cast<float>(mass);
  });
  return out;
}

/// The class of a layer whose ends are free as said.
LayerClass layer_class(const Floats& mass, const std::vector<char>& is_free,
                       const std::vector<char>& is_free_above, ThreadTeam& team) {
  const std::size_t n = mass.size();
  LayerClass layer = {Floats(n), Floats(n), Floats(n)};
  for_columns(n, team, [&](int c) {
    layer.lower[c] = is_free[c] ? mass[c] : 0.0f;
    layer.upper[c] = is_free_above[c] ? mass[c] : 0.0f;
    layer.across[c] = is_free[c] && is_free_above[c] ? mass[c] : 0.0f;
  });
  return layer;
}

/// Sets the hulls of the columns from the bands in which they have a diagonal.
void set_hulls(LayeredSystem& s, ThreadTeam& team) {
  const int n = static_cast<int>(s.rows.front().diagonal.size());
  s.low.assign(n, 0);
  s.high.assign(n, -1);
  s.offset.assign(n + 1, LayeredSystem::pad);
  s.start.resize(n);
  for_columns(n, team, [&](int c) {
    for (int t = 0; t < s.n_bands(); ++t) {
      if (s.rows[t].diagonal[c] == 0.0f) continue;
      if (s.high[c] < 0) s.low[c] = s.band_begin[t];
      s.high[c] = s.band_begin[t + 1] - 1;
    }
  });
  for (int c = 0; c < n; ++c) {
    s.start[c] = s.offset[c] - 3L * s.low[c];
    s.offset[c + 1] = s.offset[c] + 3L * (s.high[c] - s.low[c] + 1);
  }
}

void set_layers(const BaseMetric& metric, LayeredSystem& s) {
  const int n = static_cast<int>(metric.height.size());
  double mean = 0.0;
  for (const double h : metric.height) mean += h / n;
  const auto half = [&](int k) { return k >= 0 && k < n ? 0.5 * metric.height[k] / mean : 0.0; };
  for (int k = 0; k <= n; ++k)
    s.share.insert(s.share.end(), 3, static_cast<float>(half(k - 1) + half(k)));
  for (int k = 0; k < n; ++k)
    s.spring.insert(s.spring.end(), 3, static_cast<float>(1.0 / (metric.height[k] * mean)));
}

std::vector<char> free_columns(const Extrusion& x, const std::vector<char>& fixed, int k,
                               ThreadTeam& team) {
  std::vector<char> is_free(x.n_columns());
  for_columns(is_free.size(), team, [&](int c) {
    is_free[c] = x.k_low[c] <= k && k <= x.k_high[c] && !fixed[x.node(c, k)];
  });
  return is_free;
}

/// Off-diagonal entries count as strong from this part of the geometric mean of the diagonals on.
constexpr double strong_coupling = 0.08;

/// The base matrix that stands for all levels: the sum over bands, each times its levels.
BaseMatrix sum_over_levels(const LayeredSystem& s, ThreadTeam& team) {
  return build_rows(s.n_columns(), s.n_columns(), team, [&](int c, RowSum& sum) {
    sum.add(c, 0.0);
    for (int t = 0; t < s.n_bands(); ++t) {
      const int n_levels = s.band_begin[t + 1] - s.band_begin[t];
      s.rows[t].matrix.for_row(c, [&](int b, double value) { sum.add(b, n_levels * value); });
    }
  });
}

/// Which entries of a matrix, the diagonal first in every row, are strong.
class Couplings {
 public:
  explicit Couplings(const BaseRows& rows) : rows_(rows) {}

  int n_columns() const { return rows_.matrix.n_rows; }
  bool is_free(int c) const { return rows_.diagonal[c] > 0.0f; }
  /// Calls f(column, size) for the strong couplings of a row until it returns false.
  template <class F>
  void for_strong(int c, F&& f) const {
    for_others(c, [&](int b, float v, bool is_strong) { return !is_strong || f(b, -v); });
  }
  /// The diagonal with the weak couplings added.
  double lumped(int c) const {
    double sum = rows_.diagonal[c];
    for_others(c, [&](int, float v, bool is_strong) {
      if (!is_strong) sum += v;
      return true;
    });
    return std::max(sum, strong_coupling * rows_.diagonal[c]);
  }

 private:
  template <class F>
  void for_others(int c, F&& f) const {
    const float limit = static_cast<float>(strong_coupling * strong_coupling) * rows_.diagonal[c];
    const BaseMatrix::Row row = rows_.matrix.row(c);
    for (int e = 1; e < row.n; ++e) {
      const float v = row.value[e];
      if (!f(row.column[e], v, v < 0.0f && v * v > limit * rows_.diagonal[row.column[e]])) return;
    }
  }

  const BaseRows& rows_;
};

/// Aggregates (Vanek, Mandel, Brezina 1996, algorithm 5.1); -1 for columns that are nowhere free.
std::vector<int> make_aggregates(const Couplings& couplings, int& n_aggregates) {
  constexpr int none = -1;
  std::vector<int> aggregate(couplings.n_columns(), none), late;
  n_aggregates = 0;
  for (int c = 0; c < couplings.n_columns(); ++c) {
    if (aggregate[c] != none || !couplings.is_free(c)) continue;
    bool is_seed = true;
    couplings.for_strong(c, [&](int b, float) { return is_seed = aggregate[b] == none; });
    if (!is_seed) {
      late.push_back(c);
      continue;
    }
    aggregate[c] = n_aggregates;
    couplings.for_strong(c, [&](int b, float) {
      aggregate[b] = n_aggregates;
      return true;
    });
    ++n_aggregates;
  }
  // What is left joins the aggregate of its strongest neighbour that had one so far.
  std::vector<std::pair<int, int>> joins;
  for (const int c : late) {
    if (aggregate[c] != none) continue;
    float strongest = 0.0f;
    int joined = none;
    couplings.for_strong(c, [&](int b, float w) {
      if (aggregate[b] == none || w <= strongest) return true;
      strongest = w;
      joined = aggregate[b];
      return true;
    });
    joins.emplace_back(c, joined == none ? n_aggregates++ : joined);
  }
  for (const auto& [c, a] : joins) aggregate[c] = a;
  return aggregate;
}

/// R diag(mass) P 1 for the restriction R and the row sums of the prolongation P.
Floats restricted(const BaseMatrix& restriction, const std::vector<double>& row_sum,
                  const Floats& mass, ThreadTeam& team) {
  if (mass.empty()) return {};
  Floats out(restriction.n_rows);
  for_columns(out.size(), team, [&](int c) {
    double sum = 0.0;
    restriction.for_row(c, [&](int b, double v) { sum += v * mass[b] * row_sum[b]; });
    out[c] = static_cast<float>(sum);
  });
  return out;
}

}  // namespace

Floats make_vector(const LayeredSystem& system) {
  Floats v(system.size());
  std::fill_n(v.begin(), LayeredSystem::pad, 0.0f);
  std::fill_n(v.end() - LayeredSystem::pad, LayeredSystem::pad, 0.0f);
  return v;
}

LayeredSystem make_layered_system(const Extrusion& extrusion, const CellsOfColumns& cells,
                                  const BaseMetric& metric, const std::vector<char>& fixed,
                                  ThreadTeam& team) {
  LayeredSystem s;
  s.k_first = metric.k_first;
  const int last = s.k_first + static_cast<int>(metric.height.size());
  s.band_begin = find_bands(extrusion, fixed, s.k_first, last, team);
  set_layers(metric, s);
  const std::vector<char> is_end = ends_of_runs(extrusion, s.k_first, last);
  Floats mass = masses(extrusion, cells, metric, s.k_first, team);
  int mass_level = s.k_first;
  const auto layers_above = [&](int k, const auto& is_free, const auto& is_free_above) {
    const auto first = is_end.begin() - s.k_first;
    if (std::any_of(first + mass_level + 1, first + k + 1, [](char is) { return is != 0; }))
      mass = masses(extrusion, cells, metric, k, team);
    mass_level = k;
    s.layers.push_back(layer_class(mass, is_free, is_free_above, team));
  };
  std::vector<char> is_free = free_columns(extrusion, fixed, s.k_first, team);
  for (std::size_t t = 0; t + 1 < s.band_begin.size(); ++t) {
    const int k = s.k_first + s.band_begin[t], above = s.k_first + s.band_begin[t + 1];
    s.rows.push_back(band_rows(extrusion, cells, metric, is_free, k, team));
    above > k + 1 ? layers_above(k, is_free, is_free) : void(s.layers.emplace_back());
    if (above > last) {
      s.layers.emplace_back();
      break;
    }
    std::vector<char> is_free_above = free_columns(extrusion, fixed, above, team);
    layers_above(above - 1, is_free, is_free_above);
    is_free = std::move(is_free_above);
  }
  set_hulls(s, team);
  return s;
}

BaseMatrix make_prolongation(const LayeredSystem& fine, ThreadTeam& team) {
  const auto is_used = [](const BaseRows& rows) { return !rows.matrix.is_zero(); };
  const auto used = std::find_if(fine.rows.begin(), fine.rows.end(), is_used);
  const bool is_only = std::count_if(fine.rows.begin(), fine.rows.end(), is_used) == 1;
  const BaseRows sum = is_only ? BaseRows() : rows_of(sum_over_levels(fine, team), team);
  const Couplings couplings(is_only ? *used : sum);
  int n_aggregates = 0;
  const std::vector<int> aggregate = make_aggregates(couplings, n_aggregates);
  // One damped Jacobi step on the aggregates, with the weak couplings lumped to the diagonal.
  return build_rows(couplings.n_columns(), n_aggregates, team, [&](int c, RowSum& row) {
    if (aggregate[c] < 0) return;
    row.add(aggregate[c], 1.0 / 3.0);
    const double factor = 2.0 / 3.0 / couplings.lumped(c);
    couplings.for_strong(c, [&](int b, float w) {
      if (aggregate[b] >= 0) row.add(aggregate[b], factor * w);
      return true;
    });
  });
}

LayeredSystem make_coarser(const LayeredSystem& fine, const BaseMatrix& prolongation,
                           const BaseMatrix& restriction, ThreadTeam& team) {
  LayeredSystem s;
  s.k_first = fine.k_first;
  s.share = fine.share;
  s.spring = fine.spring;
  s.band_begin = fine.band_begin;
  std::vector<double> row_sum(prolongation.n_rows, 0.0);
  for_columns(row_sum.size(), team,
              [&](int c) { prolongation.for_row(c, [&](int, double v) { row_sum[c] += v; }); });
  for (const BaseRows& rows : fine.rows)
    // Rows of the prolongation that are not free in this band drop out, since their matrix rows are
    // empty.
    s.rows.push_back(
        rows_of(square_product(restriction, product(rows.matrix, prolongation, team), team), team));
  const auto restrict_mass = [&](const Floats& mass) {
    return restricted(restriction, row_sum, mass, team);
  };
  for (const LayerClass& layer : fine.layers)
    s.layers.push_back(
        {restrict_mass(layer.across), restrict_mass(layer.lower), restrict_mass(layer.upper)});
  set_hulls(s, team);
  return s;
}

}  // namespace sweepmesh
