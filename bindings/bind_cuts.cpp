#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/tried_cut.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

std::optional<SuggestedCut> suggest(const Model& model, const std::vector<Reason>& reasons,
                                    Context& context, int max_tries, double seconds) {
  CutOptions options;
  options.max_tries = max_tries;
  options.seconds = seconds;
  return suggest_tried_cut(model, reasons, options, context);
}

}  // namespace

void bind_cuts(py::module_& module) {
  const CutOptions defaults;
  py::class_<SuggestedCut>(module, "SuggestedCut")
      .def_property_readonly("point", [](const SuggestedCut& c) { return c.plane.point; })
      .def_property_readonly("normal", [](const SuggestedCut& c) { return c.plane.normal; })
      .def_property_readonly("face", [](const SuggestedCut& c) { return c.face.index; })
      .def_readonly("is_tried", &SuggestedCut::is_tried)
      .def_property_readonly("pieces", [](const SuggestedCut& c) { return c.cut.pieces; })
      .def_property_readonly("shape", [](const SuggestedCut& c) { return c.cut.shape; })
      .def_property_readonly("text", &sentence_of);
  module.def("suggest_cut", &suggest, py::arg("model"), py::arg("reasons"), py::arg("context"),
             py::arg("max_tries") = defaults.max_tries, py::arg("seconds") = defaults.seconds,
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace sweepmesh
