#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Heave of a floating box in a closed tank by linear potential flow: writes heave.csv.

Laplace's equation by bilinear finite elements in the water at rest; on its surface phi_t = -g eta and eta_t =
phi_y, on the keel phi_y = w, on the other walls no flow through them. With b the keel's load and K the elements'
matrix without the surface's nodes, the added mass is rho b' K^-1 b, and

  (m + m_a) dw/dt = -rho g B z - rho g b' K^-1 K_surface eta,   dz/dt = w.

Steps of the classical Runge-Kutta method. Needs NumPy and SciPy.

  cd validation/heave; ./heave.py > heave.csv
"""
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as la

GRAVITY, WIDTH, DEPTH = 9.81, 1.2, 0.5
LEFT, RIGHT, DRAFT, FIRST_DRAFT = 0.4, 0.8, 0.1, 0.08


def solve(h, end=4.0, dt=0.002):
    beam = RIGHT - LEFT
    # Let go with less draft in water 0.5 m deep; all is counted from where box and water come to rest.
    fall = beam * (FIRST_DRAFT - DRAFT) / WIDTH
    depth = DEPTH - fall
    nx, keel = round(WIDTH / h), round((depth - DRAFT) / h)
    ny = keel + round(DRAFT / h)
    height = np.array([(depth - DRAFT) / keel if j < keel else h for j in range(ny)])
    left, right = round(LEFT / h), round(RIGHT / h)

    number = np.full((nx + 1, ny + 1), -1)
    wet = [(i, j) for i in range(nx) for j in range(ny) if not (left <= i < right and j >= keel)]
    for i, j in wet:
        number[i:i + 2, j:j + 2] = 0
    nodes = np.argwhere(number == 0)
    number[tuple(nodes.T)] = np.arange(len(nodes))
    along = np.array([[2, -2, -1, 1], [-2, 2, 1, -1], [-1, 1, 2, -2], [1, -1, -2, 2]]) / 6
    across = np.array([[2, 1, -1, -2], [1, 2, -2, -1], [-1, -2, 2, 1], [-2, -1, 1, 2]]) / 6
    ratio = np.array([height[j] / h for _, j in wet])[:, None, None]
    elements = along * ratio + across / ratio
    corners = np.array([[number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]] for i, j in wet])
    rows = np.repeat(corners, 4, axis=1).ravel()
    columns = np.tile(corners, (1, 4)).ravel()
    matrix = sp.csr_matrix((elements.ravel(), (rows, columns)))

    surface = np.concatenate([number[: left + 1, ny], number[right:, ny]])
    inside = np.setdiff1d(np.arange(len(nodes)), surface)
    share = np.full(len(surface), h)
    share[[0, left, left + 1, -1]] = h / 2
    load = np.zeros(len(nodes))
    load[number[left:right + 1, keel]] = h
    load[number[[left, right], keel]] = h / 2
    load = load[inside]
    lu = la.splu(matrix[inside][:, inside].tocsc())
    of_surface = matrix[inside][:, surface]
    by_keel = lu.solve(load)
    added = load @ by_keel  # over rho
    mass = beam * DRAFT
    flux_by_keel = (of_surface.T @ by_keel) / share
    surfaces = matrix[surface][:, surface].toarray() - of_surface.T @ lu.solve(of_surface.toarray())
    dirichlet = surfaces / share[:, None]
    push = -(of_surface.T @ by_keel)  # the keel's force by phi of the surface

    def rates(state):
        z, w, eta, phi = state[0], state[1], state[2:2 + len(surface)], state[2 + len(surface):]
        dw = (-GRAVITY * beam * z + GRAVITY * (push @ eta)) / (mass + added)
        return np.concatenate([[w, dw], dirichlet @ phi + flux_by_keel * w, -GRAVITY * eta])

    z0 = (DRAFT - FIRST_DRAFT) + fall
    state = np.concatenate([[z0, 0.0], np.full(len(surface), fall), np.zeros(len(surface))])
    out = [(0.0, state[0])]
    for k in range(round(end / dt)):
        k1 = rates(state)
        k2 = rates(state + dt / 2 * k1)
        k3 = rates(state + dt / 2 * k2)
        k4 = rates(state + dt * k3)
        state = state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        if (k + 1) % 10 == 0:
            out.append(((k + 1) * dt, state[0]))
    rest = depth - DRAFT + 0.1  # of the centre of the box, which is 0.2 m high
    return added / mass, np.array(out) + [0.0, rest]


if __name__ == "__main__":
    coarse, _ = solve(0.02)
    medium, curve2 = solve(0.01)
    added, curve = solve(0.005)
    print("# Heave of a box (beam 0.4 m, draft 0.1 m) in a tank 1.2 m wide with water 0.5 m deep, let go at a draft of 0.08 m")
    print("# Linear potential flow, heave.py, elements of 5 mm: added mass without waves over the box's mass"
          f" {coarse:.4f}, {medium:.4f}, {added:.4f} for elements of 20, 10 and 5 mm;")
    print(f"# elements of 10 mm differ by {np.abs(curve - curve2)[:, 1].max() * 1000:.2f} mm at most")
    print("t,y")
    for t, y in curve:
        print(f"{t:.3f},{y:.6f}")
