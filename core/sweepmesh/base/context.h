// The caller's side of a long run: cancel flag, progress, number of threads, helpers.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <utility>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {

/// Shared by the thread that works and the thread that watches. The library writes progress here
/// and never calls back; the watcher polls. All members may be used from any thread.
class Context {
 public:
  /// `n_threads` 0 means as many as the machine has; results do not depend on it.
  explicit Context(int n_threads = 0) : n_threads_(n_threads) {}

  int n_threads() const { return n_threads_; }

  /// Asks the run to end; it throws Cancelled at its next check().
  void cancel() { cancelled_ = true; }
  bool is_cancelled() const { return cancelled_; }

  /// Throws Cancelled when cancel() was called. Stages call it at least every 0.2 seconds.
  void check(const char* stage) const {
    if (cancelled_) throw Cancelled(stage);
  }

  /// Sets the progress of the running stage: `fraction` in 0..1 of that stage, and a short message.
  void report(double fraction, std::string message) {
    fraction_ = fraction;
    const std::lock_guard lock(mutex_);
    message_ = std::move(message);
  }
  /// The run's own `T`, made at its first use: what is costly to start and lives as long as the
  /// context.
  template <class T>
  T& kept() const {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<void>& slot = kept_[typeid(T)];
    if (!slot) slot = std::make_shared<T>();
    return *static_cast<T*>(slot.get());
  }

  double fraction() const { return fraction_; }
  std::string message() const {
    const std::lock_guard lock(mutex_);
    return message_;
  }

 private:
  int n_threads_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<double> fraction_ = 0.0;
  mutable std::mutex mutex_;
  std::string message_;
  mutable std::map<std::type_index, std::shared_ptr<void>> kept_;
};

}  // namespace sweepmesh
