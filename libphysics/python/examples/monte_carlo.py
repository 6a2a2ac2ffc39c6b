#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where and when balls leave a level if the board is tilted at random: N balls, a new tilt for each every half second.

Usage: monte_carlo.py LEVEL [BALLS [SECONDS [THREADS]]]      default: 400 balls, 20 s, 1 thread
"""
import sys
import time

import numpy as np

import libphysics as lp

DT = 0.01  # s
MOST_TILT = np.radians(5)
SEGMENT = 50  # steps with one tilt


def main(arguments):
    numbers = arguments[1:]
    if not 1 <= len(arguments) <= 4 or not all(text.isdecimal() and int(text) > 0 for text in numbers):
        print(__doc__, file=sys.stderr)
        return 2
    balls, seconds, threads = (int(text) for text in numbers + ["400", "20", "1"][len(numbers):])
    scene = lp.Scene(arguments[0])
    stepper = lp.Stepper("symplectic-euler", scene)
    params = stepper.params()
    random = np.random.default_rng(1)
    states = scene.start(balls)
    begin = time.perf_counter()
    steps = 0
    for _ in range(round(seconds / DT / SEGMENT)):
        tilts = random.uniform(-MOST_TILT, MOST_TILT, (2, balls))
        run = stepper.run(states, params, DT, SEGMENT, gravity=lp.gravity_from_tilt(*tilts)[:, None], stop=lp.OUT,
                          threads=threads, out=states).check()
        steps += int(run.steps_done.sum())
    took = time.perf_counter() - begin

    left = (states["flags"] & lp.OUT) != 0
    print(f"{left.sum()} of {balls} balls left within {seconds} s", end="")
    if left.any():
        times, places = states["time"][left], states["position"][left]
        print(f"; half of them by {np.median(times):.2f} s, at")
        low, high = scene.bounds[:, :2]
        sides = {"left": places[:, 0] < low[0], "right": places[:, 0] > high[0],
                 "front": places[:, 1] < low[1], "back": places[:, 1] > high[1]}
        for side, there in sides.items():
            print(f"  {side:6} {there.sum():6}")
    else:
        print()
    print(f"{steps} steps, {steps / took / 1e6:.2f} million a second with the tilts drawn", file=sys.stderr)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"monte_carlo.py: {error}")
