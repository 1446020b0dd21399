# SPDX-License-Identifier: MIT
"""A controller steers a floating box: it holds the box at x = 0.7 m.

Every 5 ms a PD controller reads the box and pulls it: F = k (x_wanted − x) − d v.
"""

import freshet

BASIN = {
    "domain": {"max": [1.2, 0.6]},
    "particles": {"spacing": 0.03},
    "fluid": {"min": [0.0, 0.0], "max": [1.2, 0.3]},
    "body": {"name": "box", "motion": "free", "density": 500.0, "min": [0.3, 0.3], "max": [0.48, 0.42]},
    "solver": {"name": "wcsph", "sound_speed": 20.0},
    "time": {"end": 2.0, "step": 0.0005},
}
WANTED = 0.7  # m
STIFFNESS, DAMPING = 600.0, 150.0  # N/m and N s/m, per metre of depth


def control(sim):
    """Pulls the box towards its place, and prints where it is."""
    box = sim.bodies()["box"]
    sim.push_body("box", [STIFFNESS * (WANTED - box.position[0]) - DAMPING * box.velocity[0], 0.0])


def main():
    sim = freshet.Simulation(BASIN)
    sim.run(every=0.005, callback=control)
    x = sim.bodies()["box"].position[0]
    print(f"the box is at x = {x:.3f} m after {sim.time:.1f} s; wanted {WANTED} m")
    return x


if __name__ == "__main__":
    main()
