// Which face and edge of the targets is the image of each face and edge of the sources, where both
// are divided alike.
//
// A sweep through the thickness of a wall (box in box, a pipe from its inside to its outside) has
// caps that no plane shows at once, and perhaps no linking face. If the graphs of the caps' faces
// and edges are the same, one edge and its image settle those of everything that hangs together:
// next to next, other side to other side. Which edge goes with which is chosen by least squared
// distance, after the targets' size and place.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct FacePair {
  FaceId source, target;
};

struct EdgePair {
  EdgeId source, target;
  bool is_reversed = false;  ///< the target edge's end lies under the source edge's start
};

struct ShellMatch {
  std::vector<FacePair> faces;  ///< by source, ascending
  std::vector<EdgePair> edges;  ///< those that bound caps, by source, ascending
};

/// A one-to-one map of the sources' faces and bounding edges (seams aside) to the targets', under
/// which loops correspond, what touches touches, and the ends of axial edges go to one another.
/// Empty where there is none. Quadratic in the number of edges.
std::optional<ShellMatch> match_caps(const Model& model, const Scheme& scheme);

}  // namespace sweepmesh
