// A place for files that live as long as an object.
#pragma once

#include <filesystem>

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

}  // namespace sweepmesh
