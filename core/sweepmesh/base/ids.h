// Typed indices: an index of one kind of entity cannot be used for another.
//
// CAD entities count from 0 here; people see FreeCAD's names, which count from 1 (FaceId{6} is
// "Face7", the seventh face of OpenCASCADE's indexed face map of the whole shape).
#pragma once

#include <compare>
#include <functional>
#include <string>

namespace sweepmesh {

/// An index into the entities of kind `Tag`. `is_valid()` is false for a default-made one.
template <class Tag>
struct Id {
  int index = -1;

  constexpr Id() = default;
  constexpr explicit Id(int i) : index(i) {}
  constexpr explicit Id(std::size_t i) : index(static_cast<int>(i)) {}
  constexpr bool is_valid() const { return index >= 0; }
  constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexTag>;  ///< a CAD vertex
using EdgeId = Id<struct EdgeTag>;      ///< a CAD edge
using FaceId = Id<struct FaceTag>;      ///< a CAD face
using NodeId = Id<struct NodeTag>;      ///< a node of a surface mesh
using ColumnId = Id<struct ColumnTag>;  ///< a base node with its range of layers

inline std::string name_of(VertexId id) {
  return "Vertex" + std::to_string(id.index + 1);
}
inline std::string name_of(EdgeId id) {
  return "Edge" + std::to_string(id.index + 1);
}
inline std::string name_of(FaceId id) {
  return "Face" + std::to_string(id.index + 1);
}

}  // namespace sweepmesh

template <class Tag>
struct std::hash<sweepmesh::Id<Tag>> {
  std::size_t operator()(sweepmesh::Id<Tag> id) const noexcept {
    return std::hash<int>()(id.index);
  }
};
