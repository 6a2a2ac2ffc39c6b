# SPDX-License-Identifier: MIT
"""Steppers: one step, or many balls and many steps at once."""
from __future__ import annotations

import ctypes
import os
import threading
from concurrent.futures import ThreadPoolExecutor
from ctypes import byref, c_double, c_void_p
from typing import Any, NamedTuple

import numpy as np

from ._library import (SCAN_FUNCTION, Batch, Error, PhysicsError, Requirements, StepperInfo, address, check, lib)
from ._params import Params, rows_of
from ._records import event_dtype, params_dtype, report_dtype, state_dtype
from ._scene import Scene

_STAGES = ("vertical motion", "substeps", "rolling resistance", "slip and spin", "grid", "orientation")


class Info(NamedTuple):
    """What is known of a stepper before it is made. file: of the plugin, "" for built-in ones."""

    id: str
    name: str
    version: str
    summary: str
    file: str
    rows: tuple[str, ...]


class Step(NamedTuple):
    """One step: the state after it (0-d, state_dtype), its report (0-d, report_dtype) and its events (event_dtype)."""

    state: np.ndarray
    report: np.ndarray
    events: np.ndarray


class Run(NamedTuple):
    """What `Stepper.run` gives. `batch` is the common shape of states, params and gravity.

    states: the last good state of each ball, batch. path: every k-th state, batch + (steps // k,), or None.
    steps_done, statuses: batch; a ball whose status is below 0 failed in the step after its last good state.
    impacts, energy_lost: batch; how many impacts a ball had, and what it lost to impacts, rolling and slip, J/kg, as the
    reports of its steps would say; or None.
    """

    states: np.ndarray
    path: np.ndarray | None
    steps_done: np.ndarray
    statuses: np.ndarray
    impacts: np.ndarray | None = None
    energy_lost: np.ndarray | None = None

    def check(self) -> "Run":
        """Raises PhysicsError if a ball failed, with the number of the first of them; returns itself otherwise."""
        failed = np.flatnonzero(self.statuses)
        if failed.size:
            ball = failed[0]
            status = int(self.statuses.flat[ball])
            text = lib.phys_status_text(status).decode()
            raise PhysicsError(status, f"ball {ball} fails in step {self.steps_done.flat[ball]}: {text}")
        return self


class Registry:
    """The steppers that can be made: the built-in ones, those of plugin files, and those that a scan finds.

    scan: also look into the folders of PHYS_PLUGIN_PATH and the one beside the library; `refused` says what was wrong
    with the files that weren't taken.
    """

    __slots__ = ("_handle", "refused", "__weakref__")
    refused: list[str]

    def __init__(self, *plugins: str | os.PathLike[str], scan: bool = False) -> None:
        self._handle, error = c_void_p(), Error()
        self.refused = []
        check(lib.phys_registry_create(byref(self._handle), byref(error)), error)
        for plugin in plugins:
            check(lib.phys_registry_load_file(self._handle, os.fsencode(plugin), byref(error)), error)
        if scan:
            hear = SCAN_FUNCTION(lambda _, __, status, text: self.refused.append(text.decode()) if status else None)
            check(lib.phys_registry_scan(self._handle, None, hear, None, byref(error)), error)

    def __del__(self) -> None:
        if self._handle:
            lib.phys_registry_destroy(self._handle)

    def steppers(self) -> list[Info]:
        """All of them, from crude to exact, then those of plugins."""
        return [_describe(self.info(index)) for index in range(lib.phys_registry_count(self._handle))]

    def info(self, index: int) -> StepperInfo:
        info = StepperInfo()
        check(lib.phys_registry_info(self._handle, index, byref(info)))
        return info

    def __repr__(self) -> str:
        return f"<Registry, {', '.join(info.id for info in self.steppers())}>"


def _describe(info: StepperInfo) -> Info:
    texts = (info.id, info.name, info.version, info.summary, info.file)
    return Info(*(text.decode() for text in texts), tuple(row.id.decode() for row in rows_of(info)))


def steppers() -> list[Info]:
    """The built-in steppers, from crude to exact."""
    return Registry().steppers()


class Stepper:
    """Computes steps in one scene.

    id: of a built-in stepper or one of the plugin's. plugin: path of a shared object, or a Registry. It keeps nothing
    from one step to the next. Python threads may share it: they take turns; `run` uses threads of its own.
    """

    __slots__ = ("_scene", "_registry", "_handles", "_info", "_lock", "__weakref__")

    def __init__(self, id: str, scene: Scene, plugin: str | os.PathLike[str] | Registry | None = None) -> None:
        self._handles: list[c_void_p] = []
        self._lock = threading.Lock()
        self._scene = scene  # it and the registry outlive the steppers made from them
        self._registry = plugin if isinstance(plugin, Registry) else Registry(*([] if plugin is None else [plugin]))
        self._info, error = StepperInfo(), Error()
        check(lib.phys_registry_find(self._registry._handle, id.encode(), byref(self._info), byref(error)), error)
        self._handle(0)

    def __del__(self) -> None:
        for handle in self._handles:
            lib.phys_stepper_destroy(handle)

    def _handle(self, index: int) -> c_void_p:
        """The library's stepper for thread `index`."""
        while len(self._handles) <= index:
            handle, error = c_void_p(), Error()
            check(lib.phys_stepper_create(self._registry._handle, self._info.id, self._scene._handle, byref(handle),
                                          byref(error)), error)
            self._handles.append(handle)
        return self._handles[index]

    @property
    def info(self) -> Info:
        return _describe(self._info)

    @property
    def scene(self) -> Scene:
        return self._scene

    def params(self, **values: Any) -> Params:
        """Params that know this stepper's own names, too."""
        return Params(rows_of(self._info), **values)

    def step(self, state: np.ndarray, params: Params | np.ndarray, dt: float, *, events: int = 256) -> Step:
        """One step of dt seconds (0 .. 2^100) with its report and up to `events` events.

        state: one element of state_dtype; it stays as it is. params: one set. Raises PhysicsError.
        """
        before, obeyed = _one(state, state_dtype, "state"), _one(_record(params), params_dtype, "params")
        after, report = np.empty((), state_dtype), np.zeros((), report_dtype)
        happened, error = np.zeros(events, event_dtype), Error()
        check(lib.phys_report_init(address(report), report_dtype.itemsize))
        report["events"], report["event_capacity"] = address(happened) if events else 0, events
        with self._lock:
            status = lib.phys_step(self._handle(0), address(obeyed), dt, address(before), address(after),
                                   address(report), byref(error))
        check(status, error)
        report["events"] = 0
        return Step(after, report, happened[:int(report["event_count"])])

    def run(self, states: np.ndarray, params: Params | np.ndarray, dt: float, steps: int, *, gravity: Any = None,
            every: int = 0, stop: int | np.integer = 0, threads: int = 1, tally: bool = False,
            out: np.ndarray | None = None) -> Run:
        """Many balls, many steps: for each ball the bits that `step` gives in a loop.

        states: state_dtype, any shape. params: one set or an array of them. gravity: m/s^2, in place of that of params:
        (3,) for all, or (..., 1, 3) for each ball, or (..., steps, 3) for each ball and step. The shapes of states and
        params and gravity's `...` broadcast to the batch. every: keep every k-th state as `path`; 0: none. stop: a ball
        is done once its state has one of these flags, for instance OUT. threads: how many run, with the interpreter's
        lock released. tally: whether `impacts` and `energy_lost` are wanted; steps are slower then. out: states of the
        batch's shape that are written, for instance `states` itself.
        Wrong arguments raise PhysicsError; a ball that fails has its status in the result (`Run.check` raises).
        """
        for name, value in (("steps", steps), ("every", every), ("stop", stop), ("threads", threads)):
            if value < 0 or value != int(value):
                raise ValueError(f"{name} is {value}; expected a whole number that isn't negative")
        record = _record(params)
        pull = None if gravity is None else _gravity(gravity, steps)
        shape = np.broadcast_shapes(np.shape(states), record.shape, () if pull is None else pull.shape[:-2])
        result = _output(states, shape, out)
        path = np.empty(shape + (steps // every,), state_dtype) if every > 0 else None
        done, statuses = np.zeros(shape, "u8"), np.zeros(shape, "i4")
        batch = Batch()
        check(lib.phys_batch_init(byref(batch), ctypes.sizeof(batch)))
        batch.stop_flags, batch.dt, batch.step_count, batch.ball_count = int(stop), dt, steps, result.size
        record, batch.params_stride = _per_ball(record, shape, 0)
        batch.params = address(record)
        if pull is not None and steps > 0:
            pull, batch.gravity_ball_stride = _per_ball(pull, shape, 2)
            batch.gravity, batch.gravity_step_stride = address(pull), pull.strides[-2] if pull.shape[-2] > 1 else 0
        batch.states, batch.states_stride = address(result), state_dtype.itemsize
        if path is not None and path.size:
            batch.path, batch.path_every = address(path), every
            batch.path_ball_stride = path.shape[-1] * state_dtype.itemsize
        batch.steps_done, batch.statuses = address(done), address(statuses)
        impacts = np.zeros(shape, "u8") if tally else None
        energy_lost = np.zeros(shape, "f8") if tally else None
        if impacts is not None and energy_lost is not None:
            batch.impacts, batch.energy_lost = address(impacts), address(energy_lost)
        if result.size:
            with self._lock:
                self._run_ranges(batch, max(1, min(threads, result.size)))
        return Run(result, path, done, statuses, impacts, energy_lost)

    def _run_ranges(self, batch: Batch, threads: int) -> None:
        def run(index: int) -> None:
            first, end = (batch.ball_count * i // threads for i in (index, index + 1))
            error = Error()
            check(lib.phys_batch_run(handles[index], byref(batch), first, end - first, byref(error)), error)

        handles = [self._handle(index) for index in range(threads)]
        if threads == 1:
            return run(0)
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(run, range(threads)))

    def energy(self, state: np.ndarray, params: Params | np.ndarray) -> float:
        """Energy per mass, J/kg."""
        one, obeyed, value = _one(state, state_dtype, "state"), _one(_record(params), params_dtype, "params"), c_double()
        check(lib.phys_energy(self._scene._handle, address(obeyed), address(one), byref(value)))
        return value.value

    def requirements(self, state: np.ndarray, params: Params | np.ndarray, dt: float) -> dict[str, tuple[bool, str]]:
        """For each stage of the step with these arguments whether it runs, and why."""
        one, obeyed = _one(state, state_dtype, "state"), _one(_record(params), params_dtype, "params")
        told, error = Requirements(), Error()
        with self._lock:
            status = lib.phys_stepper_requirements(self._handle(0), address(obeyed), dt, address(one), byref(told),
                                                   byref(error))
        check(status, error)
        return {stage: (bool(told.stages >> i & 1), told.reasons[i].value.decode()) for i, stage in enumerate(_STAGES)}

    def __repr__(self) -> str:
        return f"<Stepper '{self.info.id}', version {self.info.version}, in {self._scene!r}>"


def _record(params: Params | np.ndarray) -> np.ndarray:
    if isinstance(params, Params):
        return params.record
    record = np.asarray(params)
    if record.dtype != params_dtype:
        raise TypeError(f"params has the dtype {record.dtype}; expected Params or params_dtype")
    return record


def _states(states: np.ndarray, name: str) -> np.ndarray:
    array = np.asarray(states)
    if array.dtype != state_dtype:
        raise TypeError(f"{name} has the dtype {array.dtype}; expected state_dtype")
    return array


def _one(array: np.ndarray, dtype: np.dtype, name: str) -> np.ndarray:
    array = np.asarray(array)
    if array.dtype != dtype or array.size != 1:
        raise TypeError(f"{name}: {array.size} elements of {array.dtype}; expected one of {name}_dtype")
    return np.ascontiguousarray(array)


def _gravity(gravity: Any, steps: int) -> np.ndarray:
    array = np.asarray(gravity, "f8")
    array = array.reshape(1, 3) if array.shape == (3,) else array
    if array.ndim < 2 or array.shape[-1] != 3 or array.shape[-2] not in (1, steps):
        raise ValueError(f"gravity has the shape {array.shape}; expected (3,), (..., 1, 3) or (..., {steps}, 3)")
    return array


def _output(states: np.ndarray, shape: tuple[int, ...], out: np.ndarray | None) -> np.ndarray:
    given = _states(states, "states")
    if out is None:
        out = np.empty(shape, state_dtype)
    elif out.dtype != state_dtype or out.shape != shape or not (out.flags.c_contiguous and out.flags.writeable):
        raise ValueError(f"out: expected a contiguous array of state_dtype and shape {shape} that can be written")
    if out is not given:
        whole = f"V{state_dtype.itemsize}"  # numpy copies records member by member
        out.view(whole)[...] = given.view(whole)
    return out


def _per_ball(array: np.ndarray, shape: tuple[int, ...], inner: int) -> tuple[np.ndarray, int]:
    """The array with its batch dimensions as one, and the bytes from ball to ball: 0 if all balls share one element."""
    tail = array.shape[array.ndim - inner:]
    if np.prod(array.shape[:array.ndim - inner]) == 1:
        return np.ascontiguousarray(array).reshape((1,) + tail), 0
    whole = np.ascontiguousarray(np.broadcast_to(array, shape + tail)).reshape((-1,) + tail)
    return whole, whole.strides[0]
