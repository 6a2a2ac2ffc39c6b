#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fit a measured ball: which rolling friction, restitution and offset of the tilt make the computed ball roll like it?

Usage: fit.py LEVEL [TRACK]      TRACK: a table with header t,x,y,tilt_x,tilt_y (s, m, degrees), rows at equal times, of a
ball that starts at rest; default: one made here, with known numbers and noise of 0.1 mm
       fit.py --make LEVEL       prints that one as such a table: the inspector's example_track.csv

Levenberg and Marquardt's method: all difference quotients of a step are one batch, each ball on a board of its own.
"""
import sys

import numpy as np

import libphysics as lp

NAMES = ["rolling_friction", "restitution_wall", "tilt_x [deg]", "tilt_y [deg]", "start x [m]", "start y [m]"]
LOW = np.array([0, 0, -10, -10, -np.inf, -np.inf])
HIGH = np.array([1, 0.99, 10, 10, np.inf, np.inf])
NOTCHES = np.array([1e-6, 1e-5, 1e-5, 1e-5, 1e-7, 1e-7])
NOISE = 1e-4  # m, of each coordinate
FIRST, GROWTH = 30, 1.3  # points that are fitted at first, and how their number grows


def roll(stepper, numbers, dt, tilts):
    """Places (..., points, 2) of balls with numbers (..., 6), from the start on; tilts (points - 1, 2) in degrees."""
    numbers = np.asarray(numbers)
    params = stepper.params(rolling_friction=numbers[..., 0], restitution_wall=numbers[..., 1])
    states = stepper.scene.start(numbers.shape[:-1])
    states["position"][..., :2] = numbers[..., 4:6]
    felt = np.radians(tilts + numbers[..., None, 2:4])
    run = stepper.run(states, params, dt, len(tilts), gravity=lp.gravity_from_tilt(felt[..., 0], felt[..., 1]), every=1)
    path = run.check().path["position"][..., :2]
    return np.concatenate([states["position"][..., None, :2], path], axis=-2)


def residuals_and_slopes(stepper, numbers, dt, seen, tilts):
    """In units of the noise; slopes as columns. One batch."""
    notches = np.where(numbers + NOTCHES > HIGH, -NOTCHES, NOTCHES)
    boards = np.vstack([numbers, numbers + np.diag(notches)])
    apart = ((roll(stepper, boards, dt, tilts) - seen) / NOISE).reshape(len(boards), -1)
    return apart[0], ((apart[1:] - apart[0]) / notches[:, None]).T


def improved(stepper, numbers, dt, seen, tilts, steps=20):
    """The numbers of the least sum of squares near the given ones, with residuals and slopes there."""
    damping = 1e-3
    apart, slopes = residuals_and_slopes(stepper, numbers, dt, seen, tilts)
    for _ in range(steps):
        normal = slopes.T @ slopes
        damped = normal + damping * np.diag(np.diag(normal) + 1e-12)
        tried = np.clip(numbers - np.linalg.solve(damped, slopes.T @ apart), LOW, HIGH)
        there, slopes_there = residuals_and_slopes(stepper, tried, dt, seen, tilts)
        gain = apart @ apart - there @ there
        if gain > 0:
            numbers, apart, slopes = tried, there, slopes_there
        damping *= 0.2 if gain > 0 else 8
        if 0 < gain < 1e-3 or damping > 1e9:
            break
    return numbers, apart, slopes


def fit(stepper, dt, seen, tilts):
    """Short stretches first: what is learned from them tells the next bounces. Ends early where residuals aren't noise.
    Returns numbers, their standard deviations, the residuals' root mean square in units of the noise, points used."""
    start = stepper.scene.start()["position"][:2]
    numbers = np.array([0.002, 0.5, 0, 0, *start])
    best, count = None, FIRST
    while True:
        numbers, apart, slopes = improved(stepper, numbers, dt, seen[:count], tilts[:count - 1])
        rms = np.sqrt(np.mean(apart**2))
        if best is None or rms < 1.3:
            deviations = np.sqrt(np.diag(np.linalg.pinv(slopes.T @ slopes)))
            best = numbers, deviations, rms, count
        if rms >= 1.3 or count == len(seen):
            return best
        count = min(int(count * GROWTH), len(seen))


def make_track(stepper, dt=1 / 60, seconds=4):
    """A ball as a camera would see it: another tilt every half second, and numbers that the fit isn't told."""
    random = np.random.default_rng(2)
    points = round(seconds / dt) + 1
    tilts = np.repeat(random.uniform(-4, 4, (seconds * 2, 2)), round(0.5 / dt), axis=0)[:points - 1]
    truth = np.array([0.004, 0.6, 0.3, -0.2, *stepper.scene.start()["position"][:2]])
    path = roll(stepper, truth, dt, tilts)
    return dt, path + random.normal(0, NOISE, path.shape), tilts, truth


def read_track(path):
    table = np.genfromtxt(path, delimiter=",", names=True)
    times = table["t"]
    dt = (times[-1] - times[0]) / (len(times) - 1)
    if not np.allclose(np.diff(times), dt, rtol=1e-3):
        raise SystemExit(f"{path}: expected rows at equal times, found {np.diff(times).min()} to {np.diff(times).max()} s")
    columns = [np.column_stack([table[x], table[y]]) for x, y in (("x", "y"), ("tilt_x", "tilt_y"))]
    return dt, columns[0], columns[1][:-1], None


def print_track(dt, seen, tilts):
    print("t,x,y,tilt_x,tilt_y")
    for i, (x, y) in enumerate(seen):
        tilt_x, tilt_y = tilts[min(i, len(tilts) - 1)]
        print(f"{i * dt:.6f}, {x:.6f}, {y:.6f}, {float(tilt_x)!r}, {float(tilt_y)!r}")


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--make":
        print_track(*make_track(lp.Stepper("exact", lp.Scene(arguments[1])))[:3])
        return 0
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    stepper = lp.Stepper("exact", lp.Scene(arguments[0]))
    dt, seen, tilts, truth = read_track(arguments[1]) if len(arguments) == 2 else make_track(stepper)
    numbers, deviations, rms, count = fit(stepper, dt, seen, tilts)
    print(f"{count} of {len(seen)} points fitted, residuals {rms * NOISE * 1e3:.3f} mm")
    for i, name in enumerate(NAMES):
        known = f", made with {truth[i]:.6g}" if truth is not None else ""
        print(f"{name:17} {numbers[i]:10.6f} +- {1.96 * deviations[i]:.2g}{known}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"fit.py: {error}")
