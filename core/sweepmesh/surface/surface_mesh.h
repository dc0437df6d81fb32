// The mesh of a solid's boundary: nodes that know their CAD entity, cells that know their CAD face.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"

namespace sweepmesh {

enum class EntityKind { vertex, edge, face };

/// The CAD entity of lowest dimension on which a node lies.
struct Owner {
  EntityKind kind = EntityKind::face;
  int index = -1;
  auto operator<=>(const Owner&) const = default;
};

struct SurfaceMesh {
  std::vector<Point3> points;
  std::vector<Owner> owner;
  std::vector<int>
      k;  ///< layer of a node of a linking face or of a cap's boundary; -1 inside a cap

  /// Cells in compressed rows (3, 4 or more nodes), counterclockwise seen from outside the solid.
  std::vector<int> cell_offset = {0};
  std::vector<int> cell_nodes;
  std::vector<FaceId> cell_face;

  int n_nodes() const { return static_cast<int>(points.size()); }
  int n_cells() const { return static_cast<int>(cell_face.size()); }
  int cell_size(int cell) const { return cell_offset[cell + 1] - cell_offset[cell]; }

  NodeId add_node(const Point3& p, Owner o, int layer = -1) {
    points.push_back(p);
    owner.push_back(o);
    k.push_back(layer);
    return NodeId{n_nodes() - 1};
  }
  void add_cell(const std::vector<NodeId>& nodes, FaceId face) {
    for (const NodeId n : nodes) cell_nodes.push_back(n.index);
    cell_offset.push_back(static_cast<int>(cell_nodes.size()));
    cell_face.push_back(face);
  }
};

}  // namespace sweepmesh
