# SPDX-License-Identifier: MIT
"""What the elementary functions are by mpmath, and the arguments they are asked for: each kind has its own range."""
import math
from mpmath import libmp, mp, mpf

PRECISION = 160
LEAST_EXPONENT = -1074


def one(function):
    return lambda x, y: function(libmp.from_float(x), PRECISION)


def two(function):
    return lambda x, y: function(libmp.from_float(x), libmp.from_float(y), PRECISION)


def log1p(x, y):
    return libmp.mpf_log(libmp.mpf_add(libmp.fone, libmp.from_float(x)), PRECISION + 80)


def expm1(x, y):
    return libmp.mpf_sub(libmp.mpf_exp(libmp.from_float(x), PRECISION + 1100), libmp.fone, PRECISION)


def root(x, y):
    return libmp.mpf_nthroot(libmp.from_float(x), int(y), PRECISION)


TRUTH = {
    "exp": one(libmp.mpf_exp), "expm1": expm1, "log": one(libmp.mpf_log), "log1p": log1p, "root": root,
    "sin": one(libmp.mpf_sin), "cos": one(libmp.mpf_cos), "atan2": two(libmp.mpf_atan2), "hypot": two(libmp.mpf_hypot),
}


def even(low, high):
    return lambda random: random.uniform(low, high)


def wide(low, high):
    """Of any size between two powers of two, of either sign."""
    return lambda random: math.ldexp(random.uniform(0.5, 1.0), random.randint(low, high)) * random.choice((-1, 1))


def positive(draw):
    return lambda random: abs(draw(random))


def near_quarters(random):
    """Doubles next to multiples of a quarter turn, where sine or cosine loses all its digits to the reduction."""
    number = random.randint(1, 667543)
    with mp.workprec(200):
        nearest = float(number * mp.pi / 2)
    for _ in range(random.randint(0, 2)):
        nearest = math.nextafter(nearest, random.choice((0.0, math.inf)))
    return nearest


def degree(random):
    return random.randint(2, 40)


NONE = even(0.0, 0.0)
KINDS = {
    "exp": [(even(-745.2, 709.78), NONE), (even(-1.0, 1.0), NONE), (wide(-60, 9), NONE)],
    "expm1": [(even(-40.0, 709.78), NONE), (even(-2.0, 2.0), NONE), (wide(-60, 9), NONE)],
    "log": [(positive(wide(LEAST_EXPONENT + 1, 1024)), NONE), (even(0.5, 2.0), NONE), (even(0.98, 1.02), NONE)],
    "log1p": [(even(-1.0, 1.0), NONE), (positive(wide(-60, 1000)), NONE), (even(-0.02, 0.02), NONE)],
    "root": [(positive(wide(LEAST_EXPONENT + 1, 1024)), degree)],
    "sin": [(even(-0.8, 0.8), NONE), (even(-7.0, 7.0), NONE), (even(-2.0**20, 2.0**20), NONE), (near_quarters, NONE)],
    "cos": [(even(-0.8, 0.8), NONE), (even(-7.0, 7.0), NONE), (even(-2.0**20, 2.0**20), NONE), (near_quarters, NONE)],
    "atan2": [(even(-1.0, 1.0), even(-1.0, 1.0)), (wide(-20, 1), even(-1.0, 1.0)), (wide(-1021, 1023), wide(-1021, 1023))],
    "hypot": [(even(-1.0, 1.0), even(-1.0, 1.0)), (wide(-1021, 1022), wide(-1021, 1022))],
}


def unit(value):
    """One unit in the last place of the double nearest to an exact value, as an exponent of two."""
    _, _, exponent, bits = value
    return max(exponent + bits - 53, LEAST_EXPONENT)


def error(got, exact):
    """How far a double is from the exact value, in units in the last place."""
    if not math.isfinite(got):
        return math.inf if exact[2] + exact[3] <= 1024 else 0.0
    difference = libmp.mpf_sub(libmp.from_float(got), exact, 53)
    if difference == libmp.fzero:
        return 0.0
    return abs(libmp.to_float(libmp.mpf_shift(difference, -unit(exact))))
