#include "sweepmesh/imprint/piece_counts.h"

#include <utility>

namespace sweepmesh {

PieceCounts piece_counts(SolvedIntervals solved, const std::vector<int>& piece) {
  PieceCounts out{std::move(solved.intervals), {}};
  for (const int unknown : piece) out.edge.push_back(static_cast<int>(solved.values[unknown]));
  return out;
}

}  // namespace sweepmesh
