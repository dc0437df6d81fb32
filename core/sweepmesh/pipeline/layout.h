// Whether a scheme can be laid out: what is decided between a scheme and its mesh.
//
// Angles alone do not tell whether sources and targets can be imprinted on each other and numbers
// of mesh edges be found. Both can be tried without a mesh. Of the schemes whose angles are beyond
// what the free search takes, about nine in ten that can be laid out can be meshed, and hardly one
// of the others (docs/assessment.md).
#pragma once

#include <optional>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Why not, with the entities that the stage names; empty where imprint and intervals can be had at
/// the wished size. Each distance of merging near curves is tried. Cost: that of imprint and
/// intervals, of each distance where it fails. Throws Cancelled and the options' InputError.
std::optional<Reason> layout_fault(const Model& model, const Scheme& scheme,
                                   const SweepOptions& options, Context& context);

inline constexpr std::size_t kMostStrained = 6, kEnoughStrained = 3;

/// Makes a verdict sweepable by those of its strained schemes that can be laid out: `kMostStrained`
/// are tried in their order until `kEnoughStrained` are found. Nothing changes where none can be,
/// or where it is sweepable.
void accept_strained(const Model& model, const SweepOptions& options, Context& context,
                     Assessment& verdict);

}  // namespace sweepmesh
