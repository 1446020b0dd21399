# SPDX-License-Identifier: MIT
"""Forces from Python and from expressions."""

import gc
import resource
import weakref

import numpy as np
import pytest
from small_scenes import column, sim

import freshet


def weightless(**more):
    return column(domain={"max": [1.0, 0.6], "gravity": [0.0, 0.0]}, walls={"method": "open"}, **more)


def mean_velocity(simulation):
    return simulation.v.mean(axis=0)


def test_a_vector_and_an_array_accelerate():
    simulation = sim(weightless())
    simulation.set_force(lambda fluid, time: (2.0, 1.0))
    simulation.step(100)
    assert np.allclose(mean_velocity(simulation), [0.1, 0.05], rtol=1e-3)
    simulation.set_force(lambda fluid, time: np.tile([-2.0, -1.0], (len(fluid), 1)))
    simulation.step(100)
    assert np.allclose(mean_velocity(simulation), 0, atol=1e-4)
    simulation.set_force(None)
    simulation.step(10)
    assert np.allclose(mean_velocity(simulation), 0, atol=1e-4)


def test_a_force_sees_the_fluid_in_one_order():
    simulation = sim()
    seen = {}

    def spring(fluid, time):
        seen.update(time=time, shapes=[a.shape for a in (fluid.x, fluid.v, fluid.density, fluid.id)])
        return 10 * (np.array([0.5, 0.3]) - fluid.x)

    simulation.set_force(spring)
    simulation.step(3)
    n = len(simulation)
    assert seen["shapes"] == [(n, 2), (n, 2), (n,), (n,)]
    assert seen["time"] == pytest.approx(0.001)


def test_an_expression_is_the_same_force():
    functions, python = sim(weightless()), sim(weightless())
    functions.set_body_force(["3*cos(20*t)", "x"])
    python.set_force(
        lambda fluid, time: np.stack(
            [np.full(len(fluid), 3 * np.cos(20 * time)), fluid.x[:, 0].astype(float)], axis=1
        )
    )
    for simulation in (functions, python):
        simulation.step(50)
    assert np.allclose(functions.frame().v, python.frame().v, atol=2e-5)
    functions.set_body_force(None)
    assert not any(key == "domain.body_force" and is_set for key, *_, is_set, _ in functions.scene.keys)


def test_errors_of_a_force_reach_the_caller():
    simulation = sim()

    def broken(fluid, time):
        raise ZeroDivisionError("in a force")

    simulation.set_force(broken)
    with pytest.raises(ZeroDivisionError, match="in a force"):
        simulation.step()
    simulation.set_force(lambda fluid, time: np.zeros(7))
    with pytest.raises(ValueError, match=r"a force must return .* \(104, 2\) or \(2,\).*\(7,\)"):
        simulation.step()
    simulation.set_force(lambda fluid, time: "no")
    with pytest.raises(ValueError, match="it returned 'no'"):
        simulation.step()


def test_a_force_cannot_reach_into_the_step():
    simulation = sim()
    kept = []
    simulation.set_force(lambda fluid, time: simulation.x)
    with pytest.raises(freshet.Error, match="within a step"):
        simulation.step()
    simulation.set_force(lambda fluid, time: kept.append(fluid))
    simulation.step()
    with pytest.raises(freshet.Error, match="a step that is over"):
        kept[0].x


def test_ten_thousand_calls_take_no_memory():
    scene = column(particles={"spacing": 0.1})
    simulation = sim(scene)
    simulation.set_force(lambda fluid, time: -0.1 * fluid.v * fluid.density[:, None])
    simulation.step(1000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    simulation.step(10_000)
    for _ in range(10_000):
        simulation.x
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 2048  # KiB


def test_a_force_that_refers_to_its_simulation_is_collected():
    simulation = sim()
    simulation.set_force(lambda fluid, time, s=simulation: None)
    simulation.step()
    gone = weakref.ref(simulation)
    del simulation
    gc.collect()
    assert gone() is None
