#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints libphysics/src/base/elementary_tables.h: the constants and tables of the elementary functions, by mpmath.

Usage: tests/unit/elementary/tables.py >libphysics/src/base/elementary_tables.h"""
from mpmath import atan, floor, log, mp, mpf, nint, pi

mp.prec = 300


def hexadecimal(value):
    return float(value).hex() if value != 0 else "0.0"


def rounded(value, quantum):
    """The multiple of a power of two that is nearest to value."""
    return nint(value / quantum) * quantum


def pair(value, quantum=None):
    """A number as a double and the double that it lacks; with a quantum the first is a multiple of that."""
    high = mpf(float(value)) if quantum is None else rounded(value, quantum)
    return high, mpf(float(value - high))


def parts(value, bits, count):
    """A number as `count` doubles, each but the last of at most `bits` bits."""
    result = []
    for _ in range(count - 1):
        quantum = mpf(2) ** (floor(log(value, 2)) + 1 - bits)
        part = floor(value / quantum) * quantum
        result.append(part)
        value -= part
    return result + [mpf(float(value))]


def constant(comment, name, value):
    print(f"inline constexpr double {name} = {hexadecimal(value)}; ///< {comment}")


def table(comment, name, rows):
    print(f"\n/// {comment}")
    print(f"inline constexpr double {name}[][{len(rows[0])}] = {{")
    for row in rows:
        print("    {" + ", ".join(hexadecimal(value) for value in row) + "},")
    print("};")


print("""// SPDX-License-Identifier: MIT
// Constants and tables of elementary.cpp, printed by tests/unit/elementary/tables.py.
// clang-format off
#pragma once

namespace phys::elementary {
""")

step = log(mpf(2)) / 32
high, low = parts(step, 36, 2)
constant("of exp: 32 / log 2", "kStepsPerUnit", 1 / step)
constant("log(2) / 32, of 36 bits", "kStepHigh", high)
constant("and the rest", "kStepLow", low)
high, low = pair(log(mpf(2)), mpf(2) ** -42)
constant("of log: log 2, a multiple of 2^-42", "kLog2High", high)
constant("and the rest", "kLog2Low", low)
constant("of sin: 2 / pi", "kQuartersPerRadian", 2 / pi)
for number, part in enumerate(parts(pi / 2, 33, 4)):
    constant(f"part {number + 1} of pi / 2" + (", of 33 bits" if number < 3 else ", the rest"), f"kQuarter{number + 1}", part)
high, low = pair(pi / 2)
constant("of atan2: pi / 2", "kQuarterHigh", high)
constant("and the rest", "kQuarterLow", low)

table("2^(i/32) and its rest.", "kPowers", [pair(mpf(2) ** (mpf(i) / 32)) for i in range(32)])

rows = []
for i in range(45, 92):
    inverse = rounded(mpf(64) / i, mpf(2) ** -16)
    rows.append((inverse, *pair(-log(inverse), mpf(2) ** -42)))
table("From i = 45: 1/c with 17 bits for c near i/64; log c, a multiple of 2^-42; its rest.", "kLogarithms", rows)

table("atan(i/32) and its rest.", "kArcs", [pair(atan(mpf(i) / 32)) for i in range(33)])

print("\n} // namespace phys::elementary")
