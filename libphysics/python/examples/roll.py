#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rolls the ball of a level down a tilted board with every stepper; draws the ways if matplotlib is there.

Usage: roll.py LEVEL [PICTURE.png]
"""
import sys

import libphysics as lp

DT = 0.005  # s
STEPS = 200


def roll(id, scene):
    """The states after each step, shape (STEPS,)."""
    stepper = lp.Stepper(id, scene)
    params = stepper.params(gravity=lp.gravity_from_tilt(0.10, 0.05))
    return stepper.run(scene.start(), params, DT, STEPS, every=1).check().path


def draw(paths, scene, picture):
    try:
        import matplotlib  # type: ignore
    except ImportError:
        print("roll.py: no picture, because matplotlib isn't installed", file=sys.stderr)
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    for low, high in scene.boxes:
        if high[2] > scene.start()["position"][2]:
            pyplot.gca().add_patch(pyplot.Rectangle(low[:2], *(high - low)[:2], color="lightgrey"))
    for id, path in paths.items():
        pyplot.plot(path["position"][:, 0], path["position"][:, 1], label=id)
    pyplot.axis("equal")
    pyplot.xlabel("x / m")
    pyplot.ylabel("y / m")
    pyplot.legend(loc="upper left", bbox_to_anchor=(1, 1))
    pyplot.savefig(picture, bbox_inches="tight")


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__, file=sys.stderr)
        return 2
    scene = lp.Scene(arguments[0])
    paths = {info.id: roll(info.id, scene) for info in lp.steppers()}
    for id, path in paths.items():
        x, y, _ = path["position"][-1]
        print(f"{id:18} x {x:8.5f} m  y {y:8.5f} m")
    if len(arguments) > 1:
        draw(paths, scene, arguments[1])
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"roll.py: {error}")
