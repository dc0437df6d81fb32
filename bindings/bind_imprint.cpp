#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/imprint_shapes.h"

namespace py = pybind11;

namespace sweepmesh {

void bind_imprint(py::module_& module) {
  py::class_<CapPart>(module, "CapPart")
      .def_property_readonly("cap", [](const CapPart& p) { return p.cap.index; })
      .def_readonly("is_source", &CapPart::is_source)
      .def_readonly("pair", &CapPart::pair);
  py::class_<Merge>(module, "Merge")
      .def_property_readonly("kept", [](const Merge& m) { return m.kept.index; })
      .def_property_readonly("merged", [](const Merge& m) { return m.merged.index; })
      .def_readonly("distance", &Merge::distance);
  py::class_<ImprintShapes>(module, "ImprintShapes")
      .def_readonly("assessment", &ImprintShapes::assessment)
      .def_readonly("size", &ImprintShapes::size)
      .def_readonly("n_pairs", &ImprintShapes::n_pairs)
      .def_readonly("caps", &ImprintShapes::caps)
      .def_readonly("parts", &ImprintShapes::parts)
      .def_readonly("curves", &ImprintShapes::curves)
      .def_property_readonly("curve_on",
                             [](const ImprintShapes& s) {
                               std::vector<int> out;
                               for (const FaceId f : s.curve_on) out.push_back(f.index);
                               return out;
                             })
      .def_readonly("merges", &ImprintShapes::merges);
  module.def("imprint", &imprint_solids, py::arg("solids"), py::arg("picks"), py::arg("options"),
             py::arg("context"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace sweepmesh
