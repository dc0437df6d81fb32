// The shell of a closed surface and another one that is divided into faces: a ball in a box.
#pragma once

#include <optional>

#include "sweepmesh/imprint/shell.h"

namespace sweepmesh {

/// The edges of the divided side, with the cuts that its faces need, carried to the closed surface
/// along rays from the middle of the inner one. Empty where neither sources nor targets are a
/// single closed surface. Throws ImprintError (unreachable) where a ray does not meet the closed
/// surface squarely: it is not seen whole from there.
std::optional<Shell> carried_shell(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
