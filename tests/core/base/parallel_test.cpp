// Threads that work through chunks: each is done once, whatever the numbers, round after round.
#include "sweepmesh/base/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

namespace sweepmesh {
namespace {

TEST(ThreadTeam, does_every_index_once_in_every_round) {
  for (const int n_threads : {1, 2, 3, 8}) {
    ThreadTeam team(n_threads);
    for (int round = 0; round < 400; ++round) {
      const long n = (7 * round) % 113, grain = 1 + round % 9;
      std::vector<int> times(n, 0);
      team.for_chunks(n, grain, [&](long begin, long end, long chunk) {
        EXPECT_EQ(begin, chunk * grain);
        for (long i = begin; i < end; ++i) ++times[i];
      });
      for (long i = 0; i < n; ++i)
        ASSERT_EQ(times[i], 1) << n_threads << " threads, round " << round;
    }
  }
}

TEST(ThreadTeam, wakes_up_after_a_pause) {
  ThreadTeam team(4);
  for (int round = 0; round < 20; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    std::atomic<long> sum = 0;
    team.for_chunks(100, 1, [&](long begin, long, long) { sum += begin; });
    EXPECT_EQ(sum, 4950);
  }
}

TEST(ThreadTeam, sums_have_the_same_bits_for_any_number_of_threads) {
  const auto sum = [](int n_threads) {
    ThreadTeam team(n_threads);
    return team.sum_chunks(100000, ThreadTeam::grain_of(100000, 64, 4096), 0.0,
                           [](long begin, long end) {
                             double part = 0.0;
                             for (long i = begin; i < end; ++i) part += std::sin(double(i)) / 3.0;
                             return part;
                           });
  };
  const double one = sum(1);
  for (const int n_threads : {2, 3, 7}) EXPECT_EQ(sum(n_threads), one);
}

TEST(ThreadTeam, the_first_chunks_exception_is_thrown_and_the_team_goes_on) {
  for (const int n_threads : {1, 4}) {
    ThreadTeam team(n_threads);
    for (int round = 0; round < 50; ++round) {
      try {
        team.for_chunks(64, 1, [](long begin, long, long) {
          if (begin % 10 == 7) throw std::runtime_error(std::to_string(begin));
        });
        ADD_FAILURE() << "nothing was thrown";
      } catch (const std::runtime_error& e) {
        EXPECT_STREQ(e.what(), "7");
      }
      std::atomic<int> n_done = 0;
      team.for_chunks(64, 1, [&](long, long, long) { ++n_done; });
      EXPECT_EQ(n_done, 64);
    }
  }
}

TEST(ThreadTeam, grains_are_of_sizes_alone) {
  EXPECT_EQ(ThreadTeam::grain_of(10, 16, 1024), 16);
  EXPECT_EQ(ThreadTeam::grain_of(3200, 16, 1024), 100);
  EXPECT_EQ(ThreadTeam::grain_of(10000000, 16, 1024), 1024);
}

}  // namespace
}  // namespace sweepmesh
