// Solids with curved faces of every kind that a cap may be, and nodes on their edges.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/cap_boundary.h"

namespace sweepmesh::test {

struct CurvedSolid {
  std::string name;
  Model model;
  double size;  ///< of elements
};

/// Domes with the pole inside, drilled through the pole and beside it, hollow; a cone with its
/// apex; an octant of a ball with the pole on its boundary; bands of cylinder, cone, ball and
/// torus; a lofted side.
std::vector<CurvedSolid> curved_solids();

/// An even number of equal edges of about `size` on every CAD edge.
struct EdgeRows {
  std::vector<std::vector<NodeId>> nodes;
  std::vector<std::vector<double>> t;
};
EdgeRows edge_rows(const Model& model, double size);

}  // namespace sweepmesh::test
