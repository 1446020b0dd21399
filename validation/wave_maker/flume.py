#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The surface before a piston that moves as measured, by linear theory: writes theory.csv.

A piston at x = 0 with the displacement X e^(i w t) in water of depth h makes [Dean, Dalrymple 1991, chapter 6]

  eta/X = i C e^(-i k x) + sum_m C_m e^(-k_m x)
  C   = 2 (cosh 2kh - 1)/(sinh 2kh + 2kh),          w^2 = g k tanh(k h)
  C_m = 2 (1 - cos 2k_m h)/(sin 2k_m h + 2k_m h),   w^2 = -g k_m tan(k_m h)

summed over the frequencies of piston.csv. What the dike sends back is not in it. Needs NumPy and SciPy.

  cd validation/wave_maker; ./flume.py > theory.csv
"""
import numpy as np
from scipy.optimize import brentq

GRAVITY, DEPTH, END = 9.81, 0.31, 7.5
GAUGES = {"WG1": 0.35, "WG2": 1.80}  # before the piston [m]
STEP, COUNT, NEAR_FIELD = 0.01, 8192, 12


def transfer(omega, x):
    k = brentq(lambda k: GRAVITY * k * np.tanh(k * DEPTH) - omega**2, 1e-6, 500)
    out = 1j * 2 * (np.cosh(2 * k * DEPTH) - 1) / (np.sinh(2 * k * DEPTH) + 2 * k * DEPTH) * np.exp(-1j * k * x)
    for m in range(1, NEAR_FIELD):
        q = brentq(lambda q: GRAVITY * q * np.tan(q * DEPTH) + omega**2,
                   (m - 0.5) * np.pi / DEPTH + 1e-9, m * np.pi / DEPTH - 1e-12)
        out += 2 * (1 - np.cos(2 * q * DEPTH)) / (np.sin(2 * q * DEPTH) + 2 * q * DEPTH) * np.exp(-q * x)
    return out


piston = np.loadtxt("piston.csv", delimiter=",", skiprows=4)
time = np.arange(COUNT) * STEP
moved = np.interp(time, piston[:, 0], piston[:, 1]) * np.clip((12 - time) / 4, 0, 1)
spectrum = np.fft.rfft(moved)
omegas = 2 * np.pi * np.fft.rfftfreq(COUNT, STEP)
eta = {}
for name, x in GAUGES.items():
    out = np.array([s * transfer(w, x) if 0 < w < 25 else 0 for s, w in zip(spectrum, omegas)])
    eta[name] = np.fft.irfft(out, COUNT)

gauges = np.loadtxt("gauges.csv", delimiter=",", skiprows=4)
counts = (gauges[:, 0] > 2) & (gauges[:, 0] < 7.4)


def off(name, column, late):
    at = np.interp(gauges[counts, 0] - late, time, eta[name])
    return np.sqrt(np.mean((at - gauges[counts, column]) ** 2)) / 0.07


print("# The surface before the piston of piston.csv by linear theory, flume.py; the gauges' differences from it, rms over 0.07 m:")
print("# " + ", ".join(f"{n} {off(n, c, 0):.3f} as they are, {off(n, c, 0.05):.3f} if their clock is 0.05 s late"
                       for c, n in enumerate(GAUGES, 1)))
print("time,WG1,WG2")
for k in range(0, int(END / STEP) + 1, 2):
    print(f"{time[k]:.2f},{eta['WG1'][k]:.6f},{eta['WG2'][k]:.6f}")
