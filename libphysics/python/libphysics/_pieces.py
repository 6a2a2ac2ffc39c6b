# SPDX-License-Identifier: MIT
"""Runs of many balls and steps in pieces, between which the interpreter heeds signals."""
from __future__ import annotations

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from ctypes import byref, c_char
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._library import Batch, Error, Handle, address, check, lib
from ._records import state_dtype
from ._run import Run

_STEPS = 1_048_576  # of all balls in a piece: 20 ms in lanes, half a second by `exact`
_LANES = 8  # balls that the library moves together
_SKIPPED = 0.25e-9  # s: no step is computed within it, so the library skipped them, as it does where nothing changes
_LONGEST = 0.05  # s, of a piece that larger ones follow
_GROWTH = 16


def viewed(place: int, dtype: np.dtype[Any]) -> NDArray[Any]:
    """The element at an address."""
    memory = (c_char * dtype.itemsize).from_address(place)
    return np.ndarray(dtype.shape, dtype.base, memoryview(memory))


def run_piece(handle: Handle, batch: Batch, first: int, count: int) -> None:
    error = Error()
    check(lib.phys_batch_run(handle, byref(batch), first, count, byref(error)), error)


def run_ranges(handles: list[Handle], batch: Batch, run: Run) -> None:
    """One range of the balls for each of the library's steppers, each in a thread."""
    ends = [batch.ball_count * i // len(handles) for i in range(len(handles) + 1)]
    if len(handles) == 1 and batch.ball_count * batch.step_count <= _STEPS:
        return run_piece(handles[0], batch, 0, batch.ball_count)
    pieces = _Pieces(batch, run)
    if len(handles) == 1:
        return pieces.run(handles[0], *ends)
    with ThreadPoolExecutor(len(handles)) as pool:
        try:
            list(pool.map(pieces.run, handles, ends, ends[1:]))
        finally:
            pieces.interrupted.set()  # or leaving the pool would wait for all steps after a signal


class _Pieces:
    """A batch whose ranges are run piece by piece."""

    def __init__(self, batch: Batch, run: Run) -> None:
        self.interrupted = threading.Event()
        self._batch = Batch.from_buffer_copy(batch)
        self._states, self._statuses, self._done = (each.reshape(-1) for each in (run.states, run.statuses, run.steps_done))
        self._paths = None if run.path is None or not batch.path else run.path.reshape(self._states.size, -1)
        self._now = np.zeros_like(self._done)  # steps of the balls in their latest piece
        self._batch.steps_done = address(self._now)

    def run(self, handle: Handle, begin: int, end: int) -> None:
        todo = [(begin, end, 0, _STEPS)]
        while todo and not self.interrupted.is_set():
            begin, end, step, size = todo.pop()
            left = self._batch.step_count - step
            if left == 0 or begin == end:
                continue
            some = begin + max(_LANES, size // left // _LANES * _LANES)
            if some < end:
                todo.append((some, end, step, size))
                end = some
            began = time.perf_counter()
            length = self._run_piece(handle, begin, end, step, min(left, max(1, size // (end - begin))))
            if time.perf_counter() - began < min(_SKIPPED * length, _LONGEST):
                size *= _GROWTH
            todo += [(first, last, step + length, size) for first, last in self._still_running(begin, end)]

    def _run_piece(self, handle: Handle, begin: int, end: int, step: int, length: int) -> int:
        """Runs some steps, at most `length`, and returns how many."""
        piece, every = Batch.from_buffer_copy(self._batch), self._batch.path_every
        keeps = self._paths is not None and step % every == 0 and length >= every
        if keeps:  # some states of the path
            length -= length % every
            piece.path += step // every * state_dtype.itemsize
        elif self._paths is not None:  # part of the way to the next one
            length = min(length, every - step % every)
            piece.path = None
        piece.step_count = length
        if piece.gravity:
            piece.gravity += step * piece.gravity_step_stride
        run_piece(handle, piece, begin, end - begin)
        balls = slice(begin, end)
        self._done[balls] += self._now[balls]
        if self._paths is not None and not keeps and (step + length) % every == 0:
            self._paths[balls, (step + length) // every - 1] = self._states[balls]
        return length

    def _still_running(self, begin: int, end: int) -> list[tuple[int, int]]:
        """Ranges of the balls that neither failed nor are done; the paths of the others end here."""
        ended = self._statuses[begin:end] != 0
        if self._batch.stop_flags:
            ended |= (self._states["flags"][begin:end] & np.uint64(self._batch.stop_flags)) != 0
        if not ended.any():
            return [(begin, end)]
        if self._paths is not None:
            for ball in begin + np.flatnonzero(ended):
                self._paths[ball, self._done[ball] // np.uint64(self._batch.path_every):] = self._states[ball]
        edges = begin + np.flatnonzero(np.diff(ended, prepend=True, append=True))
        return list(zip(edges[::2].tolist(), edges[1::2].tolist()))
