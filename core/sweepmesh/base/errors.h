// What is thrown when an input, a solver or a file fails. "This solid cannot be swept" is no error:
// it is a verdict (scheme/scheme.h).
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sweepmesh {

/// Base of all errors of the library. `what()` is one whole sentence for the user; `stage()` is the
/// pipeline stage ("read", "assess", "intervals", "surface", "place", ...); `entities()` names the
/// CAD entities at fault as FreeCAD does ("Face7", "Edge12"), empty where there is none.
class Error : public std::runtime_error {
 public:
  Error(std::string stage, const std::string& sentence, std::vector<std::string> entities = {})
      : std::runtime_error(sentence), stage_(std::move(stage)), entities_(std::move(entities)) {}

  const std::string& stage() const { return stage_; }
  const std::vector<std::string>& entities() const { return entities_; }

 private:
  std::string stage_;
  std::vector<std::string> entities_;
};

/// A file, shape or option that cannot be used (missing, corrupt, not a solid, size <= 0, ...).
class InputError : public Error {
  using Error::Error;
};

/// An outside solver or program failed or found no solution (lp_solve, Gmsh, a factorisation).
class SolverError : public Error {
  using Error::Error;
};

/// No valid mesh was found: elements stay inverted after untangling. `elements()` are the indices
/// of those elements in the mesh that the stage was making, `points()` their centres.
class InvalidMeshError : public Error {
 public:
  InvalidMeshError(std::string stage, const std::string& sentence,
                   std::vector<std::string> entities, std::vector<long> elements)
      : Error(std::move(stage), sentence, std::move(entities)), elements_(std::move(elements)) {}
  const std::vector<long>& elements() const { return elements_; }

 private:
  std::vector<long> elements_;
};

/// The caller asked to stop (Context::cancel).
class Cancelled : public Error {
 public:
  explicit Cancelled(std::string stage) : Error(std::move(stage), "The run was cancelled.") {}
};

}  // namespace sweepmesh
