#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/plan.h"

namespace py = pybind11;

namespace sweepmesh {

void bind_plan(py::module_& module) {
  py::enum_<EdgeRole>(module, "EdgeRole")
      .value("none", EdgeRole::none)
      .value("transverse", EdgeRole::transverse)
      .value("axial", EdgeRole::axial);
  py::class_<CornerType>(module, "CornerType")
      .def_property_readonly("face", [](const CornerType& c) { return c.face.index; })
      .def_property_readonly("vertex", [](const CornerType& c) { return c.vertex.index; })
      .def_readonly("type", &CornerType::type);
  py::class_<SweepPlan>(module, "SweepPlan")
      .def_readonly("assessment", &SweepPlan::assessment)
      .def_readonly("size", &SweepPlan::size)
      .def_readonly("corners", &SweepPlan::corners)
      .def_property_readonly("edge_intervals", [](const SweepPlan& p) { return p.intervals.edge; })
      .def_readonly("edge_nodes", &SweepPlan::edge_nodes)
      .def_property_readonly("vertex_level", [](const SweepPlan& p) { return p.intervals.k; })
      .def_property_readonly("n_layers", [](const SweepPlan& p) { return p.intervals.n_layers; })
      .def_property_readonly("edge_role", [](const SweepPlan& p) {
        return p.assessment.is_sweepable() ? p.assessment.schemes.front().edge_role
                                           : std::vector<EdgeRole>();
      });
  module.def("plan", &plan_sweep, py::arg("model"), py::arg("picks"), py::arg("options"),
             py::arg("context"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace sweepmesh
