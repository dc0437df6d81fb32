// The columns of a layered system, factored, and the sweeps over them that a V-cycle consists of.
//
// With D the couplings within columns and O those between them, A = D + O, a step of the smoother
// is
//     z = D^-1 (b - O y),   result = alpha y + beta z + gamma x,
// so it never forms D y: D^-1 (b - A y) = z - y. Every sweep reads each vector once.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/chunk_stages.h"
#include "sweepmesh/volume/floats.h"
#include "sweepmesh/volume/layer_kernels.h"
#include "sweepmesh/volume/layered_system.h"

namespace sweepmesh {

/// Results do not depend on the number of threads. Vectors have the system's layout and are zero
/// where a hull's nodes are not free. No two arguments of a call are the same vector.
class LayeredColumns {
 public:
  LayeredColumns(const LayeredSystem& system, ThreadTeam& team);

  long size() const { return s_.size(); }
  const LayeredSystem& system() const { return s_; }
  long length(int column) const { return s_.offset[column + 1] - s_.offset[column]; }
  /// Whether a column's hull is one band.
  bool is_whole(int column) const { return whole_band_[column] >= 0; }

  int n_chunks() const { return static_cast<int>(chunk_.size()) - 1; }
  /// Per chunk: how many chunks, from the first on, hold its columns and their neighbours.
  const std::vector<int>& reach() const { return reach_; }
  /// How many chunks hold the columns before `column`.
  int chunks_before(int column) const;

  /// The floats of a chunk: the first, and how many. They are those of its columns and no others.
  std::pair<long, long> range(int chunk) const {
    const long begin = s_.offset[chunk_[chunk]];
    return {begin, s_.offset[chunk_[chunk + 1]] - begin};
  }

  /// Calls f(column) for the columns of a chunk that hold something.
  template <class F>
  void for_columns(int chunk, F&& f) const {
    for (int c = chunk_[chunk]; c < chunk_[chunk + 1]; ++c)
      if (s_.high[c] >= s_.low[c]) f(c);
  }
  template <class F>
  void for_columns(F&& f) const {
    team_.for_chunks(n_chunks(), 1,
                     [&](long chunk, long, long) { for_columns(static_cast<int>(chunk), f); });
  }

  /// y = A x at the columns of a chunk; returns their x . y.
  double multiply(int chunk, const Floats& x, Floats& y) const;

  // The following append stages (chunk_stages.h) over all chunks. The first of each needs at most
  // the chunks' own columns of what a stage before it wrote.

  /// r = b - A x.
  void add_residual(const Floats& b, const Floats& x, Floats& r,
                    std::vector<ChunkStage>& stages) const;
  /// x = p(D^-1 A) D^-1 b for Chebyshev's polynomial p of degree one; `work` is spoiled.
  void add_smoother_from_zero(const Floats& b, Floats& x, Floats& work,
                              std::vector<ChunkStage>& stages) const;
  /// x += p(D^-1 A) D^-1 (b - A x); a chunk's b . x of the new x goes to `dots` unless that is
  /// null.
  void add_smoother(const Floats& b, Floats& x, Floats& work, double* dots,
                    std::vector<ChunkStage>& stages) const;

 private:
  struct Scratch;
  struct Mix {
    float alpha, beta, gamma;
  };
  /// Correction 1 is first D^-1 r, correction 2 is again (correction 1) + second D^-1 r.
  struct Chebyshev {
    float first, again, second;
  };
  Chebyshev polynomial() const;

  void add_stage(std::function<void(int)> work, std::vector<ChunkStage>& stages) const;
  void make_chunks();
  void set_springs();
  void find_reach();
  void find_whole();
  void find_runs();
  void find_steps();
  void factor();
  void find_radius();
  /// One step of the smoother; `y` null stands for zero.
  void step(int chunk, const Floats& b, const Floats* y, const Mix& mix, Floats& result) const;
  /// The same for columns first .. first + n - 1, which are one or all alike.
  void step_columns(const Floats& b, const Floats* y, const Mix& mix, int first, int n,
                    Scratch& scratch, Floats& result) const;
  /// Rows of `n` columns from `first` on, of one run.
  kernels::ColumnRows rows(int first, int n) const {
    return {n, length(first), row_begin_.data() + first, step_.data(), weight_.data()};
  }
  /// out = b - O y for one column.
  void right_of(const float* b, const float* y, int column, Scratch& scratch, float* out) const;
  /// x . y over the columns of a chunk.
  double dot(int chunk, const Floats& x, const Floats& y) const;
  /// y = A x, or b - A x if there is a b, for the columns of a chunk.
  void multiply(int chunk, const float* b, const float* x, float* y) const;
  /// The same for columns first .. end - 1, of one run.
  void multiply_run(int first, int end, const float* b, const float* x, float* y) const;
  void multiply_any(const float* x, int column, Scratch& scratch, float* y) const;
  /// Couplings of the layers inside a column's hull.
  void couplings_of(int column, float* out) const;
  /// Whether columns first .. first + n - 1 have the same hull.
  bool are_alike(int first, int n) const;

  const LayeredSystem& s_;
  ThreadTeam& team_;
  std::vector<int> chunk_;  ///< first column of every chunk, and the end
  std::vector<int> reach_;
  std::vector<int> whole_band_;  ///< per column: the band that is its hull, or -1
  /// Per column: where the run of columns ends that are whole in the same band, within its chunk.
  std::vector<int> run_end_;
  /// Rows of the columns that are whole in that band, the diagonal first: steps in nodes.
  std::vector<int> row_begin_;
  Ints step_;
  Floats weight_;
  Floats spring_;  ///< per layer, once
  /// Per level, three times: the springs of a column that is whole (kernels::ColumnProduct).
  Floats up_, down_, up_beyond_, down_beyond_;
  Floats pivot_;         ///< inverse pivots of the columns, one a node
  double radius_ = 2.0;  ///< bound of the spectrum of D^-1 A
};

}  // namespace sweepmesh
