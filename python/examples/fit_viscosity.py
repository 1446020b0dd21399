# SPDX-License-Identifier: MIT
"""Finds the viscosity at which a column spreads as far as wanted, by scipy.

The front of a collapsing column after 0.2 s depends on the viscosity of the liquid. scipy.optimize
finds the viscosity from the front, as one would from a measurement.
"""

import math

from scipy.optimize import brentq

import freshet

SHEET = {
    "domain": {"max": [1.0, 0.4]},
    "particles": {"spacing": 0.02},
    "fluid": {"min": [0.0, 0.0], "max": [0.2, 0.3]},
    "solver": {"name": "dfsph", "viscosity_method": "weiler2018"},
    "time": {"end": 0.2, "step": "adaptive", "step_max": 0.002},
}


def front(viscosity):
    """The front [m] after 0.2 s with a viscosity [Pa s]."""
    sim = freshet.Simulation(SHEET, set={"fluid.viscosity": viscosity}, threads=1)
    sim.run()
    return sim.x[:, 0].max()


def main(wanted=0.3):
    exponent = brentq(lambda e: front(10**e) - wanted, 0, 3, xtol=0.02)
    viscosity = 10**exponent
    print(f"the front is at {wanted} m with {viscosity:.1f} Pa s: {front(viscosity):.4f} m")
    return viscosity, math.fabs(front(viscosity) - wanted)


if __name__ == "__main__":
    main()
