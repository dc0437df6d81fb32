#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/wall_sampling.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/scheme/fold_bound.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

FoldMeasures measure(const Model& model, const Scheme& scheme, Context& context) {
  const SweepOptions options;
  const double size = default_size(model);
  const Layout layout = lay_out(model, scheme, options, size, context);
  return fold_measures(wall_sections(model, scheme, layout, options, size, context));
}

FoldMeasures measure_picked(const Model& model, const Picks& picks, Context& context) {
  const Assessment a = assess(model, picks, context);
  if (!a.is_sweepable()) return {};
  return measure(model, a.schemes.front(), context);
}

}  // namespace

void bind_fold(py::module_& module) {
  py::class_<FoldMeasures>(module, "FoldMeasures")
      .def_readonly("winding", &FoldMeasures::winding)
      .def_readonly("swing", &FoldMeasures::swing)
      .def_readonly("tilt", &FoldMeasures::tilt)
      .def_readonly("run_back", &FoldMeasures::run_back)
      .def_readonly("folded", &FoldMeasures::folded)
      .def_readonly("rim_least", &FoldMeasures::rim_least)
      .def_readonly("least", &FoldMeasures::least);
  module.def("fold_measures", &measure_picked, py::arg("model"), py::arg("picks"), py::arg("context"));
}

}  // namespace sweepmesh
