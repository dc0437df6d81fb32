// What imprinting makes of the caps, as shapes: without a mesh, for people to look at and to keep.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

/// A part of a cap that is swept to, or from, one part of another cap: that of the same pair.
struct CapPart {
  FaceId cap;
  bool is_source = false;
  int pair = -1;  ///< from 0, over all solids
};

struct ImprintShapes {
  Assessment assessment;  ///< not sweepable: all else is empty
  double size = 0.0;      ///< the element size that would be used; near curves are merged by it
  int n_pairs = 0;
  std::string caps;              ///< BREP text: a compound of faces, the divided caps
  std::vector<CapPart> parts;    ///< of each of them
  std::string curves;            ///< BREP text: a compound of wires, the imprinted curves
  std::vector<FaceId> curve_on;  ///< the cap on which each of them lies
  std::vector<Merge> merges;     ///< curves that were brought together
};

/// The imprint of the best scheme of every solid (sweep_solids.h) as shapes. Throws what plan_sweep
/// and divide_caps throw.
ImprintShapes imprint_solids(const std::vector<Model>& solids, const Picks& picks,
                             const SweepOptions& options, Context& context);

}  // namespace sweepmesh
