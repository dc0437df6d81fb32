#include "sweepmesh/volume/slabs.h"

#include <algorithm>
#include <map>

#include "sweepmesh/base/disjoint_sets.h"

namespace sweepmesh {
namespace {

/// Columns that a thread takes at a time.
long grain_of(long n_columns) {
  return ThreadTeam::grain_of(n_columns, 1L << 7, 1L << 10);
}

void join_cells(const Extrusion& x, RunBlocks& blocks) {
  // Cells are joined through the first cell that a column saw with the same ends.
  DisjointSets sets(x.n_cells());
  using Ends = std::pair<int, int>;
  std::map<Ends, std::vector<int>> seen;
  auto last = seen.end();
  for (int c = 0; c < x.n_cells(); ++c) {
    const Ends ends = {x.cell_k_low[c], x.cell_k_high[c]};
    if (last == seen.end() || last->first != ends) last = seen.try_emplace(ends).first;
    std::vector<int>& first = last->second;
    if (first.empty()) first.assign(x.n_columns(), -1);
    int root = c;
    for (int i = x.cell_offset[c]; i < x.cell_offset[c + 1]; ++i) {
      int& f = first[x.cell_columns[i]];
      if (f < 0) {
        f = root;
      } else if (const int other = sets.root(f); other != root) {
        sets.join(other, root);
        root = std::min(other, root);
      }
    }
  }
  blocks.of_cell.resize(x.n_cells());
  for (int c = 0; c < x.n_cells(); ++c) {
    const int root = sets.root(c);
    if (root == c) {
      blocks.of_cell[c] = static_cast<int>(blocks.ends.size());
      blocks.ends.emplace_back(x.cell_k_low[c], x.cell_k_high[c]);
    } else {
      blocks.of_cell[c] = blocks.of_cell[root];
    }
  }
}

/// Most columns have one block; pairs of the others are sorted.
void list_blocks_of_columns(const Extrusion& x, RunBlocks& blocks) {
  std::vector<int> first(x.n_columns(), -1);  // block
  std::vector<std::pair<int, int>> more;      // column, block
  for (int c = 0; c < x.n_cells(); ++c)
    for (int i = x.cell_offset[c]; i < x.cell_offset[c + 1]; ++i) {
      int& own = first[x.cell_columns[i]];
      if (own < 0) own = blocks.of_cell[c];
      if (own != blocks.of_cell[c]) more.emplace_back(x.cell_columns[i], blocks.of_cell[c]);
    }
  for (std::size_t i = 0, n = more.size(); i < n; ++i)
    more.emplace_back(more[i].first, first[more[i].first]);
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  blocks.column_offset.assign(1, 0);
  blocks.column_offset.reserve(x.n_columns() + 1);
  blocks.column_blocks.reserve(x.n_columns());
  auto next = more.begin();
  for (int column = 0; column < x.n_columns(); ++column) {
    if (next == more.end() || next->first != column) {
      if (first[column] >= 0) blocks.column_blocks.push_back(first[column]);
    } else {
      for (; next != more.end() && next->first == column; ++next)
        blocks.column_blocks.push_back(next->second);
    }
    blocks.column_offset.push_back(static_cast<int>(blocks.column_blocks.size()));
  }
}

std::vector<int> levels_of(const RunBlocks& blocks) {
  std::vector<int> levels;
  for (const auto& [low, high] : blocks.ends) levels.insert(levels.end(), {low, high});
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

/// Blocks that share a column are one part. Parts are numbered by their lowest columns.
int find_parts(const RunBlocks& blocks, Slab& slab, ThreadTeam& team) {
  const int n_blocks = static_cast<int>(blocks.ends.size());
  const int n_columns = static_cast<int>(blocks.column_offset.size()) - 1;
  std::vector<char> holds(n_blocks);
  for (int b = 0; b < n_blocks; ++b)
    holds[b] = blocks.ends[b].first <= slab.k_low && slab.k_high <= blocks.ends[b].second;
  /// The first block of a column from `begin` on that holds the slab, or -1.
  const auto next_of = [&](int c, int begin) {
    for (int i = begin; i < blocks.column_offset[c + 1]; ++i)
      if (holds[blocks.column_blocks[i]]) return i;
    return -1;
  };
  DisjointSets sets(n_blocks);
  for (int c = 0; c < n_columns; ++c) {
    if (blocks.column_offset[c + 1] - blocks.column_offset[c] < 2) continue;
    const int first = next_of(c, blocks.column_offset[c]);
    for (int i = first; i >= 0; i = next_of(c, i + 1))
      sets.join(blocks.column_blocks[first], blocks.column_blocks[i]);
  }
  int n_parts = 0;
  std::vector<int> part_of(n_blocks, -1);
  long n_left = std::count(holds.begin(), holds.end(), 1);
  for (int c = 0; c < n_columns && n_left > 0; ++c)
    for (int i = next_of(c, blocks.column_offset[c]); i >= 0; i = next_of(c, i + 1)) {
      const int b = blocks.column_blocks[i];
      if (part_of[b] >= 0) continue;
      int& part = part_of[sets.root(b)];
      if (part < 0) {
        part = n_parts++;
        n_left -= sets.root(b) != b;
      }
      part_of[b] = part;
      --n_left;
    }
  slab.part.resize(n_columns);
  team.for_chunks(n_columns, grain_of(n_columns), [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c) {
      const int i = next_of(c, blocks.column_offset[c]);
      slab.part[c] = i < 0 ? -1 : part_of[blocks.column_blocks[i]];
    }
  });
  return n_parts;
}

bool is_fixed_between(const Extrusion& x, const std::vector<char>& fixed, int column, int low,
                      int high) {
  const auto first = fixed.begin() + x.node(column, low);
  return std::all_of(first, first + (high - low + 1), [](char f) { return f != 0; });
}

}  // namespace

RunBlocks find_blocks(const Extrusion& extrusion) {
  RunBlocks blocks;
  join_cells(extrusion, blocks);
  list_blocks_of_columns(extrusion, blocks);
  return blocks;
}

std::vector<Slab> find_slabs(const Extrusion& extrusion, const std::vector<char>& fixed,
                             const RunBlocks& blocks, ThreadTeam& team) {
  std::vector<Slab> slabs;
  const std::vector<int> levels = levels_of(blocks);
  const long grain = grain_of(extrusion.n_columns());
  std::vector<char> is_bound(extrusion.n_columns());
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    Slab& slab = slabs.emplace_back(Slab{levels[l], levels[l + 1], {}, {}});
    slab.loops.resize(find_parts(blocks, slab, team));
    team.for_chunks(extrusion.n_columns(), grain, [&](long begin, long end, long) {
      for (int c = static_cast<int>(begin); c < end; ++c)
        is_bound[c] =
            slab.part[c] >= 0 && is_fixed_between(extrusion, fixed, c, slab.k_low, slab.k_high);
    });
    for (int c = 0; c < extrusion.n_columns(); ++c)
      if (is_bound[c]) slab.loops[slab.part[c]].push_back(c);
  }
  return slabs;
}

}  // namespace sweepmesh
