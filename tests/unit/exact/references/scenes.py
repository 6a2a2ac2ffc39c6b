# SPDX-License-Identifier: MIT
"""The scenes of references.txt, several of each kind: boxes seen from above, the ball, and gravity step by step."""
from types import SimpleNamespace

LEVEL = (0, 0, -9.75)
FLOOR = [(-2, -2, 2, 2)]
R = 0.0625


def scene(name, walls, position, velocity, steps, floors=FLOOR, radius=R, wall=0.5, floor=0.0, friction=0.0):
    """steps: (gx, gy, s). A position of two numbers lies on the floor, a velocity of two has no vertical part."""
    boxes = [(x0, y0, -1, x1, y1, 0) for x0, y0, x1, y1 in floors] + [(x0, y0, -1, x1, y1, 1) for x0, y0, x1, y1 in walls]
    position = tuple(position) + ((radius,) if len(position) == 2 else ())
    velocity = tuple(velocity) + ((0,) if len(velocity) == 2 else ())
    return SimpleNamespace(name=name, boxes=boxes, radius=radius, position=position, velocity=velocity, wall=wall,
                           floor=floor, friction=friction, steps=[((gx, gy, -9.75), dt) for gx, gy, dt in steps])


def row_of(count, x, y, width, height):
    return [(x + i * width, y, x + (i + 1) * width, y + height) for i in range(count)]


ROOM = [(-0.125, -0.125, 1.125, 0), (-0.125, 1, 1.125, 1.125), (-0.125, 0, 0, 1), (1, 0, 1.125, 1)]
DECIMAL_ROOM = [(-0.1, -0.1, 1.1, 0), (-0.1, 1, 1.1, 1.1), (-0.1, 0, 0, 1), (1, 0, 1.1, 1)]
BELOW = [(-1, -1, 0, 0)]  # a wall whose face y = 0 ends at x = 0
POSTS = ROOM + [(0.25, 0.25, 0.2578125, 0.2578125), (0.625, 0.5, 0.6328125, 0.515625), (0.375, 0.75, 0.390625, 0.7578125),
                (0.75, 0.1875, 0.7578125, 0.1953125)]
TILED = row_of(8, 0, -0.125, 0.125, 0.125) + [(0.5, 0, 0.625, 0.125), (0.625, 0, 0.75, 0.125)]
COLUMNS = [tile for i in range(8) for tile in row_of(1, 0.0625 * i, -0.0625, 0.0625, 0.0625) +
           (row_of(1, 0.0625 * i, -0.125, 0.0625, 0.0625) if i % 2 else [])]
HOLE = [(0, 0, 0.5, 0.5), (0.5, 0, 1, 0.25), (0, 0.5, 0.5, 1), (0.5, 0.5, 1, 1), (0.75, 0.25, 1, 0.5)]

SCENES = [
    # 3.1
    scene("arc: turns round while it slows", [], (0, 0), (0.5, 0.25), [(-0.75, 0.25, 2), (0.5, 0.5, 0.3)], friction=0.01),
    scene("arc: stops", [], (0, 0), (0.3, -0.4), [(0.25, 0.125, 1), (0.25, 0.125, 2)], friction=0.05),
    # 6.1
    scene("face: slides past its end and leaves", BELOW, (-0.25, R), (0.25, 0), [(0.5, -0.25, 1), (0.25, 0.5, 0.25)]),
    scene("face: stops, waits, starts back", BELOW, (-0.25, R), (0.25, 0), [(0, -0.5, 2), (-0.0625, -0.5, 0.5), (-0.5, -0.5, 0.5)],
          friction=0.02),
    scene("face: released by gravity, and back", BELOW, (-0.75, R), (0.25, 0), [(0.125, -0.5, 0.25), (0.125, 0.5, 0.25), (0.125, -1, 0.75)],
          friction=0.005),
    scene("face: three that overlap are one", [(-0.75, -0.25, -0.25, 0), (-0.375, -0.5, 0.125, 0), (0, -0.25, 0.5, 0)], (-0.625, R),
          (0.25, 0), [(0.75, -0.5, 1), (-1.5, -0.5, 0.5)], friction=0.003),
    scene("face: T joint", [(-0.5, -0.25, 0.25, 0), (0.25, -0.5, 0.5, 0.5)], (-0.25, R), (0.5, 0), [(0.5, -0.5, 1), (0.25, 0.5, 1)]),
    scene("face: L joint, then round its end", [(-0.5, -0.25, 0, 0), (0, -1, 0.125, 0)], (-0.25, R), (0.125, 0), [(0.25, -1, 1.75)],
          friction=0.003),
    # 5.6
    scene("tiles: along flush walls into a step", TILED, (0.1875, R), (0.25, 0), [(0.5, -0.5, 0.75), (-0.5, -0.25, 1)]),
    scene("tiles: across their joints in decimals", row_of(7, 0, -0.1, 0.1, 0.1) + row_of(3, 0.4, 0, 0.1, 0.1), (0.13, 0.31), (0.2, -0.4),
          [(0.3, -0.4, 0.9), (-0.7, -0.2, 0.8), (0.1, -0.6, 0.5)], radius=0.05, wall=0.3, friction=0.004),
    scene("tiles: floor of nine", [(-0.75, 0.75, 0.75, 1)], (-0.5, -0.5), (0.5, 0.25), [(0.25, 0.75, 1), (-0.5, 0.5, 0.5)],
          floors=[(-0.75 + 0.5 * i, -0.75 + 0.5 * j, -0.25 + 0.5 * i, -0.25 + 0.5 * j) for i in range(3) for j in range(3)], friction=0.01),
    scene("tiles: bounces along columns of unlike length", COLUMNS, (0.1875, 0.125), (-0.265625, 0), [(0.25, -1.5, 1.5), (-0.5, -1, 0.5)],
          wall=0.75, friction=0.003),
    # 6.2
    scene("pivot: flies off", BELOW, (-0.125, R), (0.0625, 0), [(0.0625, -0.75, 2)]),
    scene("pivot: flies off under resistance", BELOW, (-0.125, R), (0.125, 0), [(0.0625, -0.75, 1.5)], friction=0.003),
    scene("pivot: from rest on the edge, back over the face", BELOW, (0, R), (0, 0), [(-0.125, -0.75, 0.25), (0.25, -0.75, 0.5), (-0.5, -0.75, 0.5)]),
    scene("pivot: to the next face", BELOW, (-0.0625, R), (0.0625, 0), [(-0.5, -0.5, 0.05), (0.0625, -1, 0.3), (-1.5, -0.125, 0.5)]),
    scene("pivot: to the next face and along it", BELOW, (-0.03125, R), (0.125, 0), [(-0.0625, -1, 0.25), (-1, -0.375, 1)], friction=0.002),
    scene("pivot: stiction holds it on the edge", BELOW, (-0.03125, R), (0.0625, 0), [(-0.03125, -0.75, 2), (0.5, -0.5, 0.25)], friction=0.02),
    scene("pivot: swings back", BELOW, (-0.015625, R), (0.09375, 0), [(-0.25, -0.75, 0.3), (-0.25, -0.75, 0.5)]),
    scene("pivot: swings back under resistance", BELOW, (-0.015625, R), (0.09375, 0), [(-0.25, -0.75, 1)], friction=0.003),
    scene("pivot: into the next wall", BELOW + [(0.09375, -1, 1, 0.25)], (-0.125, R), (0.125, 0), [(0.125, -0.75, 1.5)], wall=0.125),
    scene("pivot: too fast for it", BELOW, (-0.125, R), (0.5, 0), [(0.125, -1.5, 0.75)]),
    # 6.3
    scene("rest: stiction on the floor", [], (0, 0), (0, 0), [(0.0625, 0.0625, 1), (0.125, 0, 0.5), (0.0625, 0, 2)], friction=0.01),
    scene("rest: leans on a wall, gravity turns", BELOW, (-0.5, R), (0, 0), [(0.0625, -1.5, 1), (0.125, -1.5, 0.5), (0, 0.125, 0.5)], friction=0.01),
    scene("rest: in a corner, and out of it", ROOM, (R, R), (0, 0), [(-1, -0.5, 0.5), (0.5, -0.5, 0.25), (-1.5, -0.25, 1), (1, 1, 0.25)]),
    scene("rest: between two edges", [(-1, -1, 0, 0), (0.09375, -1, 1, 0)], (0.0625, 0.125), (0, 0), [(0, -1, 2), (0.25, -1, 0.5), (2, -1, 0.25)],
          wall=0.0625),
    scene("rest: edge and face", [(-1, -1, 0, 0), (0.09375, -1, 1, 1)], (0, 0.25), (0.25, -0.25), [(0.25, -1, 2)], wall=0.0625, friction=0.01),
    # 6.4
    scene("Zeno: straight down", BELOW, (-0.5, 0.125), (0, 0), [(0, -0.75, 4), (0.5, -0.5, 0.5)], wall=0.75),
    scene("Zeno: straight down under resistance", BELOW, (-0.5, 0.125), (0, 0), [(0, -0.75, 4)], wall=0.75, friction=0.02),
    scene("Zeno: on its way along the wall", BELOW, (-0.75, 0.125), (0.25, 0), [(0.0625, -0.75, 2)], wall=0.5, friction=0.005),
    scene("Zeno: hardly elastic", BELOW, (-0.75, 0.25), (0.125, 0.25), [(0, -0.75, 1.5)], wall=0.01, friction=0.01),
    scene("Zeno: long", BELOW, (-0.75, 0.125), (0.0625, 0), [(0.03125, -1.5, 4), (0.5, -1.5, 0.5)], wall=0.9),
    scene("Zeno: never, elastic", BELOW, (-0.75, 0.125), (0.0625, 0), [(0, -1.5, 2)], wall=1.0),
    scene("Zeno: at two walls of a corner", ROOM, (0.25, 0.1875), (0, 0), [(-0.5, -0.75, 2), (-0.5, 0.25, 0.5)], wall=0.5),
    scene("Zeno: on a wall's edge", BELOW, (0.03125, 0.125), (0, 0), [(-0.5, -1, 0.75)], wall=0.25, friction=0.005),
    # 5.5
    scene("corner: both walls at once", ROOM, (0.25, 0.25), (-0.5, -0.5), [LEVEL[:2] + (1,)], wall=0.75),
    scene("corner: inelastic", DECIMAL_ROOM, (0.2, 0.3), (-0.3, -0.7), [(-0.4, -0.1, 0.5), (0.6, -0.3, 0.5)], radius=0.05, wall=0.0),
    scene("corner: off centre", ROOM, (0.25, 0.1875), (-0.75, -0.5), [(-0.25, -0.5, 0.75), (0.5, -0.5, 0.5)], wall=0.75, friction=0.01),
    scene("posts: four", POSTS, (0.125, 0.125), (0.5, 0.4375), [(0.25, 0.5, 0.5), (-0.5, 0.125, 0.25), (0.125, -0.75, 0.5)], wall=0.75),
    scene("posts: in decimals", DECIMAL_ROOM + [(0.3, 0.3, 0.31, 0.32), (0.7, 0.4, 0.72, 0.41), (0.5, 0.7, 0.51, 0.71)], (0.15, 0.2), (0.4, 0.5),
          [(0.6, 0.2, 0.7), (-0.3, 0.9, 0.4), (-0.4, -0.8, 0.6)], radius=0.03, wall=0.8, friction=0.003),
    scene("posts: gravity turns every 1/256 s", POSTS, (0.15, 0.3125), (0.75, -0.5), [(0.75, 0.25, 1 / 256), (-0.5, -0.75, 1 / 256)] * 8,
          wall=0.75, friction=0.02),
    # 7
    scene("fall: over the outer edge", [], (0.75, 0.125), (1, 0.125), [(0.5, 0.25, 0.5), (0.25, 0, 0.25)], floors=[(0, 0, 1, 1)], friction=0.01),
    scene("fall: through a hole of the floor", [], (0.375, 0.375), (1, 0), [(0.125, 0, 0.25)], floors=HOLE),
    scene("fall: over the joints of unlike tiles to the edge", [], (0.125, 0.375), (0.5, 0.21875), [(0.375, 0.25, 1.5)], floors=HOLE, friction=0.01),
    scene("fall: past a wall on the way down", [(1.25, 0, 1.5, 1)], (0.75, 0.25), (1, 0.25), [(0.5, 0, 0.25), (-1, 0, 0.25)], floors=[(0, 0, 1, 1)]),
    scene("fall: dropped, stays down", [], (0, 0, 0.5), (0.25, -0.125), [(0.25, 0.5, 0.5), (-0.25, 0, 0.5)], friction=0.01),
    scene("fall: hops to a rest", [], (0, 0, 0.25), (0.25, 0.125, 0.5), [(0.25, 0.125, 2)], floor=0.5, friction=0.01),
    scene("fall: hops along a wall", BELOW, (-0.75, 0.125, 0.25), (0.25, -0.25), [(0.25, -0.5, 1), (0.25, -0.25, 0.5)], wall=0.5, floor=0.5),
    # 5.7
    scene("inside: a face", BELOW, (-0.5, 0.03125), (0.25, 0.125), [(0.25, -0.5, 1)]),
    scene("inside: an edge, in decimals", BELOW, (0.02, 0.03), (0.1, -0.2), [(0.2, -0.3, 0.5)], radius=0.05),
    scene("inside: the centre too", ROOM, (0.5, -0.03125), (0.25, 0), [(0, 0.25, 1)]),
]
