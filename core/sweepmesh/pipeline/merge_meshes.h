// Meshes of touching solids as one: nodes that lie on each other become one node.
#pragma once

#include <vector>

#include "sweepmesh/pipeline/contacts.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// Contacts whose two faces do not have the same polygons, corner on corner within `tolerance`.
/// `meshes` by solid.
std::vector<Contact> unmet_contacts(const std::vector<VolumeMesh>& meshes,
                                    const std::vector<Contact>& contacts, double tolerance);

/// All meshes in one, in their order. On `met` contacts, which must hold, and on the edges and
/// vertices that solids have in common there, nodes within `tolerance` become one, that of the
/// lowest solid. A face that two solids share keeps the polygons of the lower one; two faces that
/// coincide keep both theirs, on the same nodes. n log n.
VolumeMesh merged(std::vector<VolumeMesh> meshes, const Contacts& all,
                  const std::vector<Contact>& met, double tolerance);

}  // namespace sweepmesh
