// Hollow solids, to be swept through the thickness of their wall. OpenCASCADE stays inside
// walled.cpp.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh::test {

/// A hollow solid; the caps are the faces of its outer and of its inner skin.
struct Walled {
  std::string name;
  Model model;
  Picks picks;
  int euler;  ///< characteristic of the skin: 2 for a ball, 0 for a tube or a torus
};

/// Test reports show the name.
inline void PrintTo(const Walled& w, std::ostream* stream) {
  *stream << w.name;
}

/// Balls, boxes, tori, cans, tubes, a tee; concentric or not, seams turned or not, and some with
/// one skin closed and the other divided into faces. Turned about an axis and scaled.
std::vector<Walled> walled_solids(double angle = 0.0, double scale = 1.0);

/// A box with a void whose faces do not answer to the box's.
Walled box_with_can_void();

}  // namespace sweepmesh::test
