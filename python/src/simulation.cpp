// SPDX-License-Identifier: MIT
#include <freshet/checkpoint.h>
#include <freshet/checkpoint_file.h>
#include <freshet/probe_reading.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "python/src/bindings.h"
#include "python/src/sim.h"

namespace freshet::python {
namespace {

using Numbers = py::array_t<Real, py::array::c_style | py::array::forcecast>;
using Class = py::class_<Sim>;

/// (n, D) numbers of finite value; `what` names them in messages.
std::span<const Real> vectors(const Numbers& array, int dimension, const char* what) {
  if (array.ndim() != 2 || array.shape(1) != dimension)
    throw py::value_error(py::str("{} must have the shape (n, {})").format(what, dimension));
  return {array.data(), std::size_t(array.size())};
}

/// Overwrites positions or velocities.
void write(std::span<Real> to, const Numbers& from, int dimension, const char* what) {
  const std::span<const Real> numbers = vectors(from, dimension, what);
  if (numbers.size() != to.size())
    throw py::value_error(py::str("{} must have one row for each of the {} particles; it has {}")
                              .format(what, to.size() / std::size_t(dimension), from.shape(0)));
  if (!std::all_of(numbers.begin(), numbers.end(), [](Real a) { return std::isfinite(a); }))
    throw py::value_error(py::str("{} has NaN or infinite numbers").format(what));
  std::copy(numbers.begin(), numbers.end(), to.begin());
}

std::int64_t step(Sim& sim, std::int64_t n) {
  if (n < 0) throw py::value_error(py::str("n must be >= 0; it is {}").format(n));
  return sim.step_while([n](const Simulation&, std::int64_t steps) { return steps < n; });
}

/// Steps to a time, or until `seconds` of wall time have passed.
std::int64_t step_until(Sim& sim, double time, std::int64_t steps, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const double enough = std::isfinite(time) ? time - 1e-9 * std::abs(time) : time;
  return sim.step_while([=](const Simulation& s, std::int64_t done) {
    return s.time() < enough && done < steps && (done == 0 || Clock::now() < end);
  });
}

py::dict by_name(const std::vector<std::string>& names, const std::vector<Vector>& vectors) {
  py::dict all;
  for (std::size_t k = 0; k < names.size(); ++k) all[py::str(names[k])] = array_of(vectors[k]);
  return all;
}

py::dict boundary_dict(const BoundaryForces& b, int dimension) {
  using namespace py::literals;
  return py::dict("x"_a = array_of(std::span<const double>(b.x), dimension),
                  "force"_a = array_of(std::span<const double>(b.force), dimension),
                  "part"_a = array_of(std::span<const int>(b.part)));
}

/// (name, quantities with units, places, values) of each probe.
py::list probe_list(const std::vector<ProbeReading>& probes) {
  py::list all;
  for (const ProbeReading& p : probes) {
    std::vector<std::pair<std::string, std::string>> quantities;
    for (const auto& q : p.quantities) quantities.emplace_back(q.name, q.unit);
    all.append(py::make_tuple(p.name, quantities, p.places, p.values));
  }
  return all;
}

void bind_arrays(Class& c) {
  const auto field = [](Field which) { return [which](Sim& s) { return s.field(which); }; };
  c.def_property(
      "x", field(Field::x),
      [](Sim& s, const Numbers& x) {
        const Sim::Change sim(s);
        write(sim->edit_fluid().x, x, sim->scene().dimension(), "x");
      },
      "Positions (n, D) [m]. Assign an array to move the particles.");
  c.def_property(
      "v", field(Field::v),
      [](Sim& s, const Numbers& v) {
        const Sim::Change sim(s);
        write(sim->edit_fluid().v, v, sim->scene().dimension(), "v");
      },
      "Velocities (n, D) [m/s]. Assign an array to set them.");
  c.def_property_readonly("density", field(Field::density),
                          "Of the last step (n,) [kg/m³]; initially the rest density.");
  c.def_property_readonly("pressure", field(Field::pressure), "Of the last step (n,) [Pa].");
  c.def_property_readonly("id", field(Field::id), "Ids (n,), which are never used again.");
  c.def_property_readonly("liquid", field(Field::liquid),
                          "Index of the liquid (n,); empty in scenes with one.");
  c.def(
      "frame", [](Sim& s) { return Sim::Access(s)->frame(); },
      "A copy of the fluid in the order of ids, as freshet.Frame.");
  c.def("__len__", [](Sim& s) { return Sim::Access(s)->fluid().size(); });
}

void bind_steps(Class& c) {
  c.def("step", &step, py::arg("n") = 1,
        "Takes n time steps, without the GIL. Ctrl-C ends them after the present step. Returns the "
        "number of steps.");
  c.def("_step_until", &step_until, py::arg("time"), py::arg("steps"), py::arg("seconds"));
  c.def_property_readonly(
      "time", [](Sim& s) { return Sim::Access(s)->time(); }, "Simulated time [s].");
  c.def_property_readonly(
      "steps", [](Sim& s) { return Sim::Access(s)->steps_done(); }, "Number of steps.");
  c.def_property_readonly(
      "finished", [](Sim& s) { return Sim::Access(s)->finished(); },
      "Whether time.end is reached.");
  c.def_property_readonly("threads", [](Sim& s) { return Sim::Access(s)->threads(); });
  c.def_property_readonly(
      "scene", [](Sim& s) { return Sim::Access(s)->scene(); },
      "The scene with its defaults, as freshet.CheckedScene.");
  c.def_property_readonly(
      "time_steps", [](Sim& s) { return Sim::Access(s)->time_steps(); },
      "The time steps so far, as freshet.TimeSteps.");
  c.def(
      "bounds", [](Sim& s) { return Sim::Access(s)->bounds(); },
      "What limits the next step, as freshet.TimeStepBounds.");
}

// Measurements may search for neighbours, which sorts the particles in place.
void bind_measurements(Class& c) {
  using Moment = Simulation::Moment;
  c.def(
      "moment", [](Sim& s) { return Sim::Access(s)->moment(); },
      "Where a mean over time begins, for wall_forces() and flows().");
  c.def(
      "wall_forces",
      [](Sim& s, const std::optional<Moment>& since) {
        const Sim::Change sim(s);
        return by_name(sim->scene().wall_names(), sim->wall_forces(since.value_or(Moment())));
      },
      py::arg("since") = py::none(),
      "The force of the fluid on each wall by name (D,) [N; N/m in 2D]. On walls of `reflection` "
      "it is the mean since a moment, or since the start.");
  c.def(
      "boundary_forces",
      [](Sim& s) {
        const Sim::Change sim(s);
        return boundary_dict(sim->boundary_forces(), sim->scene().dimension());
      },
      "The boundary particles: \"x\" (n, D) [m], \"force\" (n, D) [N; N/m in 2D], and \"part\", "
      "the index of the wall, or the number of walls plus the index of the body.");
  c.def(
      "flows",
      [](Sim& s, const std::optional<Moment>& since) {
        return Sim::Access(s)->flows(since.value_or(Moment()));
      },
      py::arg("since") = py::none(),
      "A list of freshet.Flow: inlets, outlets, counters, open sides.");
  c.def("_probes", [](Sim& s) { return probe_list(read_probes(*Sim::Change(s))); });
  c.def(
      "bodies",
      [](Sim& s) {
        const Sim::Access sim(s);
        py::dict all;
        std::size_t k = 0;
        for (const BodyState& body : sim->bodies())
          all[py::str(sim->scene().body_name(k++))] = body;
        return all;
      },
      "The state of each rigid body by name, as freshet.BodyState.");
  c.def(
      "solves", [](Sim& s) { return Sim::Access(s)->solves(); },
      "A list of freshet.Solve: iterations and errors of the implicit solves.");
  c.def(
      "statistics", [](Sim& s) { return Sim::Access(s)->statistics(); },
      "A summary of the fluid, as freshet.Statistics.");
  c.def_property_readonly(
      "warnings", [](Sim& s) { return Sim::Access(s)->warnings(); },
      "A list of freshet.Warning: those of the health monitor so far.");
}

void bind_interventions(Class& c) {
  c.def("set_force", &Sim::set_force, py::arg("force"),
        "Adds accelerations of the caller: force(fluid, time) returns an array (n, D) or (D,) "
        "[m/s²] in the order of fluid.x (freshet.FluidInStep). None removes the force. Checkpoints "
        "do not hold it.");
  c.def(
      "set_gravity", [](Sim& s, const Vector& g) { Sim::Access(s)->set_gravity(g); },
      py::arg("gravity"), "Changes gravity from the next step on (D,) [m/s²].");
  c.def(
      "_change", [](Sim& s, const std::vector<Override>& o) { Sim::Change(s)->change(o); },
      py::arg("overrides"));
  c.def(
      "_push_body",
      [](Sim& s, std::size_t body, const std::array<double, 3>& force,
         const std::array<double, 3>& torque) { Sim::Access(s)->push_body(body, force, torque); },
      py::arg("body"), py::arg("force"), py::arg("torque"));
  c.def(
      "add_particles",
      [](Sim& s, const Numbers& x, const std::optional<Numbers>& v, int liquid) {
        const Sim::Change sim(s);
        const int dimension = sim->scene().dimension();
        const auto places = vectors(x, dimension, "x");
        return sim->add_particles(places, v ? vectors(*v, dimension, "v") : std::span<const Real>(),
                                  liquid);
      },
      py::arg("x"), py::arg("v") = py::none(), py::arg("liquid") = 0,
      "Adds particles at rest density: positions (n, D) [m], velocities (n, D) [m/s]. Returns the "
      "id of the first; the others follow.");
  c.def(
      "remove_particles",
      [](Sim& s, const py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>& ids) {
        Sim::Change(s)->remove_particles({ids.data(), std::size_t(ids.size())});
      },
      py::arg("ids"), "Removes the particles with these ids.");
}

void bind_checkpoints(Class& c) {
  c.def(
      "checkpoint", [](Sim& s) { return Sim::Access(s)->checkpoint(); },
      "A copy of the complete state, as freshet.Checkpoint.");
  c.def(
      "restore", [](Sim& s, const Checkpoint& from) { Sim::Change(s)->restore(from); },
      py::arg("checkpoint"), "Resumes from a checkpoint of this scene, to the same bits.");
  c.def(
      "save", [](Sim& s, const std::filesystem::path& f) { save_checkpoint(*Sim::Access(s), f); },
      py::arg("file"), "Writes a checkpoint file (HDF5).");
  c.def(
      "load",
      [](Sim& s, const std::filesystem::path& f) { restore_checkpoint(*Sim::Change(s), f); },
      py::arg("file"), "Resumes from a checkpoint file of this scene, to the same bits.");
  c.def(
      "state_sha256", [](Sim& s) { return Sim::Access(s)->state_sha256(); },
      "The digest of step, ids, positions and velocities, as in report.json.");
  c.def(
      "kept_sha256", [](Sim& s) { return Sim::Access(s)->kept_sha256(); },
      "The digest of all fields that a restart needs, as in report.json.");
}

/// The simulation of a Python object; null before its constructor has run.
Sim* made(PyObject* self) {
  auto value = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder();
  return value.holder_constructed() ? value.value_ptr<Sim>() : nullptr;
}

/// Lets the garbage collector see the caller's force, which may refer to the simulation.
py::custom_type_setup collected() {
  return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
    PyTypeObject* type = &heap_type->ht_type;
    type->tp_flags |= Py_TPFLAGS_HAVE_GC;
    type->tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
      Py_VISIT(Py_TYPE(self));
      if (const Sim* sim = made(self)) Py_VISIT(sim->force.ptr());
      return 0;
    };
    type->tp_clear = [](PyObject* self) {
      if (Sim* sim = made(self)) sim->force = py::object();
      return 0;
    };
    type->tp_dealloc = [](PyObject* self) {  // pybind11 2.10 frees objects that are still tracked
      PyObject_GC_UnTrack(self);
      py::detail::pybind11_object_dealloc(self);
    };
  });
}

}  // namespace

void bind_simulation(py::module_& m) {
  py::class_<Simulation::Moment>(m, "Moment", "Where a mean over time begins.")
      .def_readonly("time", &Simulation::Moment::time, "[s].");
  m.def("instruction_set", &instruction_set, py::arg("isa") = "",
        "The instruction set that a simulation selects on this machine.");
  Class c(m, "SimulationBase", collected());
  c.def(py::init([](Scene scene, int threads, const std::string& isa) {
          if (threads < 0)
            throw py::value_error(
                py::str("threads must be >= 0, 0 for all cores; it is {}").format(threads));
          return std::make_unique<Sim>(std::move(scene), Execution{threads, isa});
        }),
        py::arg("scene"), py::arg("threads") = 0, py::arg("isa") = "");
  bind_arrays(c);
  bind_steps(c);
  bind_measurements(c);
  bind_interventions(c);
  bind_checkpoints(c);
}

}  // namespace freshet::python
