// Threads that work through numbered chunks of an index range.
//
// Chunk boundaries depend on the length and the grain only, never on the number of threads, so a
// result that is a function of chunks (also a sum: one partial sum a chunk, added in order) has the
// same bits for one thread and for many.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "sweepmesh/base/context.h"

namespace sweepmesh {

/// A few threads kept for the length of one stage or run. Between calls they wait: awake for some
/// microseconds, since most calls follow one another closely, then asleep.
class ThreadTeam {
 public:
  /// `n_threads` counts the caller too; 0 means as many as the machine has.
  explicit ThreadTeam(int n_threads = 0) {
    const int hardware = static_cast<int>(std::thread::hardware_concurrency());
    const int n = n_threads > 0 ? n_threads : std::max(1, hardware);
    for (int t = 1; t < n; ++t) workers_.emplace_back([this] { work(); });
  }
  ~ThreadTeam() {
    is_over_ = true;
    start_round(0);
    for (std::thread& w : workers_) w.join();
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// The caller too.
  int n_threads() const { return static_cast<int>(workers_.size()) + 1; }

  static long n_chunks(long n, long grain) { return (n + grain - 1) / grain; }

  /// A grain that makes a few dozen chunks of [0, n), so that small ranges have work for all
  /// threads too, but within `least` .. `most`.
  static long grain_of(long n, long least, long most) {
    constexpr long wanted = 32;
    return std::clamp((n + wanted - 1) / wanted, least, most);
  }

  /// Calls f(begin, end, chunk) for each chunk of [0, n) of `grain` (the last may be shorter), in
  /// any order and on any thread. The first exception (of the lowest chunk) is thrown again here.
  /// Must not be called from within f. Fewer than 2^32 chunks.
  template <class F>
  void for_chunks(long n, long grain, F&& f) {
    const long chunks = n_chunks(n, grain);
    const auto one = [&](long c) { f(c * grain, std::min(n, (c + 1) * grain), c); };
    if (workers_.empty() || chunks < 2) {
      for (long c = 0; c < chunks; ++c) one(c);
      return;
    }
    FirstError error;
    auto job = [&](long c) noexcept {
      try {
        one(c);
      } catch (...) {
        error.note(c, std::current_exception());
      }
    };
    run(chunks, &job, [](void* j, long c) { (*static_cast<decltype(job)*>(j))(c); });
    if (error.what) std::rethrow_exception(error.what);
  }

  /// Sum of f(begin, end) over the chunks, added in the order of the chunks.
  template <class T, class F>
  T sum_chunks(long n, long grain, T zero, F&& f) {
    std::vector<T> partial(n_chunks(n, grain), zero);
    for_chunks(n, grain, [&](long begin, long end, long c) { partial[c] = f(begin, end); });
    for (const T& p : partial) zero += p;
    return zero;
  }

  /// What `a` holds when it is no longer `value`; whoever changes it calls notify_all().
  static std::uint32_t wait_while(const std::atomic<std::uint32_t>& a, std::uint32_t value) {
    constexpr int spins = 2000;  // some ten microseconds: what it takes to wake a thread
    for (int i = 0; i < spins; ++i) {
      const std::uint32_t now = a;
      if (now != value) return now;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
    a.wait(value);
    return a;
  }

 private:
  struct FirstError {
    std::mutex mutex;
    long chunk = -1;
    std::exception_ptr what;

    void note(long c, std::exception_ptr e) {
      const std::lock_guard lock(mutex);
      if (what && chunk < c) return;
      chunk = c;
      what = std::move(e);
    }
  };

  void start_round(std::uint32_t chunks) {
    const std::uint32_t next = round_ + 1;
    ticket_ = std::uint64_t{next} << 32 | chunks;
    round_ = next;
    round_.notify_all();
  }
  void run(long chunks, void* data, void (*job)(void*, long)) {
    data_ = data;
    job_ = job;
    n_left_ = n_jobs_ = static_cast<std::uint32_t>(chunks);
    start_round(n_jobs_);
    take(round_);
    for (std::uint32_t left = n_left_; left != 0;) left = wait_while(n_left_, left);
  }
  /// Does chunks of a round until all are taken. Who takes one holds the round open, so the job is
  /// still that of the ticket.
  void take(std::uint32_t round) {
    for (std::uint64_t t = ticket_; t >> 32 == round && static_cast<std::uint32_t>(t) != 0;) {
      if (!ticket_.compare_exchange_weak(t, t - 1)) continue;
      job_(data_, static_cast<long>(n_jobs_ - static_cast<std::uint32_t>(t)));
      if (--n_left_ == 0) n_left_.notify_one();
      t = ticket_;
    }
  }
  void work() {
    for (std::uint32_t seen = 0;;) {
      seen = wait_while(round_, seen);
      if (is_over_) return;
      take(seen);
    }
  }

  std::vector<std::thread> workers_;
  void* data_ = nullptr;
  void (*job_)(void*, long) = nullptr;
  std::uint32_t n_jobs_ = 0;
  std::atomic<std::uint64_t> ticket_ = 0;  ///< the round, and how many of its chunks are not taken
  std::atomic<std::uint32_t> round_ = 0;
  std::atomic<std::uint32_t> n_left_ = 0;  ///< chunks of the round that are not done
  std::atomic<bool> is_over_ = false;
};

/// The team of a run, started at its first use and kept until its context ends. One stage at a time
/// works with it.
inline ThreadTeam& team_of(const Context& context) {
  struct Kept {
    std::once_flag once;
    std::unique_ptr<ThreadTeam> team;
  };
  Kept& kept = context.kept<Kept>();
  std::call_once(kept.once, [&] { kept.team = std::make_unique<ThreadTeam>(context.n_threads()); });
  return *kept.team;
}

}  // namespace sweepmesh
