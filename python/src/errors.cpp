// SPDX-License-Identifier: MIT
#include <freshet/error.h>

#include <exception>

#include "python/src/arrays.h"
#include "python/src/bindings.h"

namespace freshet::python {

py::list diagnostics_list(const std::vector<Diagnostic>& diagnostics) {
  py::list all;
  for (const Diagnostic& d : diagnostics)
    all.append(py::make_tuple(d.severity == Diagnostic::Severity::error ? "error" : "warning",
                              d.place, d.message));
  return all;
}

namespace {

/// Raises freshet.Error, which the Python part of the package defines.
void raise(const Error& error) {
  const py::object type = py::module_::import("freshet.errors").attr("Error");
  const char* kind = error.kind() == Error::Kind::scene ? "scene" : "run";
  const py::object raised = type(kind, diagnostics_list(error.diagnostics()));
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      try {
        raise(error);
      } catch (py::error_already_set& other) {
        other.restore();
      }
    }
  });
}

}  // namespace freshet::python
