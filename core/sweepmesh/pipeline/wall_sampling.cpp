#include "sweepmesh/pipeline/wall_sampling.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sweepmesh/imprint/axial_spacing.h"
#include "sweepmesh/pipeline/boundary.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

/// Layers at which caps lie.
std::set<int> levels_of(const Model& model, const Scheme& scheme, const Intervals& intervals) {
  std::set<int> out;
  for (const FaceRole role : {FaceRole::source, FaceRole::target})
    for (const FaceId f : scheme.faces_with(role))
      for (const Loop& loop : model.loops(f)) out.insert(intervals.k[loop.front().start.index]);
  out.erase(-1);
  return out;
}

class Sampler {
 public:
  Sampler(SurfaceMesh surface, std::vector<ColumnNodes> columns)
      : surface_(std::move(surface)), columns_(std::move(columns)) {
    const auto at = columns_at_nodes(columns_, surface_.n_nodes());
    for (int cell = 0; cell < surface_.n_cells(); ++cell) {
      const int* node = &surface_.cell_nodes[surface_.cell_offset[cell]];
      sides_[surface_.k[node[0]]][at[node[0]].index] = {at[node[1]].index,
                                                        surface_.cell_face[cell]};
    }
  }

  std::vector<WallSection> slab(int k_low, int k_high) const {
    const auto side = sides_.find(k_low);
    if (side == sides_.end()) return {};
    std::vector<WallRing> rings;
    std::set<int> is_done;
    for (const auto& [first, to] : side->second)
      if (!is_done.contains(first))
        if (auto ring = ring_from(side->second, first, is_done); !ring.columns.empty()) {
          if (!add_layers(ring, k_low, k_high)) continue;
          rings.push_back(std::move(ring));
        }
    return joined_to_sections(k_low, k_high, std::move(rings));
  }

 private:
  using Sides = std::map<int, std::pair<int, FaceId>>;  ///< column -> the next one, across a face

  /// Empty where the way around does not come back.
  static WallRing ring_from(const Sides& sides, int first, std::set<int>& is_done) {
    WallRing ring;
    for (int at = first;;) {
      const auto it = sides.find(at);
      if (it == sides.end() || !is_done.insert(at).second) return {};
      ring.columns.push_back(at);
      ring.face.push_back(it->second.second);
      at = it->second.first;
      if (at == first) break;
    }
    return ring.n_columns() < 3 ? WallRing{} : ring;
  }

  bool add_layers(WallRing& ring, int k_low, int k_high) const {
    ring.layers.assign(k_high - k_low + 1, {});
    for (const int c : ring.columns)
      for (int k = k_low; k <= k_high; ++k) {
        const ColumnNodes& column = columns_[c];
        const int j = k - column.k_low;
        if (j < 0 || j >= static_cast<int>(column.nodes.size())) return false;
        ring.layers[k - k_low].push_back(surface_.points[column.nodes[j].index]);
      }
    return true;
  }

  SurfaceMesh surface_;
  std::vector<ColumnNodes> columns_;
  std::map<int, Sides> sides_;  ///< by lower layer
};

}  // namespace

std::vector<WallSection> wall_sections(const Model& model, const Scheme& scheme,
                                       const Layout& layout, const SweepOptions& options,
                                       double size, Context& context) {
  if (std::holds_alternative<Shell>(layout.match)) return {};
  const IntervalOptions wishes = interval_options(model, options, size);
  const Intervals& intervals = layout.counts.intervals;
  const EdgeNodes nodes = nodes_on_edges(model, scheme, layout.match, layout.counts, wishes);
  SurfaceMesh surface;
  const EdgeMesh edges = mesh_edges(model, intervals, nodes, surface);
  mesh_linking_faces(model, scheme, intervals, edges, context, surface);
  if (std::holds_alternative<Imprint>(layout.match) && !wishes.sweep_bias)
    space_by_levels(model, scheme, size, surface);
  auto columns = linking_columns(surface);
  const Sampler sampler(std::move(surface), std::move(columns));
  const std::set<int> levels = levels_of(model, scheme, intervals);
  std::vector<WallSection> out;
  for (auto it = levels.begin(); it != levels.end() && std::next(it) != levels.end(); ++it)
    std::ranges::move(sampler.slab(*it, *std::next(it)), std::back_inserter(out));
  return out;
}

}  // namespace sweepmesh
