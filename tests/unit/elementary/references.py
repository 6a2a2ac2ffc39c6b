#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes references.txt: values of the elementary functions to 106 bits, by mpmath, for tst_elementary.

Usage: tests/unit/elementary/references.py >tests/unit/elementary/references.txt"""
import math
import random

from mpmath import libmp

from truth import KINDS, TRUTH

RANDOM_PER_KIND = 40
LOG_LARGEST = float.fromhex("0x1.62e42fefa39efp9")

# Where a method changes hands, where results meet the ends of the range, and where reductions lose most.
HARD = {
    "exp": [(x, 0.0) for x in (LOG_LARGEST, -708.3964185322641, -708.5, -745.1332191019411, -744.4400719213812, 1e-300,
                               math.log(2) / 64, math.nextafter(math.log(2) / 64, 1), 5e-324)],
    "expm1": [(x, 0.0) for x in (0.25, math.nextafter(0.25, 0), -0.25, math.nextafter(-0.25, 0), 40.0, -39.99999,
                                 math.nextafter(40.0, 0), LOG_LARGEST, 2.0**-54, -2.0**-53, 5e-324)],
    "log": [(x, 0.0) for x in (5e-324, 2.0**-1022, math.nextafter(2.0**-1022, 0), 1.7976931348623157e308,
                               math.nextafter(1.0, 0), math.nextafter(1.0, 2), 127 / 128, 129 / 128, math.sqrt(0.5),
                               math.nextafter(math.sqrt(0.5), 0), math.sqrt(2), math.nextafter(math.sqrt(2), 2), 2.0)],
    "log1p": [(x, 0.0) for x in (2.0**-7, math.nextafter(2.0**-7, 0), -2.0**-7, math.nextafter(-2.0**-7, 0), -1 + 2.0**-53,
                                 -0.5, 2.0**53, 1.7976931348623157e308, 2.0**-54, -2.0**-53, 5e-324)],
    "root": [(5e-324, 2.0), (5e-324, 1000.0), (1.7976931348623157e308, 2.0), (math.nextafter(1.0, 0), 24.0), (27.0, 3.0),
             (2.0**-1022, 3.0), (1e300, 999.0)],
    "sin": [(x, 0.0) for x in (2.0**20, -2.0**20, 2.0**-27, math.nextafter(2.0**-27, 0), math.pi, math.pi / 4,
                               math.nextafter(math.pi / 4, 1), 1048575.9999999999)],
    "cos": [(x, 0.0) for x in (2.0**20, 2.0**-27, 2.0**-600, math.pi / 2, math.pi, math.pi / 4,
                               math.nextafter(math.pi / 4, 1), 1048575.9999999999)],
    "atan2": [(1.0, 1.0), (1.0, -1.0), (1.0, 8.0), (math.nextafter(1.0, 0), 8.0), (8.0, -1.0), (1e308, 1e308),
              (5e-324, 5e-324), (5e-324, 1e-320), (1e-308, 1e-300), (2.0**-30, 1.0), (2.0**-31, -1.0), (1.0, 0.0),
              (1e300, 1e-300), (3 / 64, 1.0), (33 / 64, 1.0)],
    "hypot": [(3.0, 4.0), (5e-324, 5e-324), (1e308, 1e308), (1e-320, 1e-310), (1.0, 2.0**-27), (1.0, 2.0**-53),
              (2.0**500, 2.0**499), (2.0**-400, 2.0**-401)],
}


def parts(exact):
    """An exact value as a double and what it lacks, in units in the last place of that double."""
    high = libmp.to_float(exact, strict=False)
    if math.isinf(high):
        return high, 0.0
    lacks = libmp.mpf_sub(exact, libmp.from_float(high), 53)
    unit = max(exact[2] + exact[3] - 53, -1074)
    return high, libmp.to_float(libmp.mpf_shift(lacks, -unit))


print("# function x y: the nearest double, and what that lacks of the exact value in units in the last place;")
print("# printed by references.py")
for function, kinds in KINDS.items():
    generator = random.Random(function)
    arguments = list(HARD[function])
    for draw_x, draw_y in kinds:
        arguments += [(draw_x(generator), draw_y(generator)) for _ in range(RANDOM_PER_KIND)]
    for x, y in arguments:
        high, lacks = parts(TRUTH[function](x, y))
        print(function, x.hex(), float(y).hex(), high.hex(), f"{lacks:.6f}")
