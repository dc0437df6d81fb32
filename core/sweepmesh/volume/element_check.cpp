#include "sweepmesh/volume/element_check.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "sweepmesh/base/element_quality.h"

namespace sweepmesh {
namespace {

constexpr long cells_per_chunk = 64;

}  // namespace

double scaled_jacobian_of(const Extrusion& extrusion, const Points& points, SweptElement element) {
  constexpr int few = 8;
  const int n = extrusion.cell_size(element.cell);
  const int* columns = extrusion.cell_columns.data() + extrusion.cell_offset[element.cell];
  std::array<Point3, 2 * few> small;
  small.fill(Point3::Zero());
  std::vector<Point3> large(n > few ? 2 * n : 0);
  Point3* low = n > few ? large.data() : small.data();
  for (int i = 0; i < n; ++i) {
    const long node = extrusion.node(columns[i], element.k);
    low[i] = points.row(node);
    low[n + i] = points.row(node + 1);
  }
  return scaled_jacobian(low, low + n, n);
}

ElementCheck check_elements(const Extrusion& extrusion, const Points& points, double threshold,
                            ThreadTeam& team) {
  const Extrusion& x = extrusion;
  std::vector<long> first(x.n_cells() + 1, 0);
  for (int c = 0; c < x.n_cells(); ++c)
    first[c + 1] = first[c] + x.cell_k_high[c] - x.cell_k_low[c];
  std::vector<ElementCheck> parts(ThreadTeam::n_chunks(x.n_cells(), cells_per_chunk));
  std::vector<double> sums(parts.size(), 0.0);
  team.for_chunks(x.n_cells(), cells_per_chunk, [&](long begin, long end, long chunk) {
    ElementCheck part;
    double sum = 0.0;
    std::vector<Point3> low, high;
    for (int c = static_cast<int>(begin); c < end; ++c) {
      const int n = x.cell_size(c);
      const int* columns = x.cell_columns.data() + x.cell_offset[c];
      low.resize(n);
      high.resize(n);
      for (int i = 0; i < n; ++i) high[i] = points.row(x.node(columns[i], x.cell_k_low[c]));
      for (int k = x.cell_k_low[c]; k < x.cell_k_high[c]; ++k) {
        std::swap(low, high);
        for (int i = 0; i < n; ++i) high[i] = points.row(x.node(columns[i], k + 1));
        const double value = scaled_jacobian(low.data(), high.data(), n);
        sum += value;
        part.min_scaled_jacobian = std::min(part.min_scaled_jacobian, value);
        if (!(value > threshold)) part.bad.push_back(first[c] + k - x.cell_k_low[c]);
      }
    }
    parts[chunk] = std::move(part);
    sums[chunk] = sum;
  });
  ElementCheck all;
  for (const ElementCheck& part : parts) {
    all.min_scaled_jacobian = std::min(all.min_scaled_jacobian, part.min_scaled_jacobian);
    all.bad.insert(all.bad.end(), part.bad.begin(), part.bad.end());
  }
  if (first.back() > 0)
    all.mean_scaled_jacobian =
        std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(first.back());
  return all;
}

}  // namespace sweepmesh
