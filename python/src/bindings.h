// SPDX-License-Identifier: MIT
/// The parts of the module freshet._freshet, one per file.
#pragma once
#include <pybind11/pybind11.h>

namespace freshet::python {

namespace py = pybind11;

void bind_errors(py::module_& m);
void bind_scenes(py::module_& m);
void bind_frames(py::module_& m);
void bind_forces(py::module_& m);
void bind_state(py::module_& m);
void bind_simulation(py::module_& m);
void bind_runs(py::module_& m);

}  // namespace freshet::python
