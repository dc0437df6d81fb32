#include "sweepmesh/volume/chunk_stages.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>

namespace sweepmesh {
namespace {

/// Chunks that are begun between one and the last that it needs.
constexpr int slack = 3;

struct Item {
  int stage, chunk;
};

int needed(const std::vector<ChunkStage>& stages, int stage, int chunk) {
  if (stage == 0) return 0;
  const ChunkStage& s = stages[stage];
  return s.needs ? (*s.needs)[chunk] : stages[stage - 1].n_chunks;
}

/// All chunks, each behind those that it needs, and early.
std::vector<Item> order_of(const std::vector<ChunkStage>& stages) {
  const int n_stages = static_cast<int>(stages.size());
  std::vector<int> begun(n_stages, 0);
  std::vector<Item> order;
  std::size_t n = 0;
  for (const ChunkStage& s : stages) n += s.n_chunks;
  order.reserve(n);
  const auto is_ready = [&](int s) {
    if (begun[s] == stages[s].n_chunks) return false;
    if (s == 0) return true;
    const int before = stages[s - 1].n_chunks;
    return begun[s - 1] >= std::min(before, needed(stages, s, begun[s]) + slack);
  };
  while (order.size() < n)
    for (int s = n_stages - 1; s >= 0; --s)  // the last stage that can go on
      if (is_ready(s)) {
        order.push_back({s, begun[s]++});
        break;
      }
  return order;
}

/// How many chunks of a stage are done without a gap.
class Progress {
 public:
  explicit Progress(int n_chunks) : is_done_(n_chunks) {}

  void set_done(int chunk) {
    is_done_[chunk] = 1;
    std::uint32_t n = n_done_;
    while (n < is_done_.size() && is_done_[n])
      if (n_done_.compare_exchange_weak(n, n + 1)) ++n;
    n_done_.notify_all();
  }
  void wait_for(std::uint32_t n_chunks) const {
    for (std::uint32_t n = n_done_; n < n_chunks;) n = ThreadTeam::wait_while(n_done_, n);
  }

 private:
  std::vector<std::atomic<char>> is_done_;
  std::atomic<std::uint32_t> n_done_ = 0;
};

/// Notes a chunk as done however it ends, lest others wait for ever.
struct Finish {
  Progress& progress;
  int chunk;
  ~Finish() { progress.set_done(chunk); }
};

}  // namespace

void run_stages(const std::vector<ChunkStage>& stages, ThreadTeam& team) {
  const std::vector<Item> order = order_of(stages);
  const auto is_single = [](const ChunkStage& s) { return s.n_chunks < 2; };
  if (team.n_threads() < 2 || std::all_of(stages.begin(), stages.end(), is_single)) {
    for (const Item& item : order) stages[item.stage].work(item.chunk);
    return;
  }
  std::vector<std::unique_ptr<Progress>> progress;
  for (const ChunkStage& s : stages) progress.push_back(std::make_unique<Progress>(s.n_chunks));
  team.for_chunks(static_cast<long>(order.size()), 1, [&](long i, long, long) {
    const auto [stage, chunk] = order[i];
    const Finish finish = {*progress[stage], chunk};
    if (stage > 0) progress[stage - 1]->wait_for(needed(stages, stage, chunk));
    stages[stage].work(chunk);
  });
}

}  // namespace sweepmesh
