#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes references.txt: what a ball does in the scenes of scenes.py, to 20 digits. Needs python3-mpmath; minutes.

Each step's result comes with its sensitivity: the largest growth until then of a small error of the first place or
velocity."""
import copy
import pathlib
from mpmath import mp, mpf, nstr
from ball import Ball, Board, Skip
from motion import Vec
from scenes import SCENES

SMALL = mpf(10) ** -12


def made(scene):
    board = Board(scene.boxes, scene.radius, scene.position)
    return Ball(board, scene.position, scene.velocity, scene.wall, scene.floor, scene.friction)


def state(ball): return [ball.p.x, ball.p.y, ball.z, ball.v.x, ball.v.y, ball.vz]


def disturbed(ball, member, by):
    other = copy.copy(ball)
    other.events = []
    setattr(other, member, getattr(ball, member) + by)
    other.p = ball.board.push_out(other.p)
    return other


def disturbances(ball):
    return [disturbed(ball, member, Vec(x * SMALL, y * SMALL)) for member in ("p", "v")
            for x, y in ((1, 0), (0, 1))]


def advance(balls, gravity, dt):
    """Those whose way can be followed: a disturbed one may graze what the ball itself doesn't."""
    kept = []
    for ball in balls:
        try: ball.step(gravity, dt)
        except Skip: continue
        kept.append(ball)
    return kept


def growth(ball, others):
    return max([abs(a - b) for other in others for a, b in zip(state(ball), state(other))] + [mpf(0)]) / SMALL


def digits(values): return " ".join(nstr(mpf(v), 20) for v in values)


def lines(scene):
    yield "scene " + scene.name
    yield "radius %r" % scene.radius
    for box in scene.boxes: yield "box " + " ".join(repr(float(c)) for c in box)
    yield "params %r %r %r" % (float(scene.wall), float(scene.floor), float(scene.friction))
    yield "ball " + " ".join(repr(float(c)) for c in scene.position + scene.velocity)
    ball = made(scene)
    others = disturbances(ball)
    for gravity, dt in scene.steps:
        yield "step " + " ".join(repr(float(c)) for c in gravity + (dt,))
        known = len(ball.events)
        ball.step(gravity, dt)
        others = advance(others, gravity, dt)
        for kind, box, time, before, after in ball.events[known:]:
            # Weaker impacts are those that 6.4 lets end early.
            if kind in ("impact", "landing") and abs(before) < mpf(10) ** -5: continue
            yield "event %s %d %s" % (kind, box, digits((time, before, after)))
        yield "state %s %d %s" % (digits(state(ball)), ball.flags(), nstr(growth(ball, others), 3))


def main():
    text = ["# Written by references.py, to 20 digits. Units: m, s.",
            "# box x0 y0 z0 x1 y1 z1 | params restitution_wall restitution_floor rolling_friction | ball position velocity",
            "# step gravity dt | event kind box time speed-before speed-after | state position velocity flags sensitivity"]
    for scene in SCENES: text += [""] + list(lines(scene))
    pathlib.Path(__file__).with_name("references.txt").write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    main()
