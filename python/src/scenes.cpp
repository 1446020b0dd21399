// SPDX-License-Identifier: MIT
#include <freshet/derived.h>
#include <freshet/scene.h>
#include <freshet/scene_keys.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/src/arrays.h"
#include "python/src/bindings.h"

namespace freshet::python {
namespace {

py::dict derived_numbers(const Scene& scene) {
  const Derived d = derive(scene);
  using namespace py::literals;
  return py::dict("particles"_a = d.particles, "most_particles"_a = d.most_particles,
                  "boundary_particles"_a = d.wall_particles, "excluded"_a = d.left_out,
                  "spacing"_a = d.spacing, "support_radius"_a = d.support_radius, "mass"_a = d.mass,
                  "rest_density"_a = d.rest_density, "neighbors"_a = d.neighbors,
                  "sound_speed"_a = d.sound_speed, "stiffness"_a = d.stiffness,
                  "fastest"_a = d.fastest, "step_bound"_a = d.step_bound(),
                  "step_bound_name"_a = d.step_bound_name(), "density_error"_a = d.density_error,
                  "gradient_error"_a = d.gradient_error);
}

py::list keys_list(const Scene& scene) {
  py::list all;
  for (const SceneKey& key : keys_of(scene))
    all.append(py::make_tuple(key.path, key.value, key.unit, key.text, key.is_set, key.live));
  return all;
}

}  // namespace

void bind_scenes(py::module_& m) {
  py::class_<Scene>(m, "CheckedScene", "A scene that was parsed and checked.")
      .def_readonly("title", &Scene::title)
      .def_readonly("description", &Scene::description)
      .def_readonly("source", &Scene::source, "The TOML text, with overrides.")
      .def_property_readonly("dimension", &Scene::dimension, "2 or 3.")
      .def_property_readonly("solver", [](const Scene& s) { return s.method().name; })
      .def_property_readonly("spacing", [](const Scene& s) { return s.particles.spacing; })
      .def_property_readonly("end", [](const Scene& s) { return s.time.end; })
      .def_property_readonly("domain",
                             [](const Scene& s) {
                               const Vector origin(s.domain.max.size(), 0);
                               const Vector& min = s.domain.min.empty() ? origin : s.domain.min;
                               return py::make_tuple(array_of(min), array_of(s.domain.max));
                             })
      .def_property_readonly("rest_densities",
                             [](const Scene& s) {
                               std::vector<double> all;
                               for (const Scene::Liquid& l : s.liquids())
                                 all.push_back(l.rest_density);
                               return all;
                             })
      .def_property_readonly("derived", &derived_numbers)
      .def_property_readonly("keys", &keys_list)
      .def_property_readonly("warnings",
                             [](const Scene& s) { return diagnostics_list(scene_warnings(s)); });
  m.def("load_scene", &load_scene, py::arg("file"), py::arg("overrides"));
  m.def("parse_scene", &parse_scene, py::arg("text"), py::arg("name"), py::arg("overrides"));
  m.def("may_change_while_running", &may_change_while_running, py::arg("key"),
        "Whether Simulation.change accepts a key.");
}

}  // namespace freshet::python
