// Runs another program and waits for it, so that a crash or a hang there is an error here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweepmesh/base/context.h"

namespace sweepmesh {

/// A fresh directory that is removed with all that is in it when the object goes.
class TemporaryDirectory {
 public:
  /// Throws SolverError when none can be made (a full or read-only disk).
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs `arguments[0]` (looked up on PATH) in `directory`, which is also its home, so that no
/// settings of the user are read; what it prints goes to "log.txt" there. Gives its exit status; -1
/// where a signal ended it. When the context is cancelled the child is killed and Cancelled thrown.
/// Throws SolverError when the program cannot be started.
int run_process(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                const Context& context);

}  // namespace sweepmesh
