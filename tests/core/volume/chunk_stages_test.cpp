// Stages over chunks: each chunk is done once, behind those that it needs, by any number of
// threads.
#include "sweepmesh/volume/chunk_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace sweepmesh {
namespace {

/// Chunks of a stage need those of the stage before up to `reach` farther on.
std::vector<int> needs_of(int n_chunks, int n_before, int reach) {
  std::vector<int> needs(n_chunks);
  for (int c = 0; c < n_chunks; ++c) needs[c] = std::min(n_before, c * n_before / n_chunks + reach);
  return needs;
}

TEST(ChunkStages, every_chunk_is_done_once_behind_what_it_needs) {
  for (const int n_threads : {1, 2, 4})
    for (const int reach : {1, 3, 40, 1000}) {
      ThreadTeam team(n_threads);
      const std::vector<int> sizes = {57, 57, 9, 123};
      std::vector<std::vector<int>> needs(1);
      std::vector<std::vector<std::atomic<int>>> times;
      for (const int n : sizes) times.emplace_back(n);
      for (std::size_t s = 1; s < sizes.size(); ++s)
        needs.push_back(needs_of(sizes[s], sizes[s - 1], reach));
      std::atomic<int> n_early = 0;
      std::vector<ChunkStage> stages;
      for (int s = 0; s < 4; ++s)
        stages.push_back({sizes[s], s > 0 ? &needs[s] : nullptr, [&, s](int c) {
                            for (int i = 0; s > 0 && i < needs[s][c]; ++i)
                              n_early += times[s - 1][i] != 1;
                            ++times[s][c];
                          }});
      for (int round = 1; round <= 20; ++round) {
        run_stages(stages, team);
        ASSERT_EQ(n_early, 0) << n_threads << " threads, reach " << reach;
        for (auto& stage : times)
          for (auto& t : stage) ASSERT_EQ(t.exchange(0), 1);
      }
    }
}

TEST(ChunkStages, a_stage_without_needs_waits_for_the_whole_stage_before) {
  ThreadTeam team(3);
  std::atomic<int> n_done = 0, n_early = 0;
  run_stages({{64, nullptr, [&](int) { ++n_done; }},
              {8, nullptr, [&](int) { n_early += n_done != 64; }},
              {1, nullptr, [&](int) {}}},
             team);
  EXPECT_EQ(n_done, 64);
  EXPECT_EQ(n_early, 0);
}

TEST(ChunkStages, neighbouring_stages_are_close_in_time) {
  ThreadTeam team(1);
  const std::vector<int> needs = needs_of(100, 100, 2);
  int n_first = 0, most_ahead = 0;
  run_stages({{100, nullptr, [&](int) { ++n_first; }},
              {100, &needs, [&](int c) { most_ahead = std::max(most_ahead, n_first - c); }}},
             team);
  EXPECT_LT(most_ahead, 10);
}

TEST(ChunkStages, exceptions_come_through) {
  for (const int n_threads : {1, 3}) {
    ThreadTeam team(n_threads);
    const std::vector<int> needs = needs_of(50, 50, 2);
    const auto fail = [](int c) {
      if (c == 20) throw std::runtime_error("twenty");
    };
    EXPECT_THROW(run_stages({{50, nullptr, fail}, {50, &needs, [](int) {}}}, team),
                 std::runtime_error);
    std::atomic<int> n_done = 0;
    run_stages({{50, nullptr, [&](int) { ++n_done; }}}, team);
    EXPECT_EQ(n_done, 50);
  }
}

}  // namespace
}  // namespace sweepmesh
