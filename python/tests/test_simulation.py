# SPDX-License-Identifier: MIT
"""Stepping, state, interventions, checkpoints."""

import gc
import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from small_scenes import column, filling, floating, sim

import freshet


def test_the_digest_is_that_of_the_command(tmp_path):
    file = tmp_path / "column.toml"
    file.write_text(freshet.to_toml(column(time={"end": 0.05, "step": 0.0005})))
    program = os.environ["FRESHET_PROGRAM"]
    out = tmp_path / "run"
    subprocess.run([program, "run", file, "--output", out, "--quiet", "--threads", "2"], check=True)
    report = json.loads((out / "report.json").read_text())
    simulation = sim(file)
    simulation.run()
    assert simulation.steps == report["steps"] == 100
    assert simulation.state_sha256() == report["state_sha256"]
    assert simulation.kept_sha256() == report["kept_sha256"]


def test_two_threads_step_two_simulations():
    alone = sim()
    alone.step(200)
    others = [sim(), sim()]
    threads = [threading.Thread(target=s.step, args=(200,)) for s in others]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [s.state_sha256() for s in others] == [alone.state_sha256()] * 2


def test_the_gil_is_free_while_stepping():
    simulation = sim(column(particles={"spacing": 0.01}))
    thread = threading.Thread(target=simulation.step, args=(100,))
    thread.start()
    ticks = 0
    while thread.is_alive():
        ticks += 1
        time.sleep(0.001)
    assert ticks > 5


def test_threads_share_one_simulation():
    simulation = sim()
    seen = []

    def read():
        for _ in range(50):
            x = simulation.x
            seen.append(np.isfinite(x).all() and len(x) == len(simulation))

    threads = [threading.Thread(target=read) for _ in range(3)]
    for thread in threads:
        thread.start()
    for _ in range(100):
        simulation.step()
    for thread in threads:
        thread.join()
    assert len(seen) == 150 and all(seen)


@pytest.mark.parametrize("call", [lambda s: s.step(10**9), lambda s: s.run(until=1e9)])
def test_ctrl_c_ends_steps_and_leaves_a_whole_state(call):
    simulation = sim()
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call(simulation)
    assert time.monotonic() - begin < 30
    again = sim()
    again.step(simulation.steps)
    assert again.state_sha256() == simulation.state_sha256()


def test_ctrl_c_ends_the_wait_for_another_thread():
    simulation, begun = sim(), threading.Event()

    def stay(fluid, when):
        begun.set()
        time.sleep(3)
        return np.zeros_like(fluid.x)

    simulation.set_force(stay)
    thread = threading.Thread(target=simulation.step)
    thread.start()
    begun.wait()
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        simulation.statistics()
    assert time.monotonic() - begin < 2.5
    thread.join()


def test_arguments_are_checked_at_once():
    simulation = sim()
    with pytest.raises(ValueError, match="n must be >= 0; it is -1"):
        simulation.step(-1)
    with pytest.raises(TypeError, match="a force must be a function"):
        simulation.set_force(3)
    with pytest.raises(ValueError, match="threads must be >= 0"):
        freshet.Simulation("dam_break_2d", threads=-1)


def test_an_array_outlives_its_simulation():
    simulation = sim()
    x, before = simulation.x, simulation.x.copy()
    del simulation
    gc.collect()
    assert (x == before).all()


def test_run_calls_back_at_times_and_steps():
    simulation = sim()
    times, steps = [], []
    simulation.run(until=0.1, every=0.025, callback=lambda s: times.append(s.time))
    assert np.allclose(times, [0, 0.025, 0.05, 0.075, 0.1], atol=1e-9)
    simulation.run(until=0.105, every=4, callback=lambda s: steps.append(s.steps))
    assert steps == [200, 204, 208, 210]
    assert simulation.run(until=1.0, every=1, callback=lambda s: s.steps < 215).steps == 215
    with pytest.raises(ValueError, match="every is 0"):
        simulation.run(every=0)
    with pytest.raises(ValueError, match="until is NaN"):
        simulation.run(until=float("nan"))


def test_a_false_of_numpy_ends_a_run():
    simulation = sim()
    simulation.run(until=0.5, every=1, callback=lambda s: s.x[:, 0].max() < 0.35)
    assert 0.35 <= simulation.x[:, 0].max() < 0.36 and simulation.time < 0.3


def test_run_shows_progress_by_tqdm(capsys):
    pytest.importorskip("tqdm", reason="tqdm is not installed")
    sim().run(until=0.01, progress=True)
    assert "100 %" in capsys.readouterr().err
    sim().run(until=float("inf"), every=20, callback=lambda s: s.steps < 20, progress=True)
    assert "0.01 s" in capsys.readouterr().err


@pytest.mark.parametrize("terminal", [True, False])
def test_run_shows_progress_on_a_terminal_without_tqdm(terminal, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal)
    sim().run(until=0.01, progress=True)
    assert ("100 %  0.01 of 0.01 s" in capsys.readouterr().err) == terminal


def test_checkpoints_resume_to_the_same_bits(tmp_path):
    simulation = sim(filling())
    simulation.step(100)
    kept = simulation.checkpoint()
    simulation.save(tmp_path / "state.h5")
    simulation.step(100)
    end = simulation.state_sha256()
    simulation.restore(kept)
    assert simulation.steps == kept.steps == 100
    simulation.step(100)
    assert simulation.state_sha256() == end
    other = sim(filling())
    other.load(tmp_path / "state.h5")
    other.step(100)
    assert other.state_sha256() == end
    with pytest.raises(freshet.Error, match="not of this scene"):
        sim().restore(kept)


def test_bodies_walls_flows_and_solves():
    simulation = sim(floating())
    simulation.step(50)
    box = simulation.bodies()["box"]
    assert box.position.shape == (3,) and box.orientation.shape == (4,)
    forces = simulation.wall_forces()
    assert set(forces) == {"x_min", "x_max", "y_min", "y_max"}
    # The floor carries the weight of the water and the box, within the pressure waves of the start.
    weight = 9.81 * 1000 * 0.3
    assert -2.5 * weight < forces["y_min"][1] < -0.3 * weight
    boundary = simulation.boundary_forces()
    floor = boundary["part"] == list(forces).index("y_min")
    assert np.allclose(boundary["force"][floor].sum(axis=0), forces["y_min"], rtol=1e-6)

    tank = sim(filling())
    since = tank.moment()
    tank.step(200)
    inlet = tank.flows(since)[0]
    assert inlet.kind == "inlet" and inlet.particles > 0
    assert inlet.rate == pytest.approx(inlet.volume / tank.time)

    pressure = sim(column(solver={"name": "dfsph"}))
    pressure.step(5)
    solves = {s.name: s for s in pressure.solves()}
    assert solves["density"].solves == 5 and solves["density"].last_iterations >= 1
    assert pressure.statistics().particles == len(pressure)


def test_probes_have_the_values_of_the_run(tmp_path):
    probe = [
        {"kind": "line", "name": "line", "from": [0.05, 0.1], "to": [0.25, 0.1], "count": 3},
        {"kind": "surface", "name": "front", "from": [0.0, 0.02], "to": [1.0, 0.02]},
    ]
    scene = column(probe=probe, time={"end": 0.02, "step": 0.0005})
    run = freshet.run(scene, tmp_path / "run", threads=1)
    simulation = sim(scene)
    simulation.run()
    probes = simulation.probes()
    assert probes["line"].places.shape == (3, 2)
    assert probes["line"].units["pressure"] == "Pa"
    last = run.probes["line"].where(slice(-3, None))
    assert np.allclose(probes["line"]["pressure"], last["pressure"], rtol=1e-8)
    assert np.allclose(probes["front"]["distance"], run.probes["front"]["distance"][-1], rtol=1e-8)


def test_a_pulled_body_moves():
    simulation = sim(floating())
    simulation.push_body("box", [400.0, 0.0], torque=1.0)
    simulation.step(100)
    assert simulation.bodies()["box"].velocity[0] > 0.1
    with pytest.raises(freshet.Error, match="no body is named 'bx'; bodies: box"):
        simulation.push_body("bx", [0.0, 0.0])


def test_particles_are_added_and_removed():
    simulation = sim()
    n = len(simulation)
    first = simulation.add_particles([[0.7, 0.1], [0.8, 0.1]], v=[[0, 1], [0, 2]])
    assert first == n and len(simulation) == n + 2
    assert simulation.v[simulation.id == n + 1].tolist() == [[0, 2]]
    simulation.step(10)
    simulation.remove_particles([first, 0])
    assert len(simulation) == n and not np.isin([first, 0], simulation.id).any()
    simulation.step(10)
    with pytest.raises(freshet.Error, match="ids belong to particles"):
        simulation.remove_particles([first])
    with pytest.raises(TypeError, match=r"not bool; for a mask use sim.id\[mask\]"):
        simulation.remove_particles(simulation.id < 2)
    with pytest.raises(TypeError, match="not float64"):
        simulation.remove_particles([1.7])
    simulation.remove_particles([])
    assert len(simulation) == n
    with pytest.raises(ValueError, match=r"x must have the shape \(n, 2\)"):
        simulation.add_particles([1.0, 2.0])


def test_positions_and_velocities_are_written():
    simulation = sim()
    simulation.step(5)
    simulation.v = np.zeros_like(simulation.v)
    assert simulation.statistics().speed_max == 0
    simulation.x = simulation.x + np.float32([0.1, 0])
    assert simulation.x[:, 0].min() == pytest.approx(0.12, abs=0.01)
    simulation.step(5)
    with pytest.raises(ValueError, match="x must have one row for each of the 104 particles; it has 2"):
        simulation.x = [[0, 0], [1, 1]]
    with pytest.raises(ValueError, match="NaN"):
        simulation.v = np.full_like(simulation.v, np.nan)


def test_keys_change_while_running():
    simulation = sim()
    simulation.step(10)
    simulation.change({"domain.gravity": [0.0, 0.0], "solver.artificial_viscosity": 0.2})
    simulation.set_gravity([0.0, -1.0])
    simulation.step(10)
    assert freshet.may_change_while_running("fluid[0].viscosity")
    with pytest.raises(freshet.Error, match="cannot change while the simulation runs"):
        simulation.change({"particles.spacing": 0.1})


def test_frames_have_the_order_of_ids():
    simulation = sim()
    simulation.step(50)
    frame = simulation.frame()
    assert (np.diff(frame.id.astype(int)) > 0).all() and len(frame) == len(simulation)
    assert (frame.x == simulation.x[np.argsort(simulation.id)]).all()
    assert frame.time == simulation.time and not frame.x.flags.writeable
    x = frame.x
    del frame
    assert np.isfinite(x).all()


def test_a_failed_step_names_the_particle():
    simulation = sim(column(time={"end": 1.0, "step": 0.05}, checks={"when_wrong": "stop"}))
    with pytest.raises(freshet.Error) as caught:
        simulation.step(100)
    assert caught.value.kind == "run"
    assert len(simulation.x) == len(simulation)


def test_values_have_a_repr():
    simulation = sim(floating(), set={"title": "A box"})
    assert repr(simulation.scene) == "<freshet.CheckedScene 'A box': wcsph, 2D, spacing 0.04 m>"
    assert repr(simulation.checkpoint()) == "Checkpoint(steps=0, time=0)"
    assert "position=[0.5, 0.4, 0]" in repr(simulation.bodies()["box"])
    values = (simulation.statistics(), simulation.time_steps, simulation.bounds(), simulation.moment())
    for value in values:
        assert repr(value).startswith(type(value).__name__ + "(") and " object at " not in repr(value)


def test_help_reads_well():
    import pydoc

    text = pydoc.plain(pydoc.render_doc(freshet.Simulation))
    for words in ("A simulation in memory", "until: ", "Positions (n, D) [m]", "set_force"):
        assert words in text
