#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/quality/quality.h"

namespace py = pybind11;

namespace sweepmesh {

void bind_quality(py::module_& module) {
  py::class_<Range>(module, "Range")
      .def_readonly("min", &Range::min)
      .def_readonly("mean", &Range::mean)
      .def_readonly("max", &Range::max);
  py::class_<QualityReport>(module, "QualityReport")
      .def_readonly("n_elements", &QualityReport::n_elements)
      .def_readonly("n_inverted", &QualityReport::n_inverted)
      .def_readonly("scaled_jacobian", &QualityReport::scaled_jacobian)
      .def_readonly("edge_ratio", &QualityReport::edge_ratio)
      .def_readonly("skew", &QualityReport::skew)
      .def_readonly("total_volume", &QualityReport::total_volume)
      .def_readonly("histogram", &QualityReport::histogram);
}

}  // namespace sweepmesh
