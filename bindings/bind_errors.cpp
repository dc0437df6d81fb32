// The core's exceptions as Python classes with the attributes stage, entities and elements.
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/base/errors.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

// Python's own classes, in the order of Kind. The interpreter never unloads them.
enum Kind { base, input, solver, invalid_mesh, cancelled, n_kinds };
PyObject* classes[n_kinds];

PyObject* make_class(py::module_& module, const char* name, const char* doc, PyObject* parent) {
  py::dict attributes;
  attributes["stage"] = "";
  attributes["entities"] = py::tuple();
  const std::string full = "sweepmesh.engine." + std::string(name);
  PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, parent, attributes.ptr());
  if (!made) throw py::error_already_set();
  module.attr(name) = py::handle(made);
  return made;
}

void raise(Kind kind, const Error& error, const std::vector<long>* elements = nullptr) {
  py::object made = py::handle(classes[kind])(error.what());
  made.attr("stage") = error.stage();
  made.attr("entities") = error.entities();
  if (elements) made.attr("elements") = *elements;
  PyErr_SetObject(classes[kind], made.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Cancelled& error) {
    raise(cancelled, error);
  } catch (const InvalidMeshError& error) {
    raise(invalid_mesh, error, &error.elements());
  } catch (const InputError& error) {
    raise(input, error);
  } catch (const SolverError& error) {
    raise(solver, error);
  } catch (const Error& error) {
    raise(base, error);
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  classes[base] =
      make_class(module, "SweepMeshError",
                 "Base of all errors: `stage` of the pipeline, `entities` of the shape at fault.",
                 PyExc_RuntimeError);
  PyObject* parent = classes[base];
  classes[input] =
      make_class(module, "InputError", "A file, shape or option that cannot be used.", parent);
  classes[solver] =
      make_class(module, "SolverError", "An outside solver or program failed.", parent);
  classes[invalid_mesh] = make_class(module, "InvalidMeshError",
                                     "No valid mesh was found; `elements` stay inverted.", parent);
  py::handle(classes[invalid_mesh]).attr("elements") = py::tuple();
  classes[cancelled] = make_class(module, "Cancelled", "The caller asked to stop.", parent);
  py::register_exception_translator(&translate);
}

}  // namespace sweepmesh
