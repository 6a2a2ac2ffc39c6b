# SPDX-License-Identifier: MIT
"""Steppers: one step, or many balls and many steps at once."""
from __future__ import annotations

import ctypes
import math
import os
import threading
import weakref
from ctypes import byref, c_double
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._arguments import (MOST_U32, MOST_U64, common_shape, is_laid_out, laid_out, new_array, number, numbers, path, record,
                         records, text, whole)
from ._library import (SCAN_FUNCTION, Batch, Error, Handle, Owner, Requirements, StepperInfo, address, check, expect,
                       lib)
from ._params import Params, rows_of
from ._pieces import run_piece, run_ranges, viewed
from ._records import event_dtype, params_dtype, report_dtype, state_dtype
from ._run import Run
from ._scene import Scene

_MOST_THREADS = 1024
_STAGES = ("vertical motion", "substeps", "rolling resistance", "slip and spin", "grid", "orientation")


class Info(NamedTuple):
    """Description of a stepper. file: its plugin, "" for a built-in one."""

    id: str
    name: str
    version: str
    summary: str
    file: str
    rows: tuple[str, ...]


class Step(NamedTuple):
    """One step: the state after it (0-d, state_dtype), its report (0-d, report_dtype) and its events (event_dtype)."""

    state: NDArray[Any]
    report: NDArray[Any]
    events: NDArray[Any]

    def __repr__(self) -> str:
        return f"<Step to {self.state['time']:g} s, {len(self.events)} events>"


class Registry(Owner):
    """The steppers that can be made: the built-in ones, those of plugin files, and those that a scan finds.

    scan: also look into the folders of PHYS_PLUGIN_PATH and the one beside the library; `refused` says what was wrong
    with the files that weren't taken.
    """

    __slots__ = ("_handle", "refused", "__weakref__")
    refused: list[str]

    def __init__(self, *plugins: str | os.PathLike[str], scan: bool = False) -> None:
        self._handle, error = Handle(lib.phys_registry_create, lib.phys_registry_destroy), Error()
        self.refused = []
        for plugin in plugins:
            check(lib.phys_registry_load_file(self._handle, path(plugin, "plugin"), byref(error)), error)
        if scan:
            hear = SCAN_FUNCTION(lambda _, __, status, line: self.refused.append(_decoded(line)) if status else None)
            check(lib.phys_registry_scan(self._handle, None, hear, None, byref(error)), error)

    def steppers(self) -> list[Info]:
        """All steppers: the built-in ones from crude to exact, then those of plugins."""
        return [_describe(self._info(index)) for index in range(lib.phys_registry_count(self._handle))]

    def _info(self, index: int) -> StepperInfo:
        info = StepperInfo()
        check(lib.phys_registry_info(self._handle, index, byref(info)))
        return info

    def __repr__(self) -> str:
        return f"<Registry, {', '.join(info.id for info in self.steppers())}>"


def _decoded(line: bytes) -> str:
    return line.decode(errors="replace")


def _describe(info: StepperInfo) -> Info:
    id, name, version, summary, file = map(_decoded, (info.id, info.name, info.version, info.summary, info.file))
    return Info(id, name, version, summary, file, tuple(_decoded(row.id) for row in rows_of(info)))


def steppers() -> list[Info]:
    """The built-in steppers, from crude to exact."""
    return Registry().steppers()


class _Turns:
    """Threads take turns. A signal's handler, which runs in the middle of its own thread's turn, would wait for itself."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self.is_taken = False

    def __enter__(self) -> None:
        self._lock.acquire()
        if self.is_taken:
            self._lock.release()
            raise RuntimeError("this thread is in the middle of a run of this stepper; expected another Stepper of the scene")
        self.is_taken = True

    def __exit__(self, *_: object) -> None:
        self.is_taken = False
        self._lock.release()


class Stepper(Owner):
    """Computes steps in one scene.

    id: of a built-in stepper or one of the plugin's. plugin: path of a shared object, or a Registry. No result
    depends on earlier steps. Python threads may share it: they take turns; `run` uses threads of its own. It is pickled by
    its id, scene and plugin's file, whose path is that from the root.
    """

    __slots__ = ("_scene", "_registry", "_handles", "_info", "_file", "_turns", "__weakref__")

    def __init__(self, id: str, scene: Scene, plugin: str | os.PathLike[str] | Registry | None = None) -> None:
        if not isinstance(scene, Scene):
            raise TypeError(f"scene is {scene!r}; expected a Scene")
        self._handles: list[Handle] = []
        self._turns = _Turns()
        self._scene = scene
        self._registry = plugin if isinstance(plugin, Registry) else Registry(*([] if plugin is None else [plugin]))
        self._info, error = StepperInfo(), Error()
        check(lib.phys_registry_find(self._registry._handle, text(id, "id"), byref(self._info), byref(error)), error)
        file = self._info.file.decode(errors="surrogateescape")
        self._file = os.path.abspath(file) if file else None  # now: the folder may be another one later
        self._handle(0)
        _all.add(self)

    def __reduce__(self) -> Any:
        info = self.info
        return _remade, (type(self), info.id, self._scene, self._file), getattr(self, "__dict__", None)

    def _after_fork(self) -> None:
        """A lock that another thread held is never released in the child, where that thread isn't; what its call was doing
        to the library's steppers isn't finished either: they are left alone."""
        if self._turns.is_taken:
            self._turns = _Turns()
            _abandoned.append(self._handles)
            self._handles = []

    def _handle(self, index: int) -> Handle:
        """The library's stepper for thread `index`."""
        while len(self._handles) <= index:
            self._handles.append(Handle(lib.phys_stepper_create, lib.phys_stepper_destroy, self._registry._handle,
                                        self._info.id, self._scene._handle))
        return self._handles[index]

    @property
    def info(self) -> Info:
        return _describe(self._info)

    @property
    def scene(self) -> Scene:
        return self._scene

    def params(self, /, **values: Any) -> Params:
        """Params that know this stepper's own names, too."""
        return Params(rows_of(self._info), **values)

    def step(self, state: NDArray[Any], params: Params | NDArray[Any], dt: float, *, events: int = 256) -> Step:
        """One step of dt seconds (0 .. 2^100) with its report and up to `events` events.

        state: one element of state_dtype; it stays as it is. params: one set. Raises PhysicsError.
        """
        before, obeyed = record(state, state_dtype, "state"), record(_record(params), params_dtype, "params")
        dt, room = number(dt, "dt"), whole(events, "events", 0, MOST_U32)
        after, report = np.empty((), state_dtype), np.zeros((), report_dtype)
        happened, error = np.zeros(room, event_dtype), Error()
        check(lib.phys_report_init(address(report), report_dtype.itemsize))
        report["events"], report["event_capacity"] = address(happened) if room else 0, room
        with self._turns:
            status = lib.phys_step(self._handle(0), address(obeyed), dt, address(before), address(after),
                                   address(report), byref(error))
        check(status, error)
        report["events"] = 0
        return Step(after, report, happened[:int(report["event_count"])])

    def run(self, states: NDArray[Any], params: Params | NDArray[Any], dt: float, steps: int, *, gravity: Any = None,
            every: int = 0, stop: int | np.integer[Any] = 0, threads: int = 1, tally: bool = False,
            out: NDArray[Any] | None = None) -> Run:
        """Many balls, many steps: for each ball the bits that `step` gives in a loop.

        states: state_dtype, any shape. params: one set or an array of them. gravity: m/s^2, in place of that of params:
        (3,) for all, or (..., 1, 3) for each ball, or (..., steps, 3) for each ball and step. The shapes of states and
        params and gravity's `...` broadcast to the batch. every: keep every k-th state as `path`; 0: none. stop: a ball
        is done once its state has one of these flags, for instance OUT. threads: how many run (1 .. 1024; never more than
        there are balls), with the interpreter's lock released. Ctrl-C is heeded between pieces of a million steps (more
        where balls rest, which takes no time); `out` then has balls after different numbers of steps. tally: whether
        `impacts` and `energy_lost` are wanted; steps are slower then. out: states of the batch's shape that are written,
        for instance `states` itself.
        Wrong arguments raise TypeError, ValueError or PhysicsError and write nothing; a ball that fails has its status in
        the result (`Run.check` raises).
        """
        given, sets, dt = records(states, state_dtype, "states"), _record(params), number(dt, "dt")
        steps, every = whole(steps, "steps", 0, MOST_U64), whole(every, "every", 0, MOST_U64)
        stop, threads = whole(stop, "stop", 0, MOST_U32), whole(threads, "threads", 1, _MOST_THREADS)
        pull = None if gravity is None else _gravity(gravity, steps)
        shape = common_shape(states=given.shape, params=sets.shape, gravity=() if pull is None else pull.shape[:-2])
        result = _output(shape, out)
        path = new_array(shape + (steps // every,), state_dtype, "path") if every > 0 else None
        done, statuses = np.zeros(shape, "u8"), np.zeros(shape, "i4")
        batch = Batch()
        check(lib.phys_batch_init(byref(batch), ctypes.sizeof(batch)))
        batch.stop_flags, batch.dt, batch.step_count, batch.ball_count = stop, dt, steps, result.size
        sets, batch.params_stride = _per_ball(sets, shape, 0)
        batch.params = address(sets)
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
        run = Run(result, path, done, statuses, impacts, energy_lost)
        with self._turns:
            handles = [self._handle(index) for index in range(max(1, min(threads, result.size)))]
            run_piece(handles[0], batch, 0, 0)  # checks the arguments before anything is written
            _copy_whole(given, result)
            run_ranges(handles, batch, run)
            run._reason = self._first_failure(run, batch)
        return run

    def _first_failure(self, run: Run, batch: Batch) -> str:
        """What the library says of the step in which the first of the balls that failed did."""
        if not np.count_nonzero(run.statuses):
            return ""
        ball, error = int(np.flatnonzero(run.statuses)[0]), Error()
        params = np.array(viewed(batch.params + ball * batch.params_stride, params_dtype))
        if batch.gravity:
            step = int(run.steps_done.flat[ball])
            place = batch.gravity + ball * batch.gravity_ball_stride + step * batch.gravity_step_stride
            params["gravity"] = viewed(place, np.dtype(("f8", 3)))
        state, after = run.states.reshape(-1)[ball:ball + 1], np.empty((), state_dtype)
        lib.phys_step(self._handle(0), address(params), batch.dt, address(state), address(after), None, byref(error))
        return _decoded(error.text)

    def energy(self, state: NDArray[Any], params: Params | NDArray[Any]) -> float:
        """Energy per mass, J/kg."""
        one, obeyed = record(state, state_dtype, "state"), record(_record(params), params_dtype, "params")
        for values, name, unit in ((one["position"], "position", "m"), (one["velocity"], "velocity", "m/s"),
                                   (one["spin"], "spin", "rad/s"), (obeyed["gravity"], "gravity", "m/s^2")):
            expect(np.abs(values) <= 2.0**100, values, f"a component of {name}", unit, "a number within +-2^100")
        value = c_double()
        check(lib.phys_energy(self._scene._handle, address(obeyed), address(one), byref(value)))
        return value.value

    def requirements(self, state: NDArray[Any], params: Params | NDArray[Any], dt: float) -> dict[str, tuple[bool, str]]:
        """For each stage of the step with these arguments whether it runs, and why."""
        one, obeyed = record(state, state_dtype, "state"), record(_record(params), params_dtype, "params")
        told, error = Requirements(), Error()
        with self._turns:
            status = lib.phys_stepper_requirements(self._handle(0), address(obeyed), number(dt, "dt"), address(one),
                                                   byref(told), byref(error))
        check(status, error)
        reasons = [_decoded(reason.value) for reason in told.reasons]
        return {stage: (bool(told.stages >> i & 1), reasons[i]) for i, stage in enumerate(_STAGES)}

    def __repr__(self) -> str:
        return f"<Stepper '{self.info.id}', version {self.info.version}, in {self._scene!r}>"


_all: weakref.WeakSet[Stepper] = weakref.WeakSet()
_abandoned: list[list[Handle]] = []


def _after_fork() -> None:
    for stepper in list(_all):
        stepper._after_fork()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)


def _remade(kind: type[Stepper], *arguments: Any) -> Stepper:
    """Of a class that may have an __init__ of its own."""
    stepper = object.__new__(kind)
    Stepper.__init__(stepper, *arguments)
    return stepper


def _record(params: Params | NDArray[Any]) -> NDArray[Any]:
    sets = params.record if isinstance(params, Params) else records(params, params_dtype, "params")
    if np.any(sets["struct_size"] != params_dtype.itemsize):
        raise ValueError("params has records that nobody filled (their struct_size is another); expected those of "
                         "Stepper.params()")
    return sets


def _gravity(gravity: Any, steps: int) -> NDArray[Any]:
    array = numbers(gravity, "gravity")
    array = array.reshape(1, 3) if array.shape == (3,) else array
    if array.ndim < 2 or array.shape[-1] != 3 or array.shape[-2] not in (1, steps):
        each = "" if steps == 1 else f" or (..., {steps}, 3)"
        raise ValueError(f"gravity has the shape {array.shape}; expected (3,), (..., 1, 3){each}")
    return array


def _output(shape: tuple[int, ...], out: NDArray[Any] | None) -> NDArray[Any]:
    if out is None:
        return new_array(shape, state_dtype, "states")
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out is a {type(out).__name__}; expected an array of state_dtype")
    records(out, state_dtype, "out")
    if out.shape != shape:
        raise ValueError(f"out has the shape {out.shape}; expected {shape}")
    if not (is_laid_out(out) and out.flags.writeable):
        raise ValueError("out is read-only, not contiguous or not aligned; expected an array that C can write to")
    return out


def _copy_whole(given: NDArray[Any], out: NDArray[Any]) -> None:
    if out is not given:
        whole = f"V{state_dtype.itemsize}"  # numpy copies records member by member
        out.view(whole)[...] = given.view(whole)


def _per_ball(array: NDArray[Any], shape: tuple[int, ...], inner: int) -> tuple[NDArray[Any], int]:
    """The array with its batch dimensions as one, and the bytes from ball to ball: 0 if all balls share one element."""
    tail = array.shape[array.ndim - inner:]
    if math.prod(array.shape[:array.ndim - inner]) == 1:
        return laid_out(array).reshape((1,) + tail), 0
    each = laid_out(np.broadcast_to(array, shape + tail)).reshape((math.prod(shape),) + tail)
    return each, array.itemsize * math.prod(tail)  # numpy's strides of an array without elements may be 0: shared
