# SPDX-License-Identifier: MIT
"""libphysics for numpy: physics steps for one rolling ball in a maze of boxes.

    import libphysics as lp
    scene = lp.Scene("mazes/levels/01.txt")
    stepper = lp.Stepper("symplectic-euler", scene)
    params = stepper.params(gravity=lp.gravity_from_tilt(0.10, 0.05))
    after = stepper.step(scene.start(), params, 0.01).state          # one step
    run = stepper.run(scene.start(1000), params, 0.01, 500,          # a thousand balls, each with a tilt of its own
                      gravity=lp.gravity_from_tilt(np.linspace(-0.1, 0.1, 1000), 0.05)[:, None],
                      every=10, stop=lp.OUT, threads=2)

States are arrays of state_dtype: copy, save, compare and index them as numpy does. Units are SI, energies per mass; the
frame is the board's own, z up from its floor (docs/model.md of the library). The library is found by PHYSICS_LIBRARY, in
a build of the source tree, in the prefix of an installation, or by the system's loader.
"""
try:
    import numpy as _numpy  # noqa: F401
except ModuleNotFoundError as _missing:
    if _missing.name != "numpy":
        raise
    import sys as _sys
    raise ImportError(f"libphysics needs numpy, which {_sys.executable} doesn't have: install it there (Debian: python3-numpy, "
                      "by the source tree's ./setup --python), or call the python3 that has it") from None

from ._library import PhysicsError, lib as _lib
from ._params import Params, gravity_from_tilt
from ._records import (AIRBORNE, AT_REST, EVENT_CONTACT, EVENT_IMPACT, EVENT_LANDING, EVENT_RELEASE, EVENT_ROLL,
                       EVENT_STOP, EVENT_TAKEOFF, NO_BOX, OUT, RIGID, ROLLING, SLIPPING, contact_dtype, event_dtype,
                       params_dtype, report_dtype, state_dtype)
from ._run import Run
from ._scene import Scene, state_hash
from ._stepper import Info, Registry, Step, Stepper, steppers

#: Of the library that was found.
__version__: str = _lib.phys_version().decode()

__all__ = ["AIRBORNE", "AT_REST", "EVENT_CONTACT", "EVENT_IMPACT", "EVENT_LANDING", "EVENT_RELEASE", "EVENT_ROLL",
           "EVENT_STOP", "EVENT_TAKEOFF", "Info", "NO_BOX", "OUT", "Params", "PhysicsError", "RIGID", "ROLLING",
           "Registry", "Run", "SLIPPING", "Scene", "Step", "Stepper", "contact_dtype", "event_dtype",
           "gravity_from_tilt", "params_dtype", "report_dtype", "state_dtype", "state_hash", "steppers"]
