#include "sweepmesh/numerics/gmsh/temporary_directory.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {

TemporaryDirectory::TemporaryDirectory() {
  std::error_code error;
  const auto parent = std::filesystem::temp_directory_path(error);
  std::string name = (error ? std::filesystem::path("/tmp") : parent) / "sweepmesh-XXXXXX";
  if (!mkdtemp(name.data()))
    throw SolverError("surface", "No temporary directory could be made in " +
                                     std::filesystem::path(name).parent_path().string() + ".");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace sweepmesh
