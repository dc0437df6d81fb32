// Shapes of several solids: each has a sweep of its own, and where two touch their meshes are one.
#pragma once

#include <vector>

#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

/// The solids of a shape, in the order of their numbers.
std::vector<Model> solids_of(const Model& model);

/// Sweeps every solid; picks go to the solid that has the face (InputError where none has it). One
/// size for all: where none is given, the default size of the smallest solid. The result is that of
/// one shape: the schemes merged into one, meshes one after the other, with common nodes where
/// solids touch (touching_sweep.h); a warning names faces where that could not be had, and those
/// that touch in part. Boundary cells are those of all faces, the common ones of two solids too: a
/// face that both use once, faces that coincide both. If one solid cannot be swept, the verdict is
/// that, its reasons name it, and no mesh is made. One solid: the same as sweep().
SweepResult sweep_solids(const std::vector<Model>& solids, const Picks& picks,
                         const SweepOptions& options, Context& context);

/// The verdict alone.
Assessment assess_solids(const std::vector<Model>& solids, const Picks& picks, Context& context);

// For other stages over several solids.
/// The picks on faces of this solid.
Picks picks_on(const Model& model, const Picks& picks);
/// Throws InputError for a pair of faces that are not of one solid.
void check_pairs(const std::vector<Model>& solids, const Picks& picks);
/// One verdict for all: the best schemes merged; or all reasons, each with its solid's number.
Assessment merged_verdicts(const std::vector<Assessment>& parts);
/// The default size of the smallest solid.
double smallest_default_size(const std::vector<Model>& solids);

}  // namespace sweepmesh
