// The same solid with some of its faces divided: what lies inside a CAD face or edge then has edges
// and vertices of its own.
#pragma once

#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// A cut of a face: a straight line in its (u,v), from one point of its boundary to another. Across
/// a period the (u,v) are those of the coedges at its ends (Model::uv), so that the line runs
/// inside the face.
struct FaceCut {
  FaceId face;
  Point2 from, to;
};

/// A divided solid and what its parts are parts of. Vectors are indexed by the ids of `model`, the
/// ids in them are those of the undivided one.
struct DividedModel {
  Model model;
  std::vector<FaceId> face;
  std::vector<EdgeId> edge;       ///< invalid: a cut, which lies inside of `edge_face`
  std::vector<FaceId> edge_face;  ///< invalid for all edges but cuts
  std::vector<VertexId> vertex;   ///< invalid: virtual, it divides `vertex_edge`
  std::vector<EdgeId> vertex_edge;
};

/// Cuts the faces and divides the edges where cuts end. A face that is closed upon itself loses its
/// seam where cuts divide it: pieces run on across it. Throws Error("divide") where OpenCASCADE
/// cannot do it or the result is not the same solid. Cost: one general fuse.
DividedModel divide_model(const Model& model, const std::vector<FaceCut>& cuts);

}  // namespace sweepmesh
