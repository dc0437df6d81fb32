// Wall-clock time of stages.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace sweepmesh {

/// Runs stages and notes how long each took.
class StageClock {
 public:
  explicit StageClock(std::map<std::string, double>& seconds) : seconds_(seconds) {}

  template <class F>
  auto run(const char* stage, F&& f) {
    const Timer timer(seconds_[stage]);
    return f();
  }

 private:
  class Timer {
   public:
    explicit Timer(double& total) : total_(total) {}
    ~Timer() {
      total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

   private:
    double& total_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  };

  std::map<std::string, double>& seconds_;
};

}  // namespace sweepmesh
