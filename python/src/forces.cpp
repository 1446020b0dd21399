// SPDX-License-Identifier: MIT
#include "python/src/bindings.h"
#include "python/src/sim.h"

namespace freshet::python {
namespace {

/// The fluid within a step, for a force. It ends with the call of the force; its arrays are copies.
struct FluidInStep {
  const ParticleView* view;

  const ParticleView& fluid() const {
    if (!view)
      throw Error(Error::Kind::scene, "",
                  "this fluid was of a step that is over; keep its arrays instead");
    return *view;
  }
};

/// Adds what a force returned: one vector for all particles, or one per particle.
void add_to(std::span<double> acceleration, const py::object& returned, int dimension) {
  if (returned.is_none()) return;
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(returned);
  const auto D = py::ssize_t(dimension), n = py::ssize_t(acceleration.size()) / D;
  const bool each =
      numbers && numbers.ndim() == 2 && numbers.shape(0) == n && numbers.shape(1) == D;
  const bool same = numbers && numbers.ndim() == 1 && numbers.shape(0) == D;
  if (!each && !same) {
    PyErr_Clear();
    const py::object got = numbers ? py::object(numbers.attr("shape")) : py::object(py::none());
    throw py::value_error(py::str("a force must return accelerations [m/s²] of shape ({0}, {1}) or "
                                  "({1},), or None; it returned {2}")
                              .format(n, D, got.is_none() ? py::object(py::repr(returned)) : got));
  }
  const double* a = numbers.data();
  for (std::size_t k = 0; k < acceleration.size(); ++k)
    acceleration[k] += each ? a[k] : a[k % std::size_t(D)];
}

/// Calls a Python function as a force. The garbage collector owns the function by Sim::force.
void call(const py::object& force, const ParticleView& view, double time, std::span<double> a) {
  const py::gil_scoped_acquire acquire;
  const py::object fluid = py::cast(FluidInStep{&view});
  struct End {
    FluidInStep& fluid;
    ~End() { fluid.view = nullptr; }
  } const end{fluid.cast<FluidInStep&>()};
  add_to(a, force(fluid, time), view.dimension);
}

}  // namespace

void Sim::set_force(py::object function) {
  if (!function.is_none() && !PyCallable_Check(function.ptr()))
    throw py::type_error(py::str("a force must be a function of (fluid, time) or None; it is {!r}")
                             .format(function));
  Access sim(*this);
  force = std::move(function);
  if (force.is_none()) return sim->set_force({});
  sim->set_force([this](const ParticleView& fluid, double time, std::span<double> a) {
    call(force, fluid, time, a);
  });
}

void bind_forces(py::module_& m) {
  py::class_<FluidInStep>(m, "FluidInStep",
                          "The fluid that a force acts on. Each array is a copy, in one order.")
      .def_property_readonly("id", [](const FluidInStep& f) { return array_of(f.fluid().id); })
      .def_property_readonly(
          "x", [](const FluidInStep& f) { return array_of(f.fluid().x, f.fluid().dimension); },
          "Positions (n, D) [m].")
      .def_property_readonly(
          "v", [](const FluidInStep& f) { return array_of(f.fluid().v, f.fluid().dimension); },
          "Velocities (n, D) [m/s].")
      .def_property_readonly(
          "density", [](const FluidInStep& f) { return array_of(f.fluid().density); },
          "Of the last step (n,) [kg/m³].")
      .def_property_readonly(
          "pressure", [](const FluidInStep& f) { return array_of(f.fluid().pressure); },
          "Of the last step (n,) [Pa].")
      .def_property_readonly(
          "liquid", [](const FluidInStep& f) { return array_of(f.fluid().liquid); },
          "Index of the liquid (n,); empty in scenes with one.")
      .def_property_readonly("dimension", [](const FluidInStep& f) { return f.fluid().dimension; })
      .def("__len__", [](const FluidInStep& f) { return f.fluid().size(); });
}

}  // namespace freshet::python
