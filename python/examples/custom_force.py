# SPDX-License-Identifier: MIT
"""A force in Python: an attractor moves in a circle and pulls at weightless water."""

import numpy as np

import freshet

POND = freshet.Scene(
    domain=freshet.Domain(max=[1.0, 1.0], gravity=[0.0, 0.0]),
    particles=freshet.Particles(spacing=0.025),
    fluid=freshet.Fluid(shape="sphere", center=[0.5, 0.5], radius=0.2),
    solver=freshet.Solver(name="wcsph", sound_speed=20.0),
    time=freshet.Time(end=0.2, step=0.0005),
)


def attractor(fluid, time):
    """Accelerations [m/s²] towards a point that moves."""
    center = [0.5 + 0.3 * np.cos(5 * time), 0.5 + 0.3 * np.sin(5 * time)]
    return 10 * (center - fluid.x)


def main():
    sim = freshet.Simulation(POND)
    sim.set_force(attractor)
    sim.run()
    momentum = sim.statistics().momentum
    print(f"momentum after {sim.time:.1f} s: ({momentum[0]:.2f}, {momentum[1]:.2f}) (kg m/s)/m")
    return momentum


if __name__ == "__main__":
    main()
