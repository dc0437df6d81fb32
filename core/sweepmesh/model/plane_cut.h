// A solid cut by a plane.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

struct Plane {
  Point3 point = Point3::Zero();
  Point3 normal = Point3::UnitZ();  ///< unit
};

/// The plane of a plane face, its normal out of the solid; undefined for other faces.
Plane plane_of(const Model& model, FaceId face);

/// What a plane leaves of a model's solid.
struct CutPieces {
  std::string shape;  ///< BREP text of a compound of the pieces, which share the cut's faces
  std::vector<Model> pieces;  ///< its solids in their order, each a shape of its own
};

/// The plane is taken as unbounded. No pieces where it does not divide the solid, or where
/// OpenCASCADE cannot cut it: where the pieces are not sound solids whose volumes add up to the
/// whole. Cost: one general fuse.
CutPieces cut_by_plane(const Model& model, const Plane& plane);

}  // namespace sweepmesh
