// SPDX-License-Identifier: MIT
#include <freshet/version.h>

#include "python/src/bindings.h"

PYBIND11_MODULE(_freshet, m) {
  namespace python = freshet::python;
  m.doc() = "The C++ API of Freshet. Use the package freshet, which is made of it.";
  m.attr("version") = FRESHET_VERSION;
  python::bind_errors(m);
  python::bind_scenes(m);
  python::bind_frames(m);
  python::bind_forces(m);
  python::bind_state(m);
  python::bind_simulation(m);
  python::bind_runs(m);
}
