# SPDX-License-Identifier: MIT
"""The C structs as numpy dtypes, and the constants of the header."""
from __future__ import annotations

import numpy as np

#: Complete state of a ball: time (s), step, position (m), velocity (m/s), spin (rad/s), orientation (x y z w), flags.
state_dtype = np.dtype([("time", "f8"), ("step", "u8"), ("position", "f8", 3), ("velocity", "f8", 3), ("spin", "f8", 3),
                        ("orientation", "f8", 4), ("flags", "u8")], align=True)

#: Parameters of a step. Make them with Params, which knows defaults and ranges.
params_dtype = np.dtype([("struct_size", "u4"), ("model", "u4"), ("gravity", "f8", 3), ("restitution_wall", "f8"),
                         ("restitution_floor", "f8"), ("rolling_friction", "f8"), ("sliding_friction", "f8"),
                         ("wall_friction", "f8"), ("options", "u4"), ("reserved", "u4"), ("stepper", "f8", 8)], align=True)

#: An event during a step: time (s), point (m), normal, speeds (m/s), kind (EVENT_*), box.
event_dtype = np.dtype([("time", "f8"), ("point", "f8", 3), ("normal", "f8", 3), ("speed_before", "f8"),
                        ("speed_after", "f8"), ("kind", "u4"), ("box", "u4")], align=True)

#: Report of a step. Energies are per mass, J/kg; penetration in m.
report_dtype = np.dtype([("struct_size", "u4"), ("event_capacity", "u4"), ("events", np.uintp), ("event_count", "u4"),
                         ("events_lost", "u4"), ("substeps", "u4"), ("substep_cap", "u4"), ("passes", "u4"),
                         ("pass_cap", "u4"), ("penetration", "f8"), ("energy_before", "f8"), ("energy_after", "f8"),
                         ("lost_impact", "f8"), ("lost_rolling", "f8"), ("lost_slip", "f8"), ("energy_scheme", "f8")],
                        align=True)

#: A box near the ball: point (m), unit normal, gap (m, negative: penetration), box, feature (1 face, 2 edge, 3 corner,
#: 4 inside).
contact_dtype = np.dtype([("point", "f8", 3), ("normal", "f8", 3), ("gap", "f8"), ("box", "u4"), ("feature", "u4")],
                         align=True)

# Flags of a state, of its member's type.
AT_REST, AIRBORNE, OUT, SLIPPING = (np.uint64(flag) for flag in (1, 2, 4, 8))

# Models.
ROLLING, RIGID = 0, 1

# Kinds of event.
EVENT_IMPACT, EVENT_LANDING, EVENT_TAKEOFF, EVENT_STOP, EVENT_ROLL, EVENT_CONTACT, EVENT_RELEASE = range(1, 8)

#: phys_event.box of an event without one.
NO_BOX = 0xFFFFFFFF
