#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/scheme/assess.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

/// Of the best scheme, refused for its winding or not.
Winding winding_of_best(const Model& model, const Picks& picks, Context& context) {
  const Assessment verdict = assess(model, picks, context);
  return verdict.is_sweepable() ? winding_of(model, verdict.schemes.front(), context) : Winding{};
}

}  // namespace

void bind_fold(py::module_& module) {
  py::class_<Winding>(module, "Winding")
      .def_readonly("angle", &Winding::angle)
      .def_property_readonly("faces", [](const Winding& w) {
        std::vector<int> out;
        for (const FaceId f : w.faces) out.push_back(f.index);
        return out;
      });
  module.def("winding", &winding_of_best, py::arg("model"), py::arg("picks"), py::arg("context"),
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace sweepmesh
