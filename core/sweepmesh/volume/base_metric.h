// The intrinsic idealised model of an extrusion: a metric on its base mesh and a height for every
// layer.
//
// Harmonic coordinates of the thesis (4.2.3) live on an idealised prism. Their sum, weighted with
// the cage, is the harmonic extension of the cage's positions, and the Laplacian of the prism needs
// no embedding: only lengths in the base mesh, here those of the run's two ends (the matrices of
// both are averaged), and heights of layers. So the idealised model of every set of runs is two
// small matrices.
#pragma once

#include <algorithm>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/floats.h"

namespace sweepmesh {

struct BaseMetric {
  /// Per cell, and one more: where its pairs of corners start. A cell with n corners has n (n - 1)
  /// / 2 pairs in the order (0,1) (0,2) ... (1,2) ...
  std::vector<long> pair_offset = {0};
  /// Weight of every pair, >= 0: minus the entry of the cell's stiffness matrix.
  Floats pair_weight;
  /// Per corner, parallel to Extrusion::cell_columns: the part of the cell's area that is its
  /// share.
  Floats corner_mass;
  /// Level of the lowest node of all; height[k - k_first] > 0 is that of the layer k .. k + 1.
  int k_first = 0;
  std::vector<double> height;

  double height_of(int k) const { return height[k - k_first]; }
};

/// Calls f(other column, weight) for the pairs of a cell with its corner `i`.
template <class F>
void for_pairs(const Extrusion& x, const BaseMetric& metric, int cell, int i, F&& f) {
  const int* columns = x.cell_columns.data() + x.cell_offset[cell];
  const float* weight = metric.pair_weight.data() + metric.pair_offset[cell];
  const int n = x.cell_size(cell);
  if (n == 4) {
    constexpr int pair[4][3] = {{0, 1, 2}, {3, 4, 0}, {5, 1, 3}, {2, 4, 5}};
    for (int j = 0; j < 3; ++j) f(columns[(i + 1 + j) & 3], weight[pair[i][j]]);
    return;
  }
  for (int j = 0; j < n; ++j) {
    if (j == i) continue;
    const int a = std::min(i, j), b = std::max(i, j);
    f(columns[j], weight[a * n - a * (a + 1) / 2 + b - a - 1]);
  }
}

/// Stiffness is that of linear triangles (cotangents), a quad divided by its Delaunay diagonal, a
/// larger polygon by the mean of its fans; negative weights are left out, so that every harmonic
/// value is a convex combination of its neighbours. Heights are the mean distances between fixed
/// nodes one above the other, or, for a layer that has none, those of the ends of the runs, divided
/// by their layers.
///
/// `points` needs the ends of the runs and the nodes that are `fixed`. Linear in their number.
BaseMetric make_base_metric(const Extrusion& extrusion, const std::vector<char>& fixed,
                            const Points& points, ThreadTeam& team);

/// The heights alone: all that layers which move affinely need.
BaseMetric make_layer_heights(const Extrusion& extrusion, const std::vector<char>& fixed,
                              const Points& points, ThreadTeam& team);

/// Adds the matrices of the cells, unless they are there already.
void complete_metric(const Extrusion& extrusion, const Points& points, BaseMetric& metric,
                     ThreadTeam& team);
}  // namespace sweepmesh
