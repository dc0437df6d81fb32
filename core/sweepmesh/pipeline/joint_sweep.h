// Touching solids meshed together: one mesh on every face that two of them share.
//
//   1. one interval problem for all, in which a shared edge has one number;
//   2. nodes on shared edges, those of a solid with imprinted caps before those of others;
//   3. structured grids on faces that are linking in one of their solids: the other takes them
//   over;
//   4. caps, solid after solid: those first that must make their own mesh as curves are imprinted
//   on them; then sweeps from one cap to one, along chains of solids, as each carries the mesh that
//   it has from a neighbour on to its other end; then those with several caps, each of which can
//   take one;
//   5. the volumes.
#pragma once

#include <vector>

#include "sweepmesh/pipeline/contacts.h"
#include "sweepmesh/pipeline/scheme_mesh.h"

namespace sweepmesh {

/// A solid of the shape, and the scheme that it is to be meshed by.
struct JointSolid {
  int number = 0;  ///< of the solid in its shape, as in Contacts
  const Model* model = nullptr;
  const Scheme* scheme = nullptr;
};

/// What went wrong, and in which solid.
struct JointFailure {
  int solid = -1;
  std::string sentence;
  std::vector<std::string> entities;
};

/// Meshes with elements of `size`, curves of caps brought together within `merge_fraction` of it,
/// by solid, in their order; nodes of common faces, edges and vertices lie on each other, but are
/// not merged. `contacts` are those to be met, all between these solids; `all` tells what
/// coincides. Throws what the stages throw; `failure` is set then.
std::vector<SchemeMesh> mesh_together(const std::vector<JointSolid>& solids, const Contacts& all,
                                      const std::vector<Contact>& contacts,
                                      const SweepOptions& options, double size,
                                      double merge_fraction, StageClock& clock, Context& context,
                                      JointFailure& failure);

}  // namespace sweepmesh
