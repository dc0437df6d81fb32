// The boundary of a sweep, meshed: caps and linking faces that fit together, with the columns
// between.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/given_boundary.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/surface/cap_mesh.h"
#include "sweepmesh/surface/quad_mesher.h"
#include "sweepmesh/volume/assemble.h"

namespace sweepmesh {

struct BoundaryMesh {
  SurfaceMesh surface;
  std::vector<ColumnNodes> columns;
  std::vector<CellRun> runs;
};

/// One source and one target: grids on the linking faces, a mesh of `kind` on the source, its image
/// on the target. What is given is taken over; where that is one cap, the other is its image; where
/// it is both, they must be the same mesh. Throws InputError for a scheme with more caps, and what
/// the surface stage throws.
BoundaryMesh mesh_boundary(const Model& model, const Scheme& scheme, const Intervals& intervals,
                           const IntervalOptions& options, CellKind kind, Context& context,
                           const GivenBoundary& given = {});

/// The columns of the linking faces' nodes.
std::vector<ColumnNodes> linking_columns(const SurfaceMesh& surface);

/// By surface node: the column through it; invalid where there is none.
std::vector<ColumnId> columns_at_nodes(const std::vector<ColumnNodes>& columns, int n_nodes);

/// Adds the runs of all cells between a source and its target, whose nodes `up` and `down` are in
/// the same order, from layer `k_low` to `k_high`, and columns where `up` has none yet;
/// `column_at`, by surface node, grows with them.
void add_runs_between(const CapMesh& source, const std::vector<NodeId>& up,
                      const std::vector<NodeId>& down, int k_low, int k_high,
                      std::vector<ColumnId>& column_at, BoundaryMesh& mesh);

/// Takes out nodes that no cell uses: those of seams and poles, which a cap's mesh passes over.
void drop_loose_nodes(BoundaryMesh& mesh);

}  // namespace sweepmesh
