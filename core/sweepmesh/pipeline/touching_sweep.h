// Solids that touch, each by a sweep of its own, and one mesh where that can be had.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/pipeline/contacts.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

struct TouchingSweep {
  std::vector<SweepResult> parts;     ///< by solid, not measured where meshed together with others
  std::vector<Contact> met;           ///< with the same mesh on both sides
  std::vector<std::string> warnings;  ///< of contacts that are not met, naming their faces
};

/// Meshes solids that are connected by contacts together (joint_sweep.h), with schemes that get on
/// with each other (scheme_choice.h), at the size or one near it. Where that fails, the contacts
/// that stand in the way are given up, with a warning that says why, and what is then connected is
/// tried again; a solid without contacts is swept by itself. `picks` by solid. A part that cannot
/// be swept has a verdict and no mesh; no other is meshed then.
TouchingSweep sweep_touching(const std::vector<Model>& solids, const std::vector<Picks>& picks,
                             const SweepOptions& options, double size, const Contacts& contacts,
                             Context& context);

/// Nodes closer than this are one, where solids touch.
double merge_tolerance(const std::vector<Model>& solids);

}  // namespace sweepmesh
