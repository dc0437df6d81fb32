// One scheme of a solid, meshed.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/pipeline/boundary.h"
#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/stage_clock.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/quality/face_coverage.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

struct SchemeMesh {
  Intervals intervals;
  VolumeMesh mesh;
  std::vector<FaceCoverage> coverage;  ///< by mesh_scheme: of all faces of the solid
  std::vector<std::string> warnings;
};

/// Imprints sources and targets on each other where there are several, chooses intervals, meshes
/// the boundary and places the interior, with elements of `size`. Where faces are covered poorly
/// (face_coverage.h), the surface is meshed again with more edges there, as long as that helps.
/// Throws the stages' errors.
SchemeMesh mesh_scheme(const Model& model, const Scheme& scheme, const SweepOptions& options,
                       double size, StageClock& clock, Context& context);

// Its steps, for solids that are meshed together.
/// Grids on the linking faces and meshes of the caps. Throws the surface stage's errors.
BoundaryMesh mesh_matched(const Model& model, const Scheme& scheme, const CapMatch& match,
                          const PieceCounts& counts, const IntervalOptions& options, CellKind kind,
                          Context& context);
/// The same mesh; throws InvalidMeshError where cells of caps lie over each other.
BoundaryMesh without_overlaps(BoundaryMesh boundary);
/// The volume within a boundary; the meshes of the faces `held` stay as they are.
SchemeMesh fill_boundary(const Model& model, const BoundaryMesh& boundary, Intervals intervals,
                         const std::set<FaceId>& held, const SweepOptions& options,
                         StageClock& clock, Context& context);
/// The cells of caps.
CellKind cells_of(ElementKind element);

}  // namespace sweepmesh
