#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Extrema of the velocity on the middles of the lid-driven cavity, without Ghia's discretization error.

Steady streamfunction psi and vorticity w on a grid of n x n cells: central differences, Thom's condition
w = 2 (psi_wall - psi_next - U h)/h^2 on walls, Newton's method. Extrema are those of a parabola through the
three nodes about the greatest one. Their errors fall as h^2, and Richardson's extrapolation from the two
finest grids takes that part away. Needs NumPy and SciPy.

  validation/lid_driven_cavity/extrema.py [RE ...]
"""
import sys

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as la


def cavity(n, reynolds, start=None):
    """u on x = 1/2 and v on y = 1/2, and the nodes' psi and w."""
    h = 1.0 / n
    m = n - 1  # nodes within, a side
    one = sp.identity(m, format="csr")
    d = sp.diags([-1, 1], [-1, 1], shape=(m, m)) / (2 * h)
    dd = sp.diags([1, -2, 1], [-1, 0, 1], shape=(m, m)) / h**2
    dx, dy = sp.kron(d, one, "csr"), sp.kron(one, d, "csr")  # [x, y], y the faster
    laplace = (sp.kron(dd, one) + sp.kron(one, dd)).tocsr()

    # Vorticity of the walls, as the nodes next to them see it: w = -2 psi_next/h^2, and - 2/h at the lid.
    lid = np.zeros((m, m))
    lid[:, -1] = -2 / h
    first, last = np.zeros(m), np.zeros(m)
    first[0] = last[-1] = 1
    low, high = sp.diags(first), sp.diags(last)
    wall = -2 / h**2
    through_walls = wall / h**2 * (
        sp.kron(low, one) + sp.kron(high, one) + sp.kron(one, low) + sp.kron(one, high))
    x_walls = wall / (2 * h) * (sp.kron(high, one) - sp.kron(low, one))
    y_walls = wall / (2 * h) * (sp.kron(one, high) - sp.kron(one, low))
    lid_laplace = (lid / h**2).ravel()
    lid_dy = (lid / (2 * h)).ravel()

    psi, w = start if start is not None else (np.zeros(m * m), np.zeros(m * m))
    for _ in range(30):
        u, v = dy @ psi, -(dx @ psi)
        wx, wy = dx @ w + x_walls @ psi, dy @ w + y_walls @ psi + lid_dy
        r1 = laplace @ psi + w
        r2 = u * wx + v * wy - (laplace @ w + through_walls @ psi + lid_laplace) / reynolds
        by_psi = (sp.diags(wx) @ dy - sp.diags(wy) @ dx + sp.diags(u) @ x_walls + sp.diags(v) @ y_walls
                  - through_walls / reynolds)
        by_w = sp.diags(u) @ dx + sp.diags(v) @ dy - laplace / reynolds
        jacobian = sp.bmat([[laplace, sp.identity(m * m)], [by_psi, by_w]], format="csc")
        step = la.spsolve(jacobian, -np.concatenate([r1, r2]))
        psi, w = psi + step[: m * m], w + step[m * m:]
        if np.abs(step).max() < 1e-10 * np.abs(w).max():
            break
    u = (dy @ psi).reshape(m, m)[n // 2 - 1, :]
    v = -(dx @ psi).reshape(m, m)[:, n // 2 - 1]
    return u, v, (psi, w)


def extremum(values, k):
    a, b, c = values[k - 1], values[k], values[k + 1]
    return b - (c - a) ** 2 / (8 * (a - 2 * b + c))


def extrema(n, reynolds, start):
    u, v, state = cavity(n, reynolds, start)
    return np.array([extremum(u, u.argmin()), extremum(v, v.argmin()), extremum(v, v.argmax())]), state


def refined(state, n):
    """A start on twice as many cells."""
    out = []
    for field in state:
        full = np.zeros((n + 1, n + 1))
        full[1:-1, 1:-1] = field.reshape(n - 1, n - 1)
        fine = np.zeros((2 * n + 1, 2 * n + 1))
        fine[::2, ::2] = full
        fine[1::2, ::2] = (full[1:] + full[:-1]) / 2
        fine[:, 1::2] = (fine[:, :-2:2] + fine[:, 2::2]) / 2
        out.append(fine[1:-1, 1:-1].ravel())
    return tuple(out)


for reynolds in [float(a) for a in sys.argv[1:]] or [100.0, 400.0, 1000.0]:
    state, before = None, None
    for re in [r for r in (100.0, 400.0) if r < reynolds] + [reynolds]:
        _, state = extrema(64, re, state)
    for n in (64, 128, 256):
        if n > 64:
            state = refined(state, n // 2)
        values, state = extrema(n, reynolds, state)
        print(f"Re {reynolds:g}, {n} cells: u_min {values[0]:.5f}, v_min {values[1]:.5f}, v_max {values[2]:.5f}")
        if before is not None:
            best = values + (values - before) / 3
        before = values
    print(f"Re {reynolds:g}, extrapolated: u_min {best[0]:.5f}, v_min {best[1]:.5f}, v_max {best[2]:.5f}")
