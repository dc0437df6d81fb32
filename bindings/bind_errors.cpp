// The core's exceptions as Python classes with the attributes stage, entities, elements and
// failure.
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/imprint/imprint.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

// Python's own classes, in the order of Kind. The interpreter never unloads them.
enum Kind { base, input, solver, invalid_mesh, imprint, cancelled, n_kinds };
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

py::object instance(Kind kind, const Error& error) {
  py::object made = py::handle(classes[kind])(error.what());
  made.attr("stage") = error.stage();
  made.attr("entities") = error.entities();
  return made;
}

void raise(Kind kind, const py::object& error) {
  PyErr_SetObject(classes[kind], error.ptr());
}

void raise(Kind kind, const Error& error) {
  raise(kind, instance(kind, error));
}

template <class Value>
void raise(Kind kind, const Error& error, const char* name, const Value& value) {
  const py::object made = instance(kind, error);
  made.attr(name) = value;
  raise(kind, made);
}

const char* name_of(ImprintFailure failure) {
  switch (failure) {
    case ImprintFailure::unreachable:
      return "unreachable";
    case ImprintFailure::collision:
      return "collision";
    case ImprintFailure::open_run:
      return "open_run";
    case ImprintFailure::no_room:
      return "no_room";
  }
  return "";
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Cancelled& error) {
    raise(cancelled, error);
  } catch (const InvalidMeshError& error) {
    raise(invalid_mesh, error, "elements", error.elements());
  } catch (const ImprintError& error) {
    raise(imprint, error, "failure", name_of(error.failure()));
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
  classes[imprint] = make_class(
      module, "ImprintError",
      "Sources and targets cannot be divided by each other; `failure` says how.", parent);
  py::handle(classes[imprint]).attr("failure") = "";
  classes[cancelled] = make_class(module, "Cancelled", "The caller asked to stop.", parent);
  py::register_exception_translator(&translate);
}

}  // namespace sweepmesh
