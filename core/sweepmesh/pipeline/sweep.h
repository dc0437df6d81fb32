// The whole pipeline in one call: from a model and picks to a volume mesh.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/quality/face_coverage.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

struct SweepResult {
  Assessment assessment;  ///< not sweepable: the mesh is empty
  Intervals intervals;
  VolumeMesh mesh;
  QualityReport quality;  ///< of `mesh`
  /// Of all faces; warnings name those that are covered poorly.
  std::vector<FaceCoverage> coverage;
  double size = 0.0;  ///< the element size that was used, near the wished one
  std::vector<std::string> warnings;
  std::map<std::string, double>
      seconds;  ///< per stage: assess, imprint, intervals, surface, place, quality
};

/// Decides (or takes from `picks`) sources and targets, meshes caps and linking faces, and places
/// the interior. Where the best scheme cannot be meshed, the next ones are tried; the one that was
/// used is the first of result.assessment.schemes, and a warning tells of the others; where its
/// elements are poor the others are meshed too, and the best mesh is taken. Where none
/// can, sizes near the wished one are tried too (down to 0.7 of it), with a warning. Throws the
/// stages' errors; a solid that cannot be swept is a normal result with reasons, and so is one
/// whose elements stay inverted wherever the inner nodes are put (a geometric reason, no mesh).
SweepResult sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                  Context& context);

}  // namespace sweepmesh
