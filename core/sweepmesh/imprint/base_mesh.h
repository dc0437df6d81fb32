// The mesh of all patches in R, glued along the imprint edges: what is swept.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/given_cells.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {

struct BaseMesh {
  std::vector<Point2> points;  ///< in R
  /// Counterclockwise polygons in compressed rows, patch by patch.
  std::vector<int> cell_offset = {0}, cell_nodes;
  std::vector<int> cell_patch;
  std::vector<std::vector<int>> edge_nodes;  ///< by imprint edge, from its start to its end
  /// By patch: the first of its nodes off the imprint edges; they follow one another.
  std::vector<int> first_inner;

  int n_nodes() const { return static_cast<int>(points.size()); }
  int n_cells() const { return static_cast<int>(cell_patch.size()); }
  std::span<const int> cell(int c) const {
    return {cell_nodes.data() + cell_offset[c], cell_nodes.data() + cell_offset[c + 1]};
  }
};

/// The nodes on imprint edges alone, numbered as in the whole base mesh.
BaseMesh mesh_base_edges(const Imprint& imprint, const std::vector<int>& counts);

/// By patch: its cells where they are given. Their first nodes are those of its loops, loop after
/// loop; `points` are where all of them lie on a cap.
struct GivenPatch {
  GivenCells cells;
  std::vector<Point3> points;
};
using GivenPatches = std::map<int, GivenPatch>;

/// The nodes of a patch's loops in the base mesh, loop after loop.
std::vector<int> loop_nodes(const BaseMesh& base, const Patch& patch);

/// Meshes patch by patch, the number of cells at each boundary node chosen to suit R and all caps
/// (patch_angles.h). Where cells come out poor, they and those around them are smoothed with the
/// nodes of inner imprint edges free: R need not follow the curves, every cap does that for its
/// own. `counts` are the mesh edges on each imprint edge. Throws what mesh_planar throws, naming
/// the caps.
BaseMesh mesh_base(const Model& model, const Imprint& imprint, const std::vector<int>& counts,
                   CellKind kind, Context& context, const GivenPatches& given = {});

}  // namespace sweepmesh
