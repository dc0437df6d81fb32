// From the boundary's mesh to the swept volume's topology, and back to groups of boundary cells.
#pragma once

#include <vector>

#include "sweepmesh/surface/surface_mesh.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// The surface nodes of one column: nodes[j] is the one at layer k_low + j, invalid where the
/// column runs inside the solid.
struct ColumnNodes {
  int k_low = 0;
  std::vector<NodeId> nodes;
};

/// A base cell swept over the columns `columns` (counterclockwise seen from larger k).
struct CellRun {
  std::vector<ColumnId> columns;
  int k_low = 0, k_high = 0;
};

struct Assembly {
  Extrusion extrusion;
  std::vector<char> fixed;       ///< per volume node: it lies on the boundary
  Points points;                 ///< those of fixed nodes are set, the others zero
  std::vector<int> volume_node;  ///< per surface node: its volume node
};

/// Numbers the volume's nodes (column by column) and puts the boundary's positions in.
/// Throws Error("assemble") when a surface node is in no column or in two, or when a run leaves the
/// range of one of its columns. Linear in nodes and cells.
Assembly assemble(const SurfaceMesh& surface, const std::vector<ColumnNodes>& columns,
                  const std::vector<CellRun>& runs);

/// Runs that lie over others: in some layer a side of theirs, from column to column, is the side of
/// another run in the same direction. Ascending; none in a valid mesh. n log n.
std::vector<int> overlapping_runs(const std::vector<CellRun>& runs);

/// Adds to `mesh` (whose points and elements are those of the assembly's extrusion) the boundary
/// cells with their CAD faces and every node's CAD entity.
void add_boundary(const SurfaceMesh& surface, const Assembly& assembly, VolumeMesh& mesh);

}  // namespace sweepmesh
