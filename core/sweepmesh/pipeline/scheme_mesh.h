// One scheme of a solid, meshed.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/pipeline/stage_clock.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

struct SchemeMesh {
  Intervals intervals;
  VolumeMesh mesh;
  std::vector<std::string> warnings;
};

/// Imprints sources and targets on each other where there are several, chooses intervals, meshes
/// the boundary and places the interior, with elements of `size`. Throws the stages' errors.
SchemeMesh mesh_scheme(const Model& model, const Scheme& scheme, const SweepOptions& options,
                       double size, StageClock& clock, Context& context);

bool is_one_to_one(const Scheme& scheme);

}  // namespace sweepmesh
