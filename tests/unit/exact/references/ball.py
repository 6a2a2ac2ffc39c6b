# SPDX-License-Identifier: MIT
"""A ball in the rolling model, from event to event in 50 digits: model.md 2.1, 5, 6, 7. Written from the formulas, not
from the library: ways are looked over in double at many places, and every event is then refined in 50 digits."""
from mpmath import mp, mpf
from motion import Arc, Parabola, Resisted, Vec, root

TOUCH = mpf(10) ** -36       # gaps and speeds that are zero but for the 50th digit
LAST_BOUNCE = mpf(10) ** -24  # height, m, at which infinitely many bounces end (6.4)
LAST_HOP = mpf(10) ** -24     # m/s
NEAR = mpf(10) ** -5          # gaps that double doesn't tell well
U = mpf(2) ** -52


class Skip(Exception):
    """The scene is one whose result rounding decides, or too long for a reference."""


class Box:
    def __init__(self, number, low, high, bottom, top):
        self.number, self.low, self.high, self.bottom, self.top = number, low, high, bottom, top

    def coarse(self):
        return Box(self.number, self.low.coarse(), self.high.coarse(), float(self.bottom), float(self.top))

    def nearest(self, p):
        return Vec(min(max(p.x, self.low.x), self.high.x), min(max(p.y, self.low.y), self.high.y))

    def covers(self, p):
        return self.low.x <= p.x <= self.high.x and self.low.y <= p.y <= self.high.y


class Touch:
    def __init__(self, box, point, normal):
        self.box, self.point, self.normal = box, point, normal
        self.axis = 0 if normal.y == 0 else 1 if normal.x == 0 else None  # of a face


def snapped(values, tolerance):
    """Coordinates that differ by rounding only are one (flush boxes, 5.6)."""
    values, out = sorted(set(values)), {}
    for value in values:
        near = next((v for v in out.values() if abs(v - value) <= tolerance), value)
        out[value] = near
    return out


class Board:
    """boxes: x0 y0 z0 x1 y1 z1 each. Floors are those whose top is the highest under the start."""

    def __init__(self, boxes, radius, start):
        boxes = [[mpf(c) for c in box] for box in boxes]
        self.R = mpf(radius)
        largest = max([abs(c) for box in boxes for c in box] + [abs(mpf(c)) for c in start] + [self.R])
        self.tolerance = 4 * U * largest
        xs = snapped([b[i] for b in boxes for i in (0, 3)], self.tolerance)
        ys = snapped([b[i] for b in boxes for i in (1, 4)], self.tolerance)
        made = [Box(i, Vec(xs[b[0]], ys[b[1]]), Vec(xs[b[3]], ys[b[4]]), b[2], b[5]) for i, b in enumerate(boxes)]
        start_place = Vec(mpf(start[0]), mpf(start[1]))
        under = [b.top for b in made if b.covers(start_place) and b.top <= start[2]]
        self.top = max(under) if under else None
        self.floors = [b for b in made if self.top is not None and abs(b.top - self.top) <= self.tolerance]
        self.walls = [b for b in made if b not in self.floors]
        self.coarse_walls = [b.coarse() for b in self.walls]
        self.bounds = (min(b.low.x for b in made), min(b.low.y for b in made), max(b.high.x for b in made),
                       max(b.high.y for b in made))
        self.rest_height = None if self.top is None else self.top + self.R

    def is_over_floor(self, p): return any(f.covers(p) for f in self.floors)

    def touches(self, p):
        """Contacts by their normals, faces before edges."""
        found = []
        for box in self.walls:
            point = box.nearest(p)
            away = p - point
            distance = away.length()
            if distance > self.R + TOUCH: continue
            if distance < self.R - mpf(10) ** -30: raise Skip("penetrates")
            found.append(Touch(box, point, away.unit()))
        found.sort(key=lambda t: t.axis is None)
        out = []
        for t in found:
            if all((t.normal - o.normal).length() > TOUCH for o in out): out.append(t)
        return out

    def face_extent(self, axis, coordinate, sign, p):
        """How far boxes flush with each other carry on both ways along a face."""
        along = 1 - axis
        low = high = p[along]
        grown = True
        while grown:
            grown = False
            for b in self.walls:
                if (b.high if sign > 0 else b.low)[axis] != coordinate: continue
                if b.low[along] > high or b.high[along] < low: continue
                if b.low[along] < low or b.high[along] > high: grown = True
                low, high = min(low, b.low[along]), max(high, b.high[along])
        return low, high

    def push_out(self, p):
        """5.7; what is in by no more than the tolerance stays, which touches() takes for contact."""
        for _ in range(64):
            deepest, way = -self.tolerance, None
            for b in self.walls:
                point = b.nearest(p)
                if b.covers(p):
                    exits = [(p.x - b.low.x, Vec(b.low.x - self.R, p.y)), (b.high.x - p.x, Vec(b.high.x + self.R, p.y)),
                             (p.y - b.low.y, Vec(p.x, b.low.y - self.R)), (b.high.y - p.y, Vec(p.x, b.high.y + self.R))]
                    depth, place = min(exits, key=lambda e: e[0])
                    gap = -depth - self.R
                else:
                    gap = (p - point).length() - self.R
                    place = point + (p - point).unit() * self.R
                if gap < deepest: deepest, way = gap, place
            if way is None: return self.snap(p)
            p = way
        raise Skip("wedged")

    def snap(self, p):
        """A given place in contact within rounding is in contact."""
        for _ in range(4):
            for b in self.walls:
                point = b.nearest(p)
                gap = (p - point).length() - self.R
                if abs(gap) <= self.tolerance: p = point + (p - point).unit() * self.R
        return p


class Ball:
    def __init__(self, board, position, velocity, restitution_wall, restitution_floor, rolling_friction):
        self.board = board
        self.p, self.z = Vec(mpf(position[0]), mpf(position[1])), mpf(position[2])
        self.v, self.vz = Vec(mpf(velocity[0]), mpf(velocity[1])), mpf(velocity[2])
        self.eps, self.eps_f, self.mu = mpf(restitution_wall), mpf(restitution_floor), mpf(rolling_friction)
        self.events, self.time, self.passes = [], mpf(0), 0
        b = board
        at_floor = b.top is not None and abs(self.z - b.rest_height) <= b.tolerance
        self.supported = at_floor and b.is_over_floor(self.p) and self.vz == 0
        if self.supported: self.z = b.rest_height
        self.p = b.push_out(self.p)

    # --- laws
    def pull(self):
        if not self.supported: return self.g, mpf(0)
        return self.g * (mpf(5) / 7), mpf(5) / 7 * self.mu * self.gn

    def note(self, kind, box, before, after):
        self.events.append((kind, box, self.time, before, after))
        if len(self.events) > 4000: raise Skip("too many events")

    def step(self, gravity, dt):
        self.g, self.gn = Vec(mpf(gravity[0]), mpf(gravity[1])), -mpf(gravity[2])
        left = mpf(dt)
        if left == 0: return
        self.resolve()
        for _ in range(5000):
            before = self.time
            self.phase(left)
            left -= self.time - before
            if left <= mpf(10) ** -44: break
            self.resolve()
        else:
            raise Skip("too many phases")
        self.resolve()

    # --- impacts: 5.5, 6.4, 2.1
    def resolve(self):
        for count in range(65):
            into = [(t.normal.dot(self.v), t) for t in self.board.touches(self.p)]
            into = [(rate, t) for rate, t in into if rate < -TOUCH]
            if into and count == 64: return self.squeeze()
            if into: self.bounce(min(into, key=lambda r: r[0])[1])
            landed = self.land()
            if not into and not landed: return

    def bounce(self, touch):
        n = touch.normal
        if self.z < touch.box.bottom: raise Skip("under a wall")
        rate = n.dot(self.v)
        after = -self.eps * rate
        press = self.pressing(touch, self.v - n * rate)
        if press > 0 and after ** 2 <= 2 * press * LAST_BOUNCE: after = mpf(0)
        if press <= 0 and touch.axis is None and -rate < mpf(10) ** -5 * self.v.length(): raise Skip("grazes an edge")
        self.v = self.v + n * (after - rate)
        if touch.axis == 0 and after == 0: self.v.x = mpf(0)
        if touch.axis == 1 and after == 0: self.v.y = mpf(0)
        self.note("impact", touch.box.number, rate, after)

    def pressing(self, touch, along):
        A, _ = self.pull()
        curvature = 0 if touch.axis is not None else 1 / self.board.R
        return -(A.dot(touch.normal) + curvature * along.dot(along))

    def squeeze(self):
        """Project the velocity onto the cone that the contacts leave."""
        normals = [t.normal for t in self.board.touches(self.p)]
        ways = [self.v] + [self.v - n * n.dot(self.v) for n in normals]
        ok = [w for w in ways if all(w.dot(n) >= -TOUCH for n in normals)]
        self.v = min(ok, key=lambda w: (w - self.v).length()) if ok else Vec(mpf(0), mpf(0))

    def land(self):
        b = self.board
        if self.supported or b.top is None or self.vz >= 0 or abs(self.z - b.rest_height) > TOUCH: return False
        if not b.is_over_floor(self.p): return False
        before, self.z = self.vz, b.rest_height
        self.vz = -self.eps_f * before
        if self.vz < LAST_HOP: self.vz = mpf(0)
        self.supported = self.vz == 0
        self.note("landing", -1, before, self.vz)
        return True

    # --- what holds the ball: 6.3
    def as_edge(self, touch, direction):
        """The corner that the ball turns round, None on a face. At the end of its face the ball is on the edge."""
        if touch.axis is None: return touch.point
        along = 1 - touch.axis
        low, high = self.extent(touch)
        if direction[along] > 0 and self.p[along] >= high or direction[along] < 0 and self.p[along] <= low:
            return touch.point
        return None

    def extent(self, touch):
        sign = 1 if touch.normal[touch.axis] > 0 else -1
        return self.board.face_extent(touch.axis, touch.point[touch.axis], sign, self.p)

    def hold_moving(self, touches, A, B):
        held = []
        for t in touches:
            if t.normal.dot(self.v) > TOUCH: continue
            corner = self.as_edge(t, self.v)
            into = A.dot(t.normal)
            if corner is None:
                if into <= 0: held.append((into, t, None))
                continue
            lift = self.v.dot(self.v) / self.board.R + into
            if lift < -TOUCH or abs(lift) <= TOUCH and 3 * A.dot(self.v) < 2 * B * self.v.length():
                held.append((into, t, corner))
        if len(held) > 1:
            a, b = held[0][1].normal, held[1][1].normal
            if abs(a.dot(b.left())) > TOUCH: self.v = Vec(mpf(0), mpf(0)); return None
        return min(held, key=lambda h: h[0])[1:] if held else (None, None)

    def hold_resting(self, touches, A):
        """Direction and size of what the contacts leave of A, and the contact that it goes along."""
        ok = lambda w: all(w.dot(t.normal) >= -TOUCH for t in touches)
        if ok(A):
            beside = [t for t in touches if abs(A.dot(t.normal)) <= TOUCH and t.axis is not None]
            return A, beside[0] if beside and not A.is_zero() else None
        for t in touches:
            left = A - t.normal * A.dot(t.normal)
            if A.dot(t.normal) < 0 and ok(left): return left, t
        return Vec(mpf(0), mpf(0)), None

    def at_rest(self):
        if not (self.supported and self.v.is_zero()): return False
        A, B = self.pull()
        return self.hold_resting(self.board.touches(self.p), A)[0].length() <= B

    # --- smooth phases
    def phase(self, left):
        A, B = self.pull()
        touches = self.board.touches(self.p)
        if any(self.z < t.box.bottom for t in touches): raise Skip("under a wall")
        touch = corner = None
        direction = self.v
        if not self.v.is_zero():
            hold = self.hold_moving(touches, A, B)
            if hold: touch, corner = hold
        if self.v.is_zero():
            way, touch = self.hold_resting(touches, A)
            size = way.length()
            if size <= B and self.supported: self.time += left; return
            direction = way.unit() if size > 0 else Vec(mpf(0), mpf(0))
            corner = self.as_edge(touch, direction) if touch else None
        if self.supported and not self.board.is_over_floor(self.p + direction * mpf(10) ** -40): return self.take_off()
        if corner is not None: return self.pivot(touch, corner, direction, A, B, left)
        self.move(self.law(touch, direction, A, B), touch, left)

    def law(self, touch, direction, A, B):
        if touch is not None:
            tangent = touch.normal.left()
            if tangent.dot(direction) < 0: tangent = -tangent
            pull, speed = A.dot(tangent) - B, self.v.dot(tangent)
            slows = B > 0 and pull < 0
            return Parabola(self.p, tangent * speed, tangent * pull, -speed / pull if slows else mp.inf)
        if self.v.is_zero(): return Parabola(self.p, self.v, A - direction * B)
        if B == 0: return Parabola(self.p, self.v, A)
        return Resisted(self.p, self.v, A, B)

    def take_off(self):
        self.supported = False
        self.note("takeoff", -1, self.v.length(), self.v.length())

    def landing(self, left):
        if self.supported or self.board.top is None: return mp.inf
        h = self.z - self.board.rest_height
        if h < 0 or (h == 0 and self.vz <= 0): return mp.inf
        return (self.vz + mp.sqrt(self.vz ** 2 + 2 * self.gn * h)) / self.gn

    def move(self, law, touch, left):
        landing = self.landing(left)
        time = min(left, law.end, landing)
        end = law.parameter(time)
        marks = [end]
        if touch is not None: marks.append(self.face_end(law, touch, end))
        marks.append(self.first_contact(law, touch, end))
        if self.supported: marks.append(self.first_exit(law, end))
        s = min(m for m in marks if m is not None)
        exits = self.supported and marks[-1] == s
        if s != end: time = law.time(s)
        before = self.v.length()
        self.p, self.v = law.at(s)
        if touch is not None: self.stay_on(touch, marks[1] == s)
        self.fly(time, time == landing)
        self.time += time
        if time == law.end: self.v = Vec(mpf(0), mpf(0)); self.note("stop", -1, before, mpf(0))
        if exits: self.take_off()

    def fly(self, time, lands):
        if self.supported: return
        self.z = self.board.rest_height if lands else self.z + time * (self.vz - self.gn * time / 2)
        self.vz -= self.gn * time

    def stay_on(self, touch, at_end):
        """Coordinates on a face, and at its end, are exact."""
        place = [self.p.x, self.p.y]
        place[touch.axis] = touch.point[touch.axis] + touch.normal[touch.axis] * self.board.R
        if at_end:
            along = 1 - touch.axis
            place[along] = min(self.extent(touch), key=lambda c: abs(c - self.p[along]))
        self.p = Vec(*place)

    def face_end(self, law, touch, end):
        along = 1 - touch.axis
        times = []
        for side, c in zip((-1, 1), self.extent(touch)):
            # Smallest t > 0 at which the coordinate passes c outwards: (a/2) t^2 + v t + gap = 0 with the gap shrinking.
            gap, v, a = side * (c - law.p[along]), -side * law.v[along], -side * law.a[along]
            root2 = v * v - 2 * a * gap
            if root2 < 0: continue
            if v < 0: times.append(2 * gap / (mp.sqrt(root2) - v))
            elif a < 0: times.append((v + mp.sqrt(root2)) / -a)
        times = [t for t in times if t <= end and t > 0]
        return min(times) if times else None

    # --- first contact: sampled in double, refined in 50 digits
    def first_contact(self, law, touch, end):
        nodes = law.coarse().nodes(float(end) if end != mp.inf else mp.inf, 160)
        held = lambda b: touch is not None and self.is_behind(b, touch)
        boxes = [(b, c) for b, c in zip(self.board.walls, self.board.coarse_walls) if not held(b)]
        hits, seen = [], {}
        for b, _ in boxes:
            gap = (self.p - b.nearest(self.p)).length() - self.board.R
            if gap > NEAR: continue
            hit, seen[b.number] = self.look_near(law, b, gap if gap > TOUCH else mpf(0), end, nodes[1])
            if hit is not None: hits.append(hit)
        return self.earliest(law, boxes, seen, nodes, end, hits)

    def is_behind(self, box, touch):
        front = box.high if touch.normal[touch.axis] > 0 else box.low
        return (front[touch.axis] - touch.point[touch.axis]) * touch.normal[touch.axis] <= 0

    def gap(self, law, box, s):
        p, _ = law.at(s)
        return (p - box.nearest(p)).length() - self.board.R

    def look_near(self, law, box, gap, end, node):
        """Where gaps are too small for double: in 50 digits, by growing steps, until it is wide or closes. Returns the
        hit and how far it has looked."""
        point = box.nearest(self.p)
        touch = Touch(box, point, (self.p - point).unit())
        rate = touch.normal.dot(self.v)
        press = self.pressing(touch, self.v - touch.normal * rate)
        first = [law.parameter(t) for t in (gap / -rate if rate < -TOUCH and gap > 0 else 0,
                                            2 * rate / press if rate > TOUCH and press > 0 else 0,
                                            mp.sqrt(gap / abs(press)) if press else 0) if 0 < t < law.end]
        s = min(first + [mpf(node)]) / 8
        while self.gap(law, box, s) <= 0:
            s /= 2
            if s < mpf(10) ** -45: raise Skip("doesn't separate")
        if end == mp.inf: end = 5 * law.last()  # where it stands still to 50 digits
        while s < end and self.gap(law, box, s) < NEAR:
            new = min(end, s * mpf(1.2))
            if self.gap(law, box, new) < 0: return self.refine(law, box, s, new), mp.inf
            s = new
        return None, s if s < end else mp.inf

    def earliest(self, law, boxes, seen, nodes, end, hits):
        coarse, R = law.coarse(), float(self.board.R)
        states = [coarse.at(s) for s in nodes]
        limit = float(min(hits)) if hits else float("inf")
        before = {}
        for i, (p, v) in enumerate(states):
            found = list(hits) if limit <= nodes[i] else []
            for b, c in boxes:
                away = p - c.nearest(p)
                d = (away.x ** 2 + away.y ** 2) ** 0.5
                gap, rate = d - R, away.dot(v) / d if d > 0 else -1.0
                if i:
                    s = self.crossing(law, coarse, b, c, nodes[i - 1], nodes[i], before[b.number], (gap, rate),
                                      seen.get(b.number, mpf(0)))
                    if s is not None: found.append(s)
                before[b.number] = gap, rate
            if found: return min(found) if min(found) <= end else None
        return min(hits) if hits and min(hits) <= end else None

    def crossing(self, law, coarse, box, c, low, high, before, after, seen):
        if high <= seen: return None
        R = float(self.board.R)

        def look(s):
            p, v = coarse.at(s)
            away = p - c.nearest(p)
            d = (away.x ** 2 + away.y ** 2) ** 0.5
            return d - R, (away.dot(v) / d if d > 0 else -1.0)

        if after[0] >= -1e-11:
            if not before[1] < 0 < after[1]: return None
            a, b = low, high
            for _ in range(60):
                m = (a + b) / 2
                if look(m)[1] < 0: a = m
                else: b = m
            depth = look(b)[0]
            if depth > 1e-10: return None
            if depth > -1e-10: raise Skip("grazes")
            high = b
        if before[0] < -1e-11: raise Skip("missed a contact")
        a, b = max(mpf(low), seen), mpf(high)
        if self.gap(law, box, b) >= 0: return None
        if self.gap(law, box, a) < 0: a = max(a - (b - a), seen)  # double took it for contact
        if self.gap(law, box, a) < 0: raise Skip("missed a contact")
        return self.refine(law, box, a, b)

    def refine(self, law, box, low, high):
        def slope(s):
            p, v = law.at(s)
            away = p - box.nearest(p)
            distance = away.length()
            return -away.dot(v) / distance * law.slowness(s) if distance else 0
        return root(lambda s: -self.gap(law, box, s), low, high, slope)

    def first_exit(self, law, end):
        """Leaves the union of the floors: at the first border line behind which none covers the centre."""
        coarse, floors = law.coarse(), self.board.floors
        nodes = coarse.nodes(float(end) if end != mp.inf else mp.inf, 80)
        lines = [sorted({f.low[axis] for f in floors} | {f.high[axis] for f in floors}) for axis in (0, 1)]
        places = [coarse.at(s)[0] for s in nodes]
        for i in range(1, len(nodes)):
            for axis in (0, 1):
                a, b = places[i - 1][axis], places[i][axis]
                for c in lines[axis]:
                    if not min(a, b) - 1e-12 <= c <= max(a, b) + 1e-12: continue
                    sign = 1 if b > a else -1
                    f = lambda s: sign * (law.at(s)[0][axis] - c)
                    low, high = mpf(nodes[i - 1]), min(mpf(nodes[i]), end)
                    if f(high) <= 0 or f(low) > 0: continue
                    s = root(f, low, high, lambda s: sign * law.at(s)[1][axis] * law.slowness(s))
                    step = (high - low) * mpf(10) ** -9
                    ahead = law.at(s + step)[0]
                    if not self.board.is_over_floor(ahead):
                        self.exit = (axis, c)
                        return s
        return None

    # --- 6.2
    def pivot(self, touch, corner, direction, A, B, left):
        normal = touch.normal
        tangent = normal.left() if normal.left().dot(direction) > 0 else -normal.left()
        arc = Arc(corner, self.board.R, normal, tangent, self.v.length(), A, B)
        # The quarter ends where the component of the normal that shrinks has gone.
        shrinks = 0 if normal.x * tangent.x < 0 or (normal.x != 0 and tangent.x == 0 and normal.y == 0) else 1
        if normal.x != 0 and normal.y != 0: shrinks = 0 if normal.x * tangent.x < 0 else 1
        elif normal.y == 0: shrinks = 0
        else: shrinks = 1
        quarter = mp.atan2(abs(normal[shrinks]), abs(tangent[shrinks]))
        why, angle = self.end_of_arc(arc, quarter, touch)
        landing = self.landing(left)
        until = min(left, landing)
        time, y, rate = arc.swing(until, None if why == "stop" else angle)
        reached = time < until or y == angle
        before = arc.v0
        place, way = arc.at(y)
        if reached and why == "quarter":
            point = [place.x, place.y]
            point[shrinks] = corner[shrinks]
            point[1 - shrinks] = corner[1 - shrinks] + (self.board.R if place[1 - shrinks] > corner[1 - shrinks]
                                                        else -self.board.R)
            place = Vec(*point)
            way = Vec(*(mpf(0) if i == 1 - shrinks else mp.sign(way[i]) for i in (0, 1)))
        self.p, self.v = place, way * (rate * self.board.R)
        if rate == 0: self.v = Vec(mpf(0), mpf(0))
        self.fly(time, time == landing)
        self.time += time
        if rate == 0 and self.supported: self.note("stop", -1, before, mpf(0))
        if reached and why == "exit": self.take_off()

    def end_of_arc(self, arc, quarter, touch):
        """What ends the pivot, and at which angle."""
        coarse, R = arc.coarse(), float(self.board.R)
        count = 400
        others = [(b, c) for b, c in zip(self.board.walls, self.board.coarse_walls)
                  if (b.nearest(self.p) - arc.corner).length() > TOUCH]
        others = [(b, c) for b, c in others if (b.nearest(arc.corner) - arc.corner).length() < 3 * self.board.R]
        ends = [("quarter", quarter)]
        nodes = [float(quarter) * i / count for i in range(count + 1)]
        slope_v = lambda y: -2 * arc.R * (arc.At * mp.cos(y) - arc.An * mp.sin(y) - arc.B)
        for low, high in zip(nodes, nodes[1:]):
            if coarse.squared_speed(high) <= 0:
                ends.append(("stop", root(lambda y: -arc.squared_speed(y), mpf(low), mpf(high), slope_v)))
                break
        for low, high in zip(nodes, nodes[1:]):
            if coarse.lift(high) > 0 and arc.lift(mpf(high)) > 0:
                ends.append(("leave", root(arc.lift, mpf(low), mpf(high))))
                break
        gap = lambda b, y: (arc.at(y)[0] - b.nearest(arc.at(y)[0])).length() - arc.R
        for b, c in others:
            was = None
            for low, high in zip(nodes, nodes[1:]):
                p, t = coarse.at(high)
                away = p - c.nearest(p)
                now = (away.x ** 2 + away.y ** 2) ** 0.5 - R
                if now < -1e-13 and gap(b, mpf(high)) < 0:
                    if gap(b, mpf(low)) < 0 and low > 0: break
                    ends.append(("touch", root(lambda y: -gap(b, y), mpf(low), mpf(high))))
                    break
        if self.supported:
            for low, high in zip(nodes, nodes[1:]):
                if self.board.is_over_floor(arc.at(mpf(high))[0]): continue
                inside = lambda y: self.board.is_over_floor(arc.at(y)[0])
                a, b = mpf(low), mpf(high)
                for _ in range(170):
                    m = (a + b) / 2
                    if inside(m): a = m
                    else: b = m
                ends.append(("exit", b))
                break
        return min(ends, key=lambda e: e[1])

    def flags(self):
        x0, y0, x1, y1 = self.board.bounds
        out = not (x0 <= self.p.x <= x1 and y0 <= self.p.y <= y1)
        return (1 if self.at_rest() else 0) | (0 if self.supported else 2) | (4 if out else 0)
