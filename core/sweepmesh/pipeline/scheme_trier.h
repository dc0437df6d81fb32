// The schemes of a solid and sizes near the wished one, tried until a mesh is good enough.
#pragma once

#include <optional>
#include <span>

#include "sweepmesh/pipeline/layout.h"
#include "sweepmesh/pipeline/stage_clock.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

inline constexpr double kPoor = 0.2;  ///< scaled Jacobian

/// Meshes one of the schemes of `result.assessment` into `result`, with elements of one of `shares`
/// of `result.size`, in their order. Schemes are tried in theirs (tries()) until one has elements
/// that are not poor, or so many that another try would cost more than it is worth; of several
/// meshes the best counts. Where none can be meshed the next size is tried: then nodes lie
/// elsewhere, and narrow places get other numbers of cells. The scheme that was used is moved to
/// the front; warnings tell of those before it that failed, and of another size.
///
/// A mesh that covers a CAD face poorly (quality/face_coverage.h) counts as a poor one, and other
/// sizes are tried after it as well.
///
/// Returns what the mesh is worth: the least scaled Jacobian, less 2 where a face is covered
/// poorly; nothing where elements stay inverted wherever inner nodes are put: result.assessment
/// then says so. Throws the first failure's error where all fail otherwise.
std::optional<double> mesh_some_scheme(const Model& model, const SweepOptions& options,
                                       std::span<const double> shares, StageClock& clock,
                                       Context& context, SweepResult& result);

/// Whether other schemes might be worth their cost: a mesh of little worth with few elements.
bool is_worth_another_try(double worth, const VolumeMesh& mesh);

/// Whether a scheme is worth that it was not the first choice.
bool is_clearly_better(double worth, double than);

}  // namespace sweepmesh
