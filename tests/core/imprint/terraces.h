// Solids with caps at many levels: extruded polygons stuck together. OpenCASCADE stays inside
// terraces.cpp.
#pragma once

#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh::test {

/// An upright prism over a plane outline (counterclockwise) between two heights.
struct Terrace {
  std::vector<Point2> outline;
  double low, high;
};

/// Where a solid stands in space: turned about an axis through the origin, then scaled.
struct Placement {
  Point3 axis = Point3::UnitZ();
  double angle = 0.0;  ///< radians
  double scale = 1.0;
};

/// The union of terraces, minus the union of `pockets`; coplanar faces are one.
Model terraced(const std::vector<Terrace>& terraces, const std::vector<Terrace>& pockets = {},
               const Placement& placement = {});

std::vector<Point2> rectangle(double x0, double y0, double x1, double y1);
std::vector<Point2> regular_polygon(const Point2& centre, double radius, int n, double angle = 0.0);

/// A block of 60 x 60 x 50 around the z axis with a rectangular pocket from above, ruled, whose
/// outline turns by `twist` (radians) and grows by `growth` from its floor at 16 to the top.
Model pocketed(double twist, double growth, const Placement& placement = {});

/// A slab of 60 x 50 x 20 with random polygons on both sides, at random heights.
std::vector<Terrace> random_terraces(unsigned seed);

/// The scheme of an upright solid: faces that look along the placed z axis are sources, those
/// against it targets. Throws std::runtime_error with the reasons where there is none.
Scheme upright_scheme(const Model& model, const Placement& placement = {});

}  // namespace sweepmesh::test
