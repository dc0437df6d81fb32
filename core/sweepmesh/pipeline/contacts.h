// Where the solids of a shape touch: faces, edges and vertices that they have in common.
//
// A compsolid, and what FreeCAD's BooleanFragments leaves, has a common face once. Parts of a
// compound that were modelled one by one have two that coincide: equal vertices, then edges that
// are equal between equal vertices, then faces of equal edges, each within the CAD file's own
// tolerance. Either way the lowest number of those that coincide stands for all.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Two solids on either side of a face; the two faces are one and the same in a compsolid.
struct Contact {
  int solid = -1, other = -1;  ///< solid < other
  FaceId face, other_face;
};

struct Contacts {
  /// By id: the lowest that coincides with it, itself where none does.
  std::vector<FaceId> face;
  std::vector<EdgeId> edge;
  std::vector<VertexId> vertex;
  /// By EdgeId: it runs against the one that stands for it.
  std::vector<char> edge_is_turned;
  /// By EdgeId, of those that stand for others: the solids that use it or one that coincides.
  std::vector<std::vector<int>> solids_at_edge;
  std::vector<std::vector<int>> solids_at_vertex;
  std::vector<Contact> contacts;  ///< by face
};

/// Contacts of the solids of one shape. Closed edges coincide only where their vertices do. Cost:
/// some distances to edges and faces for each that has a candidate.
Contacts find_contacts(const std::vector<Model>& solids);

/// Faces of different solids that lie on each other in part and are no contact.
struct Overlap {
  int solid = -1, other = -1;
  FaceId face, other_face;
};

/// Found by sampling: what is smaller than an eighth of both faces may be missed.
std::vector<Overlap> overlapping_faces(const std::vector<Model>& solids, const Contacts& contacts);

}  // namespace sweepmesh
