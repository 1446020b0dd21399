// SPDX-License-Identifier: MIT
#include <freshet/run_frames.h>
#include <pybind11/stl/filesystem.h>

#include "python/src/arrays.h"
#include "python/src/bindings.h"

namespace freshet::python {
namespace {

/// A property that is an array over a member of a frame.
template <class T> auto array_of_frame(std::vector<T> Frame::*member, bool vectors) {
  return [member, vectors](const py::object& self) {
    const auto& frame = self.cast<const Frame&>();
    return array_over(std::span<const T>(frame.*member), vectors ? frame.dimension : 0, self);
  };
}

py::array triple(const std::array<double, 3>& numbers) {
  return array_of(std::span<const double>(numbers));
}

void bind_bodies(py::module_& m) {
  py::class_<BodyState>(m, "BodyState",
                        "A rigid body at one time, in three dimensions also in 2D scenes.")
      .def_property_readonly(
          "position", [](const BodyState& b) { return triple(b.position); }, "Centre of mass [m].")
      .def_property_readonly(
          "orientation",
          [](const BodyState& b) { return array_of(std::span<const double>(b.orientation)); },
          "Unit quaternion x, y, z, w.")
      .def_property_readonly(
          "velocity", [](const BodyState& b) { return triple(b.velocity); },
          "Of the centre of mass [m/s].")
      .def_property_readonly(
          "angular_velocity", [](const BodyState& b) { return triple(b.angular_velocity); },
          "[rad/s].")
      .def_property_readonly(
          "force", [](const BodyState& b) { return triple(b.force); },
          "Of the fluid over the last step [N; N/m in 2D].")
      .def_property_readonly(
          "torque", [](const BodyState& b) { return triple(b.torque); },
          "Of the fluid over the last step, about the centre of mass [N m; N m/m in 2D].");
}

}  // namespace

void bind_frames(py::module_& m) {
  bind_bodies(m);
  py::class_<Frame>(m, "Frame",
                    "The fluid at one time, in the order of ids. Arrays are read-only, 32-bit "
                    "floats, and stay valid.")
      .def_readonly("dimension", &Frame::dimension, "2 or 3.")
      .def_readonly("step", &Frame::step, "Number of the step.")
      .def_readonly("time", &Frame::time, "Simulated time [s].")
      .def_property_readonly("id", array_of_frame(&Frame::id, false), "Ids, ascending.")
      .def_property_readonly("x", array_of_frame(&Frame::x, true), "Positions (n, D) [m].")
      .def_property_readonly("v", array_of_frame(&Frame::v, true), "Velocities (n, D) [m/s].")
      .def_property_readonly("density", array_of_frame(&Frame::density, false), "[kg/m³].")
      .def_property_readonly("pressure", array_of_frame(&Frame::pressure, false), "[Pa].")
      .def_property_readonly("liquid", array_of_frame(&Frame::liquid, false),
                             "Index of the liquid; empty in scenes with one.")
      .def_property_readonly("bodies",
                             [](const py::object& self) {
                               py::list all;
                               for (const BodyState& body : self.cast<const Frame&>().bodies)
                                 all.append(py::cast(body));
                               return all;
                             })
      .def("__len__", &Frame::size)
      .def("__repr__", [](const Frame& f) {
        return py::str("<freshet.Frame: {} particles, step {}, {:.6g} s>")
            .format(f.size(), f.step, f.time);
      });
  py::class_<RunFrames>(m, "RunFrames")
      .def(py::init<std::filesystem::path>())
      .def_property_readonly("scene", [](const RunFrames& r) { return r.scene(); })
      .def("__len__", &RunFrames::size)
      .def("file", &RunFrames::file)
      .def("read", &RunFrames::read, py::call_guard<py::gil_scoped_release>());
}

}  // namespace freshet::python
