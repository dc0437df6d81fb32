// How much the walls of a sweep must fold the layers between them: measures of wall sections.
#pragma once

#include <vector>

#include "sweepmesh/scheme/wall_sections.h"

namespace sweepmesh {

struct FoldMeasures {
  double winding = 0.0;
  double swing = 0.0;
  double tilt = 0.0;
  double run_back = 0.0;
  double folded = 0.0;
  double rim_least = 1.0;
  double least = 1.0;
};

FoldMeasures fold_measures(const std::vector<WallSection>& sections);

}  // namespace sweepmesh
