#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A sweep of 1,000 balls for 1,000 steps on level 10 from Python beside the same in C, in turns, CPU time of the thread.

Usage: sweep.py BENCH_MANY LEVEL      BENCH_MANY: the program that makes the sweep in C and prints its seconds
"""
import statistics
import subprocess
import sys
import time

import numpy as np

import libphysics as lp

BALLS = STEPS = 1000
ROUNDS = 9
ALLOWED = 1.05


def sweep(stepper, start):
    """Seconds, with all that a user writes."""
    begin = time.thread_time()
    gravity = lp.gravity_from_tilt(np.linspace(-0.1, 0.1, BALLS), 0.05)
    stepper.run(start, stepper.params(), 0.01, STEPS, gravity=gravity[:, None]).check()
    return time.thread_time() - begin


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    program, level = arguments
    scene = lp.Scene(level)
    stepper, start = lp.Stepper("symplectic-euler", scene), scene.start()
    in_c, in_python = [], []
    for _ in range(ROUNDS):
        in_c.append(float(subprocess.run([program, "--sweep"], check=True, capture_output=True).stdout))
        in_python.append(statistics.median(sweep(stepper, start) for _ in range(ROUNDS)))
    ratio = statistics.median(python / c for python, c in zip(in_python, in_c))
    rate = BALLS * STEPS / statistics.median(in_python) / 1e6
    print(f"{'level 10, 1,000 balls for 1,000 steps, Python / C':78} {ALLOWED:8.2f} {ratio:9.2f}  "
          f"{'met' if ratio <= ALLOWED else 'MISSED'}")
    print(f"{'the same by numpy, million steps a second':78} {12:8.1f} {rate:9.1f}  {'met' if rate >= 12 else 'MISSED'}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
