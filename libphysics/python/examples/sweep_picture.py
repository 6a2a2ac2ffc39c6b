#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How far the ball of a level rolls under a fixed tilt, over restitution and rolling friction: a table, or a picture.

Usage: sweep_picture.py LEVEL [PICTURE.png]
"""
import sys

import numpy as np

import libphysics as lp

RESTITUTIONS = np.linspace(0.0, 1.0, 41)
FRICTIONS = np.linspace(0.0, 0.05, 31)


def distances(scene):
    """Metres from the start after 5 s, shape (frictions, restitutions)."""
    stepper = lp.Stepper("velocity-verlet", scene)
    params = stepper.params(restitution_wall=RESTITUTIONS[None, :], rolling_friction=FRICTIONS[:, None],
                            gravity=lp.gravity_from_tilt(0.06, 0.03))
    run = stepper.run(scene.start(), params, 0.005, 1000, stop=lp.OUT).check()
    return np.linalg.norm(run.states["position"] - scene.start()["position"], axis=-1)


def draw(table, picture):
    import matplotlib  # type: ignore
    matplotlib.use("Agg")
    from matplotlib import pyplot
    pyplot.pcolormesh(RESTITUTIONS, FRICTIONS, table, shading="nearest")
    pyplot.xlabel("restitution of the walls")
    pyplot.ylabel("rolling friction")
    pyplot.colorbar(label="distance after 5 s / m")
    pyplot.savefig(picture, bbox_inches="tight")


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__, file=sys.stderr)
        return 2
    table = distances(lp.Scene(arguments[0]))
    if len(arguments) > 1:
        try:
            draw(table, arguments[1])
            return 0
        except ImportError:
            print("sweep_picture.py: no picture, because matplotlib isn't installed", file=sys.stderr)
    print("friction " + " ".join(f"e={e:4.2f}" for e in RESTITUTIONS[::10]))
    for friction, row in zip(FRICTIONS[::10], table[::10, ::10]):
        print(f"{friction:8.3f} " + " ".join(f"{d:6.3f}" for d in row))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except lp.PhysicsError as error:
        sys.exit(f"sweep_picture.py: {error}")
