// Threads that work through numbered chunks of an index range.
//
// Chunk boundaries depend on the length and the grain only, never on the number of threads, so a
// result that is a function of chunks (also a sum: one partial sum a chunk, added in order) has the
// same bits for one thread and for many.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace sweepmesh {

/// A few threads kept for the length of one stage. They sleep between calls.
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
    start();
    for (std::thread& w : workers_) w.join();
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  static long n_chunks(long n, long grain) { return (n + grain - 1) / grain; }

  /// Calls f(begin, end, chunk) for each chunk of [0, n) of `grain` (the last may be shorter), in
  /// any order and on any thread. The first exception (of the lowest chunk) is thrown again here.
  /// Must not be called from within f.
  template <class F>
  void for_chunks(long n, long grain, F&& f) {
    const long chunks = n_chunks(n, grain);
    const auto one = [&](long c) { f(c * grain, std::min(n, (c + 1) * grain), c); };
    if (workers_.empty() || chunks < 2) {
      for (long c = 0; c < chunks; ++c) one(c);
      return;
    }
    std::vector<std::exception_ptr> errors(chunks);
    run(chunks, [&](long c) noexcept {
      try {
        one(c);
      } catch (...) {
        errors[c] = std::current_exception();
      }
    });
    for (const std::exception_ptr& e : errors)
      if (e) std::rethrow_exception(e);
  }

  /// Sum of f(begin, end) over the chunks, added in the order of the chunks.
  template <class T, class F>
  T sum_chunks(long n, long grain, T zero, F&& f) {
    std::vector<T> partial(n_chunks(n, grain), zero);
    for_chunks(n, grain, [&](long begin, long end, long c) { partial[c] = f(begin, end); });
    for (const T& p : partial) zero += p;
    return zero;
  }

 private:
  void start() {
    ++round_;
    round_.notify_all();
  }
  void run(long chunks, std::function<void(long)> job) {
    job_ = std::move(job);
    n_jobs_ = chunks;
    next_ = 0;
    n_busy_ = static_cast<int>(workers_.size());
    start();
    take();
    for (int b = n_busy_; b != 0; b = n_busy_) n_busy_.wait(b);
  }
  void take() {
    for (long c = next_++; c < n_jobs_; c = next_++) job_(c);
  }
  void work() {
    for (unsigned seen = 0;; ++seen) {
      round_.wait(seen);
      if (is_over_) return;
      take();
      if (--n_busy_ == 0) n_busy_.notify_one();
    }
  }

  std::vector<std::thread> workers_;
  std::function<void(long)> job_;
  long n_jobs_ = 0;
  std::atomic<long> next_ = 0;
  std::atomic<unsigned> round_ = 0;
  std::atomic<int> n_busy_ = 0;
  std::atomic<bool> is_over_ = false;
};

}  // namespace sweepmesh
