#include "bind.h"

PYBIND11_MODULE(_sweepmesh, module) {
  module.doc() = "The C++ core of SweepMesh. Use sweepmesh.engine, not this module.";
  module.attr("__version__") = SWEEPMESH_VERSION;
  sweepmesh::bind_errors(module);
  sweepmesh::bind_context(module);
  sweepmesh::bind_model(module);
  sweepmesh::bind_scheme(module);
  sweepmesh::bind_cuts(module);
  sweepmesh::bind_quality(module);
  sweepmesh::bind_sweep(module);
  sweepmesh::bind_plan(module);
  sweepmesh::bind_imprint(module);
  sweepmesh::bind_fold(module);
}
