// A process that holds Gmsh ready and meshes file after file, so that a crash or a hang there is an
// error here. To load Gmsh takes some 90 ms, the mesh of a small cap 5 ms: each is made in a copy
// (fork) of the process that has loaded it, always in the same state.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "sweepmesh/base/context.h"

namespace sweepmesh {

class GmshWorker {
 public:
  /// Starts it, without waiting until it is ready. Throws SolverError when it cannot be started.
  explicit GmshWorker(const std::string& program = default_program());
  ~GmshWorker();
  GmshWorker(const GmshWorker&) = delete;
  GmshWorker& operator=(const GmshWorker&) = delete;

  /// Makes "cap.msh" of "cap.geo" in `directory`. The exit status of the copy that does it; -1
  /// where a signal ended it. Throws Cancelled when the context is, and SolverError when the worker
  /// itself has ended; it is of no use after either.
  int run(const std::filesystem::path& directory, const Context& context);

  /// sweepmesh_gmsh_worker beside the library or program that this code is in; where there is none,
  /// that of the build.
  static std::string default_program();

 private:
  void send(const std::string& line) const;
  bool can_read() const;

  std::string program_;
  int process_ = -1;
  int socket_ = -1;
};

/// The workers of a run: as many as are at work at one time. May be used from any thread.
class GmshWorkers {
 public:
  std::unique_ptr<GmshWorker> take();
  void give_back(std::unique_ptr<GmshWorker> worker);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<GmshWorker>> idle_;
};

}  // namespace sweepmesh
