# SPDX-License-Identifier: MIT
"""The front of a dam break against the experiment of Martin and Moyce (1952).

A column of water, a = 0.05715 m wide and 2a high, collapses. The front x is compared as Z = x/a over
T = t √(2g/a). The gate of the experiment takes time to open, so the curves are aligned at Z = 1.44.
"""

import numpy as np

import freshet

CASE = freshet.data_folder("validation") / "dam_break_front"
A, G = 0.05715, 9.81


def simulated(until=0.16):
    """T and Z of the simulation."""
    sim = freshet.Simulation(
        CASE / "scene.toml",
        set={
            "solver.name": "dfsph",
            "solver.kernel": "wendland_c2",
            "particles.support_radius": 3 * 0.0028575,
        },
    )
    front = []
    sim.run(until, every=0.002, callback=lambda s: front.append((s.time, s.probes()["front"]["distance"][0])))
    time, x = np.transpose(front)
    return time * np.sqrt(2 * G / A), x / A


def aligned(T, Z, at=1.44):
    """T less the time at which the front passes Z = at."""
    first = np.argmax(Z >= at)
    share = (at - Z[first - 1]) / (Z[first] - Z[first - 1])
    return T - (T[first - 1] + share * (T[first] - T[first - 1]))


def main():
    measured = freshet.read_table(CASE / "martin_moyce.csv")
    T, Z = simulated()
    since = aligned(T, Z)
    experiment = aligned(measured["T"], measured["Z"])
    compared = (experiment >= 0) & (experiment <= 1.3)
    difference = np.interp(experiment[compared], since, Z) - measured["Z"][compared]
    rms = np.sqrt(np.mean(difference**2) / np.mean(measured["Z"][compared] ** 2))
    for t, z, d in zip(experiment[compared], measured["Z"][compared], difference):
        print(f"T = {t:5.2f}   Z = {z:5.2f}   simulated {z + d:5.2f}")
    print(f"difference {100 * rms:.1f} % (root mean square)")
    return rms


if __name__ == "__main__":
    main()
