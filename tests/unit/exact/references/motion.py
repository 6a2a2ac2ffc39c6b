# SPDX-License-Identifier: MIT
"""Ways of a ball between two events: closed forms in 50 digits, and in double for a first look. model.md 3, 6.2."""
import math
from mpmath import mp, mpf

mp.dps = 50


class Vec:
    __slots__ = ("x", "y")

    def __init__(self, x, y):
        self.x, self.y = x, y

    def __add__(self, o): return Vec(self.x + o.x, self.y + o.y)
    def __sub__(self, o): return Vec(self.x - o.x, self.y - o.y)
    def __neg__(self): return Vec(-self.x, -self.y)
    def __mul__(self, f): return Vec(self.x * f, self.y * f)
    __rmul__ = __mul__
    def dot(self, o): return self.x * o.x + self.y * o.y
    def left(self): return Vec(-self.y, self.x)
    def length(self): return mp.sqrt(self.x * self.x + self.y * self.y)
    def unit(self): return self * (1 / self.length())
    def is_zero(self): return self.x == 0 and self.y == 0
    def coarse(self): return Vec(float(self.x), float(self.y))
    def __getitem__(self, axis): return self.y if axis else self.x


class Parabola:
    """Constant acceleration; the parameter is the time."""

    def __init__(self, p, v, a, end=mp.inf):
        self.p, self.v, self.a, self.end = p, v, a, end

    def coarse(self): return Parabola(self.p.coarse(), self.v.coarse(), self.a.coarse(), float(self.end))
    def at(self, t): return self.p + self.v * t + self.a * (t * t / 2), self.v + self.a * t
    def time(self, t): return t
    def slowness(self, t): return 1
    def parameter(self, t): return t
    def nodes(self, end, count): return [end * i / count for i in range(count + 1)]


class Resisted:
    """v' = A - B v/|v| from v != 0, B > 0. The parameter is xi, the integral of dt/|v|: |v| and v obey a linear law."""

    def __init__(self, p, v, A, B, lib=mp):
        self.p, self.v, self.A, self.B, self.lib = p, v, A, B, lib
        s, a = lib.sqrt(v.dot(v)), lib.sqrt(A.dot(A))
        self.s, self.a = s, a
        self.e = A * (1 / a) if a > 0 else v * (1 / s)
        along, self.across = v.dot(self.e), v.dot(self.e.left())
        if abs(self.across) < s * 1e-40: self.across = 0 * s  # the last digits of a way straight up
        # P + M = |v|, P - M = v.e, and P M = across^2/4 gives the smaller one without cancellation.
        larger = (s + abs(along)) / 2
        smaller = self.across ** 2 / (4 * larger)
        self.P, self.M = (larger, smaller) if along >= 0 else (smaller, larger)
        self.end = mp.inf
        if B > a: self.end = self.P / (B - a) + self.M / (B + a)
        elif self.P == 0: self.end = self.M / (B + a)

    def coarse(self): return Resisted(self.p.coarse(), self.v.coarse(), self.A.coarse(), float(self.B), math)

    def integral(self, c, xi): return self.lib.expm1(c * xi) / c if c != 0 else xi

    def time(self, xi):
        if xi == mp.inf: return self.end
        return self.P * self.integral(self.a - self.B, xi) + self.M * self.integral(-self.a - self.B, xi)

    def slowness(self, xi):
        """dt/dxi, the speed."""
        exp = self.lib.exp
        return self.P * exp((self.a - self.B) * xi) + self.M * exp(-(self.a + self.B) * xi)

    def at(self, xi):
        a, B, P, M, e = self.a, self.B, self.P, self.M, self.e
        if xi == mp.inf:
            fast = P * P / (2 * (B - a)) if P else 0
            side = P / (2 * B - a) + M / (2 * B + a) if self.across else 0
            return self.p + e * (fast - M * M / (2 * (B + a))) + e.left() * (self.across * side), Vec(mpf(0), mpf(0))
        exp, I = self.lib.exp, self.integral
        x = P * P * I(2 * (a - B), xi) - M * M * I(-2 * (a + B), xi)
        y = self.across * (P * I(a - 2 * B, xi) + M * I(-a - 2 * B, xi))
        vx = P * exp((a - B) * xi) - M * exp(-(a + B) * xi)
        return self.p + e * x + e.left() * y, e * vx + e.left() * (self.across * exp(-B * xi))

    def parameter(self, t):
        if t >= self.end: return mp.inf
        low, high = mpf(0), min(t / self.s, 1 / (self.a + self.B))
        while self.time(high) < t: low, high = high, 2 * high
        xi = (low + high) / 2
        while True:
            excess = self.time(xi) - t
            if abs(excess) <= t * mpf(10) ** -48: return xi
            if excess > 0: high = xi
            else: low = xi
            new = xi - excess / self.slowness(xi)
            if not low < new < high: new = (low + high) / 2
            if abs(new - xi) <= abs(xi) * mpf(10) ** -46: return new
            xi = new

    def last(self):
        """A parameter at which the speed is hardly anything: where nodes end for a ball that stops."""
        rate = self.B - self.a if self.P and self.B > self.a else self.B + self.a
        return 23 / rate

    def nodes(self, end, count):
        """Evenly by xi, and about evenly by time: either alone is coarse in places."""
        end = self.last() if end == mp.inf else end
        by_xi = [end * i / count for i in range(count + 1)]
        step, extra = self.time(end) / count, []
        for low, high in zip(by_xi, by_xi[1:]):
            parts = int(min(64, (self.time(high) - self.time(low)) / step))
            extra += [low + (high - low) * k / (parts + 1) for k in range(1, parts + 1)]
        return sorted(by_xi + extra)


class Arc:
    """Round a vertical edge, pressed against it: R angle'' = A.t(angle) - B. The parameter is the angle turned."""
    kOrder = 48

    def __init__(self, corner, R, normal, tangent, speed, A, B, lib=mp):
        self.corner, self.R, self.n, self.t, self.B, self.lib, self.v0 = corner, R, normal, tangent, B, lib, speed
        self.An, self.At = A.dot(normal), A.dot(tangent)
        self.A = A

    def coarse(self):
        return Arc(self.corner.coarse(), float(self.R), self.n.coarse(), self.t.coarse(), float(self.v0),
                   self.A.coarse(), float(self.B), math)

    def normal(self, y): return self.n * self.lib.cos(y) + self.t * self.lib.sin(y)
    def tangent(self, y): return self.t * self.lib.cos(y) - self.n * self.lib.sin(y)

    def squared_speed(self, y):
        work = self.At * self.lib.sin(y) + self.An * (self.lib.cos(y) - 1) - self.B * y
        return self.v0 ** 2 + 2 * self.R * work

    def lift(self, y):
        """v^2/R less what presses: the ball leaves where this rises through zero."""
        return self.squared_speed(y) / self.R + self.An * self.lib.cos(y) + self.At * self.lib.sin(y)

    def at(self, y):
        """Place, and direction of motion (not the velocity)."""
        return self.corner + self.normal(y) * self.R, self.tangent(y)

    def series(self, y, rate):
        """Taylor coefficients of the angle by the time."""
        n = self.kOrder
        a, s, c = [y, rate] + [mpf(0)] * n, [mp.sin(y)] + [mpf(0)] * n, [mp.cos(y)] + [mpf(0)] * n
        for k in range(n):
            if k:
                s[k] = sum(j * a[j] * c[k - j] for j in range(1, k + 1)) / k
                c[k] = -sum(j * a[j] * s[k - j] for j in range(1, k + 1)) / k
            force = self.At * c[k] - self.An * s[k] - (self.B if k == 0 else 0)
            a[k + 2] = force / self.R / ((k + 1) * (k + 2))
        return a

    def swing(self, until, angle=None):
        """Time, angle and rate when `angle` is reached, the ball stands still (angle None) or the time is up."""
        time, y, rate = mpf(0), mpf(0), self.v0 / self.R
        while True:
            a = self.series(y, rate)
            h = min(mpf(10) ** (-50.0 / (len(a) - k)) / abs(a[-k]) ** (mpf(1) / (len(a) - k)) for k in (1, 2, 3)
                    if a[-k] != 0)
            h = min(h, until - time)
            slope = [k * a[k] for k in range(1, len(a))]
            bend = [k * slope[k] for k in range(1, len(slope))]
            value, rate_at, bend_at = (lambda t, c=c[::-1]: mp.polyval(c, t) for c in (a, slope, bend))
            stops = rate_at(h) <= 0
            turn = root(lambda t: -rate_at(t), mpf(0), h, lambda t: -bend_at(t)) if stops else h
            if angle is not None and value(turn) >= angle:
                t = root(lambda t: value(t) - angle, mpf(0), turn, rate_at)
                return time + t, angle, rate_at(t)
            if stops: return time + turn, value(turn), mpf(0)
            time, y, rate = time + h, value(h), rate_at(h)
            if time >= until: return until, y, rate


def root(f, low, high, slope=None):
    """The root of f between low, where f is negative (or zero), and high, where it isn't: guarded Newton."""
    x = (low + high) / 2
    for _ in range(400):
        value = f(x)
        if value < 0: low = x
        else: high = x
        if value == 0: return x
        d = slope(x) if slope else mp.diff(f, x)
        new = x - value / d if d else low
        if not low < new < high: new = (low + high) / 2
        if abs(new - x) <= abs(high) * mpf(10) ** -47 or high - low <= abs(high) * mpf(10) ** -47: return new
        x = new
    return x
