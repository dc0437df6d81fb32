// Solids with curved faces of every kind that a cap may be, and nodes on their edges.
#pragma once

#include <array>
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
inline constexpr std::array curved_names = {"dome",
                                            "flat_dome",
                                            "dome_drilled_at_its_pole",
                                            "dome_drilled_aside",
                                            "bowl",
                                            "cone",
                                            "frustum",
                                            "octant",
                                            "zone",
                                            "bend",
                                            "wedge",
                                            "square_to_circle"};

/// One of the names; made when asked for.
CurvedSolid curved_solid(const std::string& name);

/// An even number of equal edges of about `size` on every CAD edge.
struct EdgeRows {
  std::vector<std::vector<NodeId>> nodes;
  std::vector<std::vector<double>> t;
};
EdgeRows edge_rows(const Model& model, double size);

}  // namespace sweepmesh::test
