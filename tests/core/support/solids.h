// Solids made in code, by family, for tests of all stages. OpenCASCADE stays inside solids.cpp.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh::test {

struct NamedModel {
  std::string name;
  Model model;
};

/// Test reports show the name.
inline void PrintTo(const NamedModel& named, std::ostream* stream) {
  *stream << named.name;
}

/// Right prisms over a square, an L, a hexagon, a disc, a ring, a plate with several holes.
std::vector<NamedModel> prisms();
/// Frustum of a cone, quarter of a tube's bend, tapered box, twisted square prism, lofted square to
/// circle.
std::vector<NamedModel> general_one_to_one();
/// Terraced and stepped solids, many sources over one target.
std::vector<NamedModel> many_to_one();
/// What has no sweep: a ball, a ring torus, a box with a ball cut out of one corner.
std::vector<NamedModel> unsweepable();

/// Holes in linking faces, whatever is swept: a block drilled along three axes, a shaft with a
/// cross bore, a block with a stepped and one with a blind hole across its upright hole.
std::vector<NamedModel> drilled_across();

Model box(double x, double y, double z);

/// Two boxes of side 10, the second `gap` beyond the first along x: Face1 to Face6 and Face7 to
/// Face12.
Model two_boxes(double gap);
/// Two boxes of side 10 that have half a face in common.
Model boxes_touching_in_part();
/// A box, and apart from it a ball.
Model box_and_ball();

}  // namespace sweepmesh::test
