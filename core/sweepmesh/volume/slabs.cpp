#include "sweepmesh/volume/slabs.h"

#include <algorithm>

namespace sweepmesh {
namespace {

std::vector<int> levels_of(const Extrusion& x) {
  std::vector<int> levels = x.cell_k_low;
  levels.insert(levels.end(), x.cell_k_high.begin(), x.cell_k_high.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

int find_parts(const Extrusion& x, Slab& slab) {
  DisjointSets sets(x.n_columns());
  std::vector<char> is_active(x.n_columns(), 0);
  for (int c = 0; c < x.n_cells(); ++c) {
    if (!slab.holds(x, c)) continue;
    for (int i = x.cell_offset[c]; i < x.cell_offset[c + 1]; ++i) {
      is_active[x.cell_columns[i]] = 1;
      sets.join(x.cell_columns[i], x.cell_columns[x.cell_offset[c]]);
    }
  }
  int n_parts = 0;
  slab.part.assign(x.n_columns(), -1);
  for (int c = 0; c < x.n_columns(); ++c) {
    if (!is_active[c]) continue;
    const int root = sets.root(c);
    slab.part[c] = root == c ? n_parts++ : slab.part[root];
  }
  return n_parts;
}

bool is_fixed_between(const Extrusion& x, const std::vector<char>& fixed, int column, int low,
                      int high) {
  const auto first = fixed.begin() + x.node(column, low);
  return std::all_of(first, first + (high - low + 1), [](char f) { return f != 0; });
}

}  // namespace

std::vector<Slab> find_slabs(const Extrusion& extrusion, const std::vector<char>& fixed) {
  std::vector<Slab> slabs;
  const std::vector<int> levels = levels_of(extrusion);
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    Slab& slab = slabs.emplace_back(Slab{levels[l], levels[l + 1], {}, {}});
    slab.loops.resize(find_parts(extrusion, slab));
    for (int c = 0; c < extrusion.n_columns(); ++c)
      if (slab.part[c] >= 0 && is_fixed_between(extrusion, fixed, c, slab.k_low, slab.k_high))
        slab.loops[slab.part[c]].push_back(c);
  }
  return slabs;
}

}  // namespace sweepmesh
