// A linking face rolled out in a plane: where its edges lie along i and along k, in lengths.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Whole periods to add to the (u,v) of each loop's coedges so that every loop runs on without a
/// jump, and the other loops lie near the first. Zero where the surface is not periodic.
std::vector<std::vector<Point2>> unwrapping(const Model& model, FaceId face);

/// Per loop and coedge: a polyline from the coedge's start to its end; x grows along +i, y along
/// +k.
///
/// The coordinates are (u,v) scaled to lengths by the mean of the surface's derivatives along the
/// boundary, and sheared so that on average the edges along i and k run along x and y. Exact up to
/// scale for planes and developable surfaces; on others an estimate, good enough to say which edge
/// lies left of which.
struct FaceLayout {
  std::vector<std::vector<std::vector<Point2>>> line;
  bool is_empty() const { return line.empty(); }
};

/// Empty where no such frame exists: a pole, or no edge along i or along k.
FaceLayout lay_out(const Model& model, const FaceScheme& scheme, FaceId face);

}  // namespace sweepmesh
