#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rolls the ball of a level down a tilted board with every stepper; draws the ways if matplotlib is there.

Usage: roll.py LEVEL [PICTURE.png]
"""
import sys

import physics

DT = 0.005  # s
STEPS = 200


def roll(registry, stepper_id, scene):
    """The (x, y) of each step."""
    params = physics.default_params()
    registry.init_params(stepper_id, params)
    params.gravity = physics.gravity_from_tilt(0.10, 0.05)
    stepper = physics.Stepper(stepper_id, scene, registry)
    state = scene.start()
    way = [(state.position.x, state.position.y)]
    for _ in range(STEPS):
        stepper.step(params, DT, state)
        way.append((state.position.x, state.position.y))
    return way


def draw(ways, scene, picture):
    try:
        import matplotlib
    except ImportError:
        print("roll.py: no picture, because matplotlib isn't installed", file=sys.stderr)
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    walls = [box for box in scene.boxes if box.max.z > scene.start().position.z]
    for box in walls:
        pyplot.gca().add_patch(pyplot.Rectangle((box.min.x, box.min.y), box.max.x - box.min.x, box.max.y - box.min.y,
                                                color="lightgrey"))
    for stepper_id, way in ways.items():
        pyplot.plot(*zip(*way), label=stepper_id)
    pyplot.axis("equal")
    pyplot.xlabel("x / m")
    pyplot.ylabel("y / m")
    pyplot.legend(loc="upper left", bbox_to_anchor=(1, 1))
    pyplot.savefig(picture, bbox_inches="tight")


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        scene = physics.Scene(arguments[0])
        registry = physics.Registry()
        ways = {stepper_id: roll(registry, stepper_id, scene) for stepper_id in registry.ids()}
    except physics.PhysicsError as error:
        print(f"roll.py: {error}", file=sys.stderr)
        return 1
    for stepper_id, way in ways.items():
        print(f"{stepper_id:18} x {way[-1][0]:8.5f} m  y {way[-1][1]:8.5f} m")
    if len(arguments) > 1:
        draw(ways, scene, arguments[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
