#include "bind.h"
#include "sweepmesh/base/context.h"

namespace py = pybind11;

namespace sweepmesh {

void bind_context(py::module_& module) {
  py::class_<Context>(module, "Context",
                      "Cancel flag and progress, shared with the thread that works.")
      .def(py::init<int>(), py::arg("n_threads") = Context().n_threads())
      .def_property_readonly("n_threads", &Context::n_threads)
      .def("cancel", &Context::cancel)
      .def("is_cancelled", &Context::is_cancelled)
      .def_property_readonly("fraction", &Context::fraction)
      .def_property_readonly("message", &Context::message);
}

}  // namespace sweepmesh
