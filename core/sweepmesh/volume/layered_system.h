// The Laplacian of an extrusion, matrix-free, and its coarser images.
//
//     A = K2 x M1 + M2 x K1
//
// K2, M2: stiffness and (lumped) mass of the base mesh, M1, K1 those of the layers. Unknowns are
// the free nodes; fixed ones are left out, their couplings stay on the diagonal. Levels fall into
// *bands*: within a band the same cells exist and the same columns are free, so one matrix of the
// base says all. Layers fall into classes: 2t inside band t, 2t + 1 between band t and the next.
//
// A vector holds, column by column, three floats (x, y, z) for every level of the column's hull
// (first to last free level), so that neighbours in the base are neighbouring streams of memory.
// Single precision is enough: the unknown is a correction of a few elements at most. Nodes of the
// hull that are not free hold zero, and so do a few floats before the first column and behind the
// last, so that kernels may look beyond a column's ends.
#pragma once

#include <algorithm>
#include <vector>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_matrix.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/floats.h"

namespace sweepmesh {

/// Vertical couplings of one class of layers, a value per column: of the two nodes with each other,
/// and the parts of the diagonal of the lower and the upper one. Empty: no layer is of this class.
struct LayerClass {
  Floats across, lower, upper;
};

/// A base matrix, rows and columns of free nodes only, with the diagonal first in every row.
struct BaseRows {
  BaseMatrix matrix;
  Floats diagonal;  ///< 0: not free in this band
};

struct LayeredSystem {
  static constexpr long pad = 24;  ///< floats before the first column, and behind the last
  int k_first = 0;                 ///< level of index 0 of the arrays over levels
  std::vector<float> share;        ///< per level: entry of M1; 3 times each
  std::vector<float> spring;       ///< per layer: minus the off-diagonal entry of K1; 3 times each
  std::vector<int> band_begin;     ///< first level (from k_first) of every band, and the end
  std::vector<BaseRows> rows;      ///< per band
  std::vector<LayerClass> layers;  ///< per class
  std::vector<int> low,
      high;  ///< per column: hull of its free levels (from k_first), low > high: none
  std::vector<long> offset;  ///< per column: its first float
  std::vector<long> start;   ///< per column: where the first float of level 0 would be

  int n_columns() const { return static_cast<int>(low.size()); }
  int n_bands() const { return static_cast<int>(rows.size()); }
  bool is_empty() const { return offset.back() == pad; }
  long size() const { return offset.back() + pad; }
  float* at(float* v, int column, int k) const { return v + start[column] + 3L * k; }
  const float* at(const float* v, int column, int k) const { return v + start[column] + 3L * k; }
};

/// Undefined but for what lies before and behind the columns.
Floats make_vector(const LayeredSystem& system);

/// Calls f(rows, first, last) for the bands in which a column is free, with their levels first ..
/// last - 1.
template <class F>
void for_free_bands(const LayeredSystem& s, int column, F&& f) {
  for (int t = 0; t < s.n_bands(); ++t) {
    const int first = std::max(s.low[column], s.band_begin[t]);
    const int last = std::min(s.high[column] + 1, s.band_begin[t + 1]);
    if (first < last && s.rows[t].diagonal[column] != 0.0f) f(s.rows[t], first, last);
  }
}

/// The finest level; `cells` are those around the extrusion's columns. Linear in the base mesh
/// times the bands.
LayeredSystem make_layered_system(const Extrusion& extrusion, const CellsOfColumns& cells,
                                  const BaseMetric& metric, const std::vector<char>& fixed,
                                  ThreadTeam& team);

/// Galerkin's product with a prolongation of the base (columns x coarse columns) that is the same
/// for all levels, and its transpose; vertical couplings are lumped.
LayeredSystem make_coarser(const LayeredSystem& fine, const BaseMatrix& prolongation,
                           const BaseMatrix& restriction, ThreadTeam& team);

/// Smoothed aggregation: every aggregate is a column and its strong neighbours. The result has as
/// many columns as `fine` when nothing can be joined.
BaseMatrix make_prolongation(const LayeredSystem& fine, ThreadTeam& team);

}  // namespace sweepmesh
