#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/plan.h"

namespace py = pybind11;

namespace sweepmesh {

void bind_plan(py::module_& module) {
  py::enum_<EdgeRole>(module, "EdgeRole")
      .value("none", EdgeRole::none)
      .value("transverse", EdgeRole::transverse)
      .value("axial", EdgeRole::axial)
      .value("divided", EdgeRole::divided);
  py::class_<CornerType>(module, "CornerType")
      .def_property_readonly("face", [](const CornerType& c) { return c.face.index; })
      .def_property_readonly("vertex", [](const CornerType& c) { return c.vertex.index; })
      .def_property_readonly("edge", [](const CornerType& c) { return c.edge.index; })
      .def_readonly("point", &CornerType::point)
      .def_readonly("type", &CornerType::type);
  py::enum_<Direction>(module, "Direction")
      .value("plus_i", Direction::plus_i)
      .value("plus_k", Direction::plus_k)
      .value("minus_i", Direction::minus_i)
      .value("minus_k", Direction::minus_k);
  py::class_<EdgeDirection>(module, "EdgeDirection")
      .def_property_readonly("face", [](const EdgeDirection& d) { return d.face.index; })
      .def_property_readonly("edge", [](const EdgeDirection& d) { return d.edge.index; })
      .def_readonly("direction", &EdgeDirection::direction)
      .def_readonly("reversed", &EdgeDirection::reversed)
      .def_readonly("start", &EdgeDirection::from)
      .def_readonly("end", &EdgeDirection::to)
      .def_readonly("n_intervals", &EdgeDirection::n_intervals);
  py::class_<SweepPlan>(module, "SweepPlan")
      .def_readonly("assessment", &SweepPlan::assessment)
      .def_readonly("size", &SweepPlan::size)
      .def_readonly("corners", &SweepPlan::corners)
      .def_readonly("directions", &SweepPlan::directions)
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
