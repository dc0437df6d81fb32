// What a run keeps.
#include "sweepmesh/base/context.h"

#include <gtest/gtest.h>

#include "sweepmesh/base/parallel.h"

namespace sweepmesh {
namespace {

struct Counted {
  static inline std::atomic<int> n_made = 0, n_gone = 0;
  Counted() { ++n_made; }
  ~Counted() { ++n_gone; }
  int value = 0;
};

TEST(Context, keeps_one_of_a_type_for_all_threads_and_as_long_as_it_lives) {
  Counted::n_made = Counted::n_gone = 0;
  {
    const Context context;
    EXPECT_EQ(Counted::n_made, 0);
    std::vector<Counted*> seen(64);
    ThreadTeam team(4);
    team.for_chunks(64, 1, [&](long begin, long, long) { seen[begin] = &context.kept<Counted>(); });
    for (const Counted* one : seen) EXPECT_EQ(one, seen.front());
    EXPECT_EQ(Counted::n_made, 1);
    EXPECT_EQ(Counted::n_gone, 0);
  }
  EXPECT_EQ(Counted::n_gone, 1);
}

TEST(Context, keeps_types_apart) {
  const Context context;
  context.kept<int>() = 3;
  context.kept<Counted>().value = 4;
  EXPECT_EQ(context.kept<int>(), 3);
  EXPECT_EQ(context.kept<Counted>().value, 4);
}

}  // namespace
}  // namespace sweepmesh
