// What each face, edge and vertex of a solid is in a sweep, or the verdict that it cannot be swept.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/ids.h"

namespace sweepmesh {

/// divided: of a face whose parts have different roles (divided_sweep.h); no scheme of the stages
/// has such a face.
enum class FaceRole { none, source, target, linking, divided };

/// none: inside a cap (between two caps or a seam of a cap), no direction of its own. divided: as
/// of faces.
enum class EdgeRole { none, transverse, axial, divided };

/// How many quads meet at a face's vertex: END 1, SIDE 2, CORNER 3, REVERSAL 4 (thesis eq. 6.2).
/// The value is the turn of the boundary there, in quarter turns to the left.
enum class VertexType { end = 1, side = 0, corner = -1, reversal = -2 };

/// Direction of a coedge in the (i, k) plane of its linking face, with the face's normal (out of
/// the solid) towards the viewer: k up, i to the right. The face lies on the coedge's left, so a
/// coedge along +i has the face above it (at larger k), one along +k has it on the side of smaller
/// i.
enum class Direction { plus_i = 0, plus_k = 1, minus_i = 2, minus_k = 3 };

inline bool is_axial(Direction d) {
  return d == Direction::plus_k || d == Direction::minus_k;
}
inline Direction opposite(Direction d) {
  return static_cast<Direction>((static_cast<int>(d) + 2) % 4);
}
inline Direction turned(Direction d, VertexType t) {
  return static_cast<Direction>((static_cast<int>(d) + static_cast<int>(t) + 4) % 4);
}

/// Of one linking face, shaped like Model::loops(face). `direction[l][c]` is that of coedge c of
/// loop l; `type[l][c]` is that of the vertex where coedge c ends and the next starts.
struct FaceScheme {
  std::vector<std::vector<Direction>> direction;
  std::vector<std::vector<VertexType>> type;
};

/// Roles and types for a whole solid; vectors are indexed by the whole shape's ids and are `none`
/// (or empty) for entities of other solids and for what has no such property.
struct Scheme {
  std::vector<FaceRole> face_role;
  std::vector<EdgeRole> edge_role;
  std::vector<FaceScheme> face;
  double cost = 0.0;  ///< lower is better: deviation of the angles from those the types ask for

  std::vector<FaceId> faces_with(FaceRole role) const {
    std::vector<FaceId> out;
    for (std::size_t f = 0; f < face_role.size(); ++f)
      if (face_role[f] == role) out.emplace_back(f);
    return out;
  }
};

enum class ReasonKind { topological, geometric, prescribed, unsupported };

/// Why a solid cannot be swept (as picked). `text` is a whole sentence; `entities` are FreeCAD
/// names.
struct Reason {
  ReasonKind kind;
  std::string text;
  std::vector<std::string> entities;
};

/// The verdict. Sweepable: at least one scheme, the best first. Otherwise: at least one reason.
struct Assessment {
  std::vector<Scheme> schemes;
  std::vector<Reason> reasons;
  /// Not sweepable as angles are too far from what the types ask for: schemes that would be
  /// possible within the lenient limits (limits.h), the least cost first. Some can be meshed, if
  /// poorly; what can be seen of that without a mesh is the matter of the pipeline's verdict.h.
  std::vector<Scheme> strained = {};
  bool folds = false;  ///< not sweepable as walls run back against the sweep of a scheme
  bool is_sweepable() const { return !schemes.empty(); }
};

/// A vertex type that the user wants on a face, wherever its loops pass the vertex; it makes the
/// face a linking face.
struct TypePick {
  FaceId face;
  VertexId vertex;
  VertexType type = VertexType::side;
};

/// What the user said. Empty: to be found.
struct Picks {
  std::vector<FaceId> sources, targets;
  std::vector<std::pair<FaceId, FaceId>> pairs;  ///< source, target
  std::vector<TypePick> types = {};
};

}  // namespace sweepmesh
