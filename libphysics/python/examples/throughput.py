#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How many steps a second one thread makes: balls of a level, each on a board of its own, and balls in the open.

Usage: throughput.py LEVEL [BALLS [STEPS]]      default: 256 balls, 500 steps
"""
import sys
import time

import numpy as np

import libphysics as lp

DT = 0.01  # s


def millions_a_second(scene, id, balls, steps):
    """The best of three runs, CPU time."""
    stepper = lp.Stepper(id, scene)
    tilts = np.random.default_rng(1).uniform(-0.08, 0.08, (2, balls))
    gravity = lp.gravity_from_tilt(*tilts)[:, None]
    params, best = stepper.params(), np.inf
    for _ in range(3):
        states = scene.start(balls)
        begin = time.thread_time()
        stepper.run(states, params, DT, steps, gravity=gravity, out=states).check()
        best = min(best, time.thread_time() - begin)
    return balls * steps / best / 1e6


def main(arguments):
    numbers = arguments[1:]
    if not 1 <= len(arguments) <= 3 or not all(text.isdecimal() and int(text) > 0 for text in numbers):
        print(__doc__, file=sys.stderr)
        return 2
    balls, steps = (int(text) for text in numbers + ["256", "500"][len(numbers):])
    level = lp.Scene(arguments[0])
    floor = lp.Scene(boxes=[[(-1e4, -1e4, -1), (1e4, 1e4, 0)]], radius=level.radius)
    for id in ("symplectic-euler", "swept"):
        print(f"{id:18} {millions_a_second(level, id, balls, steps):6.1f} million steps a second in the level, "
              f"{millions_a_second(floor, id, balls, steps):6.1f} in the open")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"throughput.py: {error}")
