// The mesh of all patches in R, glued along the imprint edges: what is swept.
#pragma once

#include <span>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {

struct BaseMesh {
  std::vector<Point2> points;
  /// Counterclockwise polygons in compressed rows, patch by patch.
  std::vector<int> cell_offset = {0}, cell_nodes;
  std::vector<int> cell_patch;
  std::vector<std::vector<int>> edge_nodes;  ///< by imprint edge, from its start to its end

  int n_nodes() const { return static_cast<int>(points.size()); }
  int n_cells() const { return static_cast<int>(cell_patch.size()); }
  std::span<const int> cell(int c) const {
    return {cell_nodes.data() + cell_offset[c], cell_nodes.data() + cell_offset[c + 1]};
  }
};

/// Meshes patch by patch, the number of cells at each boundary node chosen to suit R and all caps
/// (patch_angles.h). Where cells come out poor, they and those around them are smoothed with the
/// nodes of inner imprint edges free: R need not follow the curves, every cap does that for its
/// own. `counts` are the mesh edges on each imprint edge. Throws what mesh_planar throws, naming
/// the caps.
BaseMesh mesh_base(const Model& model, const Imprint& imprint, const std::vector<int>& counts,
                   double size, CellKind kind, Context& context);

}  // namespace sweepmesh
