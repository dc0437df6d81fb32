// Loops over the same columns, one after the other, of which each reads what the one before wrote
// at neighbouring columns: done together, so that every loop finds in the cache what the last left.
//
//      stage 0   ################......       A chunk of a stage is done as soon as the chunks of
//      stage 1   ############..........       the stage before that it needs are done, and with a
//      stage 2   ########..............       few more between them, so that threads seldom wait.
//
// Where neighbours are far apart in their numbers, stages are done one after the other.
#pragma once

#include <functional>
#include <vector>

#include "sweepmesh/base/parallel.h"

namespace sweepmesh {

struct ChunkStage {
  int n_chunks = 0;
  /// Per chunk: how many chunks of the stage before have to be done, counted from the first.
  /// Null: none (of the first stage), or as many as there are.
  const std::vector<int>* needs = nullptr;
  std::function<void(int chunk)> work;
};

/// Does all chunks of all stages. What a chunk writes may be read and written over by later stages
/// only, and only by chunks that need it. Exceptions as ThreadTeam::for_chunks. The time it takes
/// beside the work is linear in the number of chunks.
void run_stages(const std::vector<ChunkStage>& stages, ThreadTeam& team);

}  // namespace sweepmesh
