# SPDX-License-Identifier: MIT
"""What a run of many balls and steps gives."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._library import PhysicsError, lib


class _Run(NamedTuple):
    states: NDArray[Any]
    path: NDArray[Any] | None
    steps_done: NDArray[Any]
    statuses: NDArray[Any]
    impacts: NDArray[Any] | None = None
    energy_lost: NDArray[Any] | None = None


class Run(_Run):
    """Result of `Stepper.run`. `batch` is the common shape of states, params and gravity.

    states: the last good state of each ball, batch. path: every k-th state, batch + (steps // k,), or None.
    steps_done, statuses: batch; a ball whose status is below 0 failed in the step after its last good state.
    impacts: batch, or None; the number of hits of walls (EVENT_IMPACT, no landings; but of a step with more than 64 events,
    all after the 64th are counted). energy_lost: batch, or None; what was lost in impacts, landings, rolling and slip, J/kg.
    """

    _reason = ""  # what `step` says where the first of the balls that failed did

    def check(self) -> "Run":
        """Raises PhysicsError if a ball failed, with the number of the first of them and what was wrong; or returns itself."""
        if np.count_nonzero(self.statuses):
            ball = np.flatnonzero(self.statuses)[0]
            status = int(self.statuses.flat[ball])
            reason = self._reason or lib.phys_status_text(status).decode()
            raise PhysicsError(status, f"ball {ball} fails in step {self.steps_done.flat[ball]}: {reason}")
        return self

    def __repr__(self) -> str:
        kept = "" if self.path is None else f", a path of {self.path.shape[-1]} states each"
        return f"<Run, shape {self.states.shape}{kept}, {np.count_nonzero(self.statuses)} failed>"
