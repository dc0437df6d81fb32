// One function a topic; module.cpp calls them in this order. The module converts and does nothing
// else: ids become 0-based ints on the way out, arrays are numpy views of the C++ memory, long
// calls release the interpreter lock. Mod/sweepmesh/engine gives users the typed face with
// FreeCAD's own numbers.
#pragma once

#include <pybind11/pybind11.h>

namespace sweepmesh {

void bind_errors(pybind11::module_& module);
void bind_context(pybind11::module_& module);
void bind_model(pybind11::module_& module);
void bind_scheme(pybind11::module_& module);
void bind_cuts(pybind11::module_& module);
void bind_quality(pybind11::module_& module);
void bind_sweep(pybind11::module_& module);
void bind_plan(pybind11::module_& module);
void bind_imprint(pybind11::module_& module);
void bind_fold(pybind11::module_& module);

}  // namespace sweepmesh
