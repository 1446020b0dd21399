// SPDX-License-Identifier: MIT
#include <freshet/checkpoint.h>
#include <freshet/report.h>
#include <freshet/time_step.h>
#include <pybind11/stl.h>

#include "python/src/arrays.h"
#include "python/src/bindings.h"

namespace freshet::python {
namespace {

void bind_solves(py::module_& m) {
  using S = SolveStatistics;
  py::class_<S>(m, "Solve", "An implicit solve over the accepted steps. Errors are fractions.")
      .def_readonly("name", &S::name, "\"density\", \"divergence\" or \"viscosity\".")
      .def_readonly("tolerance", &S::tolerance, "Maximum error of a converged solve.")
      .def_readonly("solves", &S::solves, "Number of solves.")
      .def_readonly("iterations", &S::iterations, "Iterations of all solves.")
      .def_readonly("most_iterations", &S::most_iterations, "Maximum of one solve.")
      .def_readonly("not_converged", &S::not_converged, "Solves that ended above the tolerance.")
      .def_readonly("last_iterations", &S::last_iterations)
      .def_readonly("last_error", &S::last_error)
      .def_readonly("worst_error", &S::worst_error)
      .def("__repr__", [](const S& s) {
        return py::str("<freshet.Solve {}: {} iterations, error {:.3g} of {:.3g}>")
            .format(s.name, s.last_iterations, s.last_error, s.tolerance);
      });
}

void bind_flows(py::module_& m) {
  py::class_<Flow>(m, "Flow", "What an inlet, an outlet, a counter or an open side has passed.")
      .def_readonly("kind", &Flow::kind, "\"inlet\", \"outlet\", \"counter\" or \"open side\".")
      .def_readonly("name", &Flow::name)
      .def_readonly("particles", &Flow::particles, "Since the start; a counter's are signed.")
      .def_readonly("volume", &Flow::volume, "At rest density [m³; m² in 2D].")
      .def_readonly("rate", &Flow::rate, "Mean since the given moment [m³/s; m²/s in 2D].")
      .def_readonly("waiting", &Flow::waiting, "Particles that a recycling inlet has not emitted.")
      .def("__repr__", [](const Flow& f) {
        return py::str("<freshet.Flow {} {}: {} particles, {:.3g}/s>")
            .format(f.kind, f.name, f.particles, f.rate);
      });
}

void bind_statistics(py::module_& m) {
  using S = Statistics;
  py::class_<S>(m, "Statistics", "A summary of the fluid. SI units; energies are per metre in 2D.")
      .def_readonly("particles", &S::particles)
      .def_readonly("out_of_bounds", &S::out_of_bounds, "Outside the domain, or NaN.")
      .def_readonly("density_mean", &S::density_mean, "[kg/m³].")
      .def_readonly("density_min", &S::density_min, "[kg/m³].")
      .def_readonly("density_max", &S::density_max, "[kg/m³].")
      .def_readonly("density_error_mean", &S::density_error_mean,
                    "Mean of max(0, ρ/ρ0 − 1), a fraction.")
      .def_readonly("density_error_max", &S::density_error_max, "Maximum of ρ/ρ0 − 1, or 0.")
      .def_readonly("speed_mean", &S::speed_mean, "[m/s].")
      .def_readonly("speed_max", &S::speed_max, "[m/s].")
      .def_readonly("fastest", &S::fastest, "Id of the fastest particle.")
      .def_readonly("height_mean", &S::height_mean, "Mean of y [m].")
      .def_readonly("kinetic_energy", &S::kinetic_energy, "[J; J/m in 2D].")
      .def_readonly("potential_energy", &S::potential_energy, "0 at the origin [J; J/m in 2D].")
      .def_property_readonly(
          "momentum", [](const S& s) { return array_of(s.momentum); },
          "[kg m/s; (kg m/s)/m in 2D].")
      .def_property_readonly(
          "angular_momentum", [](const S& s) { return array_of(s.angular_momentum); },
          "About the origin, about z in 2D [kg m²/s; (kg m²/s)/m in 2D].");
}

void bind_times(py::module_& m) {
  py::class_<TimeSteps>(m, "TimeSteps", "The time steps so far [s].")
      .def_readonly("last", &TimeSteps::last)
      .def_readonly("min", &TimeSteps::min)
      .def_readonly("max", &TimeSteps::max)
      .def_readonly("ruled", &TimeSteps::ruled, "How often each limit ruled an adaptive step.")
      .def_readonly("last_ruled", &TimeSteps::last_ruled)
      .def_readonly("retried", &TimeSteps::retried, "Steps halved as a solve did not converge.");
  using B = TimeStepBounds;
  py::class_<B>(m, "TimeStepBounds", "Upper limits of the next step [s].")
      .def_readonly("acoustic", &B::acoustic)
      .def_readonly("force", &B::force)
      .def_readonly("viscous", &B::viscous)
      .def_readonly("flow", &B::flow)
      .def_readonly("capillary", &B::capillary)
      .def_property_readonly("least", &B::least, "The smallest.")
      .def_property_readonly("ruling", &B::ruling, "Its name.");
  py::class_<Warning>(m, "Warning", "A warning of the health monitor.")
      .def_readonly("kind", &Warning::kind)
      .def_readonly("message", &Warning::message)
      .def_readonly("first_step", &Warning::first_step)
      .def_readonly("last_step", &Warning::last_step)
      .def_readonly("first_time", &Warning::first_time, "[s].")
      .def_readonly("unphysical", &Warning::cannot_be_right,
                    "Severe or lasting enough to make the result unphysical.")
      .def("__repr__", [](const Warning& w) {
        return py::str("<freshet.Warning {}: {}>").format(w.kind, w.message);
      });
  py::class_<Checkpoint>(m, "Checkpoint", "The complete state of a simulation at one time.")
      .def_readonly("steps", &Checkpoint::steps)
      .def_readonly("time", &Checkpoint::time, "[s].");
}

}  // namespace

void bind_state(py::module_& m) {
  bind_solves(m);
  bind_flows(m);
  bind_statistics(m);
  bind_times(m);
}

}  // namespace freshet::python
