# SPDX-License-Identifier: MIT
"""Arrays of the fluid: no copy, read-only, and never of freed memory."""

import gc

import numpy as np
import pytest
from small_scenes import column, filling, sim

FIELDS = ("x", "v", "density", "pressure", "id")


def test_a_view_is_the_memory_of_the_simulation():
    simulation = sim()
    first, second = simulation.x, simulation.x
    assert first.ctypes.data == second.ctypes.data
    assert simulation.x.shape == (104, 2) and simulation.density.shape == (104,)
    assert simulation.x.dtype == np.float32 and simulation.id.dtype == np.uint64
    for field in FIELDS:
        view = getattr(simulation, field)
        assert not view.flags.writeable and not view.flags.owndata
        with pytest.raises(ValueError, match="read-only"):
            view[0] = 0
        with pytest.raises(ValueError):
            view.setflags(write=True)


def test_stepping_without_views_moves_no_memory():
    simulation = sim()
    at = simulation.x.ctypes.data
    simulation.step(50)
    assert simulation.x.ctypes.data == at


def test_views_keep_their_values_while_the_simulation_goes_on():
    simulation, alone = sim(filling()), sim(filling())
    kept = []
    for _ in range(300):
        for field in FIELDS:
            view = getattr(simulation, field)
            kept.append((view, view[::2], memoryview(view), view.copy()))
        simulation.step(2)
    alone.step(600)
    assert len(simulation) > len(kept[0][0])  # the memory has grown
    for view, half, raw, values in kept:
        assert (view == values).all() and (half == values[::2]).all()
        assert (np.asarray(raw) == values).all()
    assert simulation.state_sha256() == alone.state_sha256()


CHANGES = {
    "step": lambda s: s.step(),
    "write": lambda s: setattr(s, "x", np.asarray(s.x) + np.float32(0.01)),
    "add": lambda s: s.add_particles(np.random.default_rng(1).uniform(0.4, 0.5, (500, 2))),
    "remove": lambda s: s.remove_particles(s.id[:20]),
    "change": lambda s: s.change({"domain.gravity": [0.0, 0.0]}),
    "restore": lambda s: s.restore(s.checkpoint()),
    "forces": lambda s: s.wall_forces(),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_slice_outlives(name):
    simulation = sim()
    simulation.step(3)
    slices = {field: getattr(simulation, field)[10:20] for field in FIELDS}
    values = {field: s.copy() for field, s in slices.items()}
    CHANGES[name](simulation)
    simulation.step(5)
    for field in FIELDS:
        assert (slices[field] == values[field]).all()


def test_a_view_outlives_its_simulation():
    simulation = sim()
    x = simulation.x[5:]
    values = x.copy()
    del simulation
    gc.collect()
    others = [sim() for _ in range(3)]  # reuse freed memory, if any was
    for other in others:
        other.step(3)
    assert (x == values).all()


def test_copies_where_the_memory_has_other_numbers():
    """Density of several liquids, and positions far from 0."""
    fluids = [
        {"min": [0.0, 0.0], "max": [0.4, 0.3]},
        {"min": [0.4, 0.0], "max": [1.0, 0.3], "rest_density": 500.0},
    ]
    two = sim(column(fluid=fluids))
    density, values = two.density, two.density.copy()
    two.step(3)
    assert set(np.unique(two.liquid)) == {0, 1}
    assert (density == values).all()
    far = column(domain={"min": [1000.0, 0.0], "max": [1001.0, 0.6]})
    far["fluid"] = {"min": [1000.0, 0.0], "max": [1000.3, 0.5]}
    simulation = sim(far)
    x, values = simulation.x, simulation.x.copy()
    simulation.step(20)
    assert (x == values).all() and x[:, 0].min() >= 1000
