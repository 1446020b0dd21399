// SPDX-License-Identifier: MIT
#include <freshet/plot.h>
#include <freshet/run.h>
#include <freshet/scene_documents.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>

#include "python/src/bindings.h"

namespace freshet::python {
namespace {

/// Calls a Python function after a step, at most every 50 ms, and handles signals.
class AfterSteps {
 public:
  explicit AfterSteps(py::object progress) : progress_(std::move(progress)) {}
  bool operator()(const Simulation& sim) {
    const auto now = Clock::now();
    if (now < next_ && !sim.finished()) return true;
    next_ = now + std::chrono::milliseconds(50);
    const py::gil_scoped_acquire acquire;
    interrupted = PyErr_CheckSignals() != 0;
    if (interrupted) PyErr_Clear();  // the run writes its files; KeyboardInterrupt follows
    if (!interrupted && !progress_.is_none()) progress_(sim.time(), sim.steps_done());
    return !interrupted;
  }
  bool interrupted = false;

 private:
  using Clock = std::chrono::steady_clock;
  py::object progress_;
  Clock::time_point next_{};
};

std::string run_scene(const Scene& scene, const RunOptions& set, py::object progress) {
  AfterSteps after(std::move(progress));
  RunOptions options = set;
  options.after_step = [&after](const Simulation& sim, double) { return after(sim); };
  Report report;
  {
    const py::gil_scoped_release release;
    report = run(scene, options);
  }
  if (after.interrupted) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  return to_json(report);
}

}  // namespace

void bind_runs(py::module_& m) {
  m.def(
      "run",
      [](const Scene& scene, const std::filesystem::path& output, bool overwrite,
         const std::string& name, int threads, const std::string& isa,
         const std::optional<std::filesystem::path>& video, double fps, double speed,
         py::object progress) {
        RunOptions options;
        options.output = output;
        options.overwrite = overwrite;
        options.scene_name = name;
        options.command = {"freshet.run", name};
        options.execution = {threads, isa};
        if (video) options.video = VideoOptions{*video, fps, speed};
        return run_scene(scene, options, std::move(progress));
      },
      py::arg("scene"), py::arg("output"), py::arg("overwrite"), py::arg("name"),
      py::arg("threads"), py::arg("isa"), py::arg("video"), py::arg("fps"), py::arg("speed"),
      py::arg("progress"));
  m.def(
      "plot",
      [](const std::filesystem::path& run, const std::vector<std::string>& columns,
         const std::filesystem::path& output, const std::vector<std::filesystem::path>& against) {
        return plot({run, columns, output, against});
      },
      py::arg("run"), py::arg("columns"), py::arg("output"), py::arg("against"));
  m.def("scene_schema", &scene_schema, "The JSON Schema of scenes.");
}

}  // namespace freshet::python
