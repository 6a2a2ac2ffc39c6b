# SPDX-License-Identifier: MIT
"""Finds and declares the shared library, and compares its structs with the dtypes before anything uses them."""
from __future__ import annotations

import ctypes
import os
import weakref
from collections.abc import Callable
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _records as records


class PhysicsError(Exception):
    """A call failed: what, which value, what was allowed.

    status: the code, below 0; name: its name, for instance "PHYS_ERROR_RANGE".
    """

    def __init__(self, status: int, text: str) -> None:
        super().__init__(text)
        self.status = status
        self.name = lib.phys_status_name(status).decode()

    def __reduce__(self) -> Any:  # or a process that fails couldn't tell the one that waits for it
        return _remade, (type(self), self.status, str(self)), self.__dict__


def _remade(kind: type[PhysicsError], status: int, text: str) -> PhysicsError:
    """Of a class that may have an __init__ of its own."""
    error = kind.__new__(kind)
    PhysicsError.__init__(error, status, text)
    return error


class Error(ctypes.Structure):
    _fields_ = [("status", c_int32), ("reserved", c_int32), ("text", c_char * 248)]


class SceneDesc(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("box_count", c_uint32), ("boxes", c_void_p), ("radius", c_double),
                ("start", c_double * 3)]


class ParamRow(ctypes.Structure):
    _fields_ = [("id", c_char_p), ("label", c_char_p), ("unit", c_char_p), ("help", c_char_p), ("choices", c_char_p),
                ("min", c_double), ("max", c_double), ("low", c_double), ("high", c_double), ("initial", c_double),
                ("step", c_double), ("offset", c_uint32), ("flags", c_uint32)]


class StepperInfo(ctypes.Structure):
    _fields_ = [("id", c_char_p), ("name", c_char_p), ("version", c_char_p), ("summary", c_char_p), ("file", c_char_p),
                ("rows", POINTER(POINTER(ParamRow))), ("row_count", c_uint32), ("flags", c_uint32)]


class Requirements(ctypes.Structure):
    _fields_ = [("stages", c_uint32), ("substeps", c_uint32), ("reasons", (c_char * 120) * 6)]


class Batch(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("stop_flags", c_uint32), ("ball_count", c_uint64), ("step_count", c_uint64),
                ("dt", c_double), ("params", c_void_p), ("params_stride", c_size_t), ("gravity", c_void_p),
                ("gravity_ball_stride", c_size_t), ("gravity_step_stride", c_size_t), ("states", c_void_p),
                ("states_stride", c_size_t), ("path", c_void_p), ("path_ball_stride", c_size_t),
                ("path_every", c_uint64), ("steps_done", c_void_p), ("statuses", c_void_p),
                ("impacts", c_void_p), ("energy_lost", c_void_p)]


SCAN_FUNCTION = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int32, c_char_p)

_ERROR_ARGUMENT = -1
_HANDLE_OUT = POINTER(c_void_p)
_ERROR_OUT = POINTER(Error)

#: name: (result, arguments). Structs that are numpy records go by address.
_FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "phys_version": (c_char_p, []),
    "phys_status_text": (c_char_p, [c_int32]),
    "phys_status_name": (c_char_p, [c_int32]),
    "phys_gravity_from_tilt": (c_int32, [c_double, c_double, c_double, c_void_p]),
    "phys_gravities_from_tilts": (c_int32, [c_uint64, c_void_p, c_void_p, c_void_p, c_void_p]),
    "phys_scene_desc_init": (c_int32, [POINTER(SceneDesc), c_size_t]),
    "phys_scene_create": (c_int32, [POINTER(SceneDesc), _HANDLE_OUT, _ERROR_OUT]),
    "phys_scene_load": (c_int32, [c_char_p, _HANDLE_OUT, _ERROR_OUT]),
    "phys_scene_parse": (c_int32, [c_char_p, c_size_t, c_char_p, _HANDLE_OUT, _ERROR_OUT]),
    "phys_scene_destroy": (None, [c_void_p]),
    "phys_scene_radius": (c_double, [c_void_p]),
    "phys_scene_box_count": (c_uint32, [c_void_p]),
    "phys_scene_boxes": (c_void_p, [c_void_p]),
    "phys_scene_bounds": (c_int32, [c_void_p, c_void_p]),
    "phys_scene_check_planar": (c_int32, [c_void_p, _ERROR_OUT]),
    "phys_scene_contacts": (c_int32, [c_void_p, c_void_p, c_double, c_void_p, c_uint32, POINTER(c_uint32)]),
    "phys_scene_start": (c_int32, [c_void_p, c_void_p]),
    "phys_state_hash": (c_uint64, [c_void_p]),
    "phys_params_init": (c_int32, [c_void_p, c_size_t]),
    "phys_param_rows": (POINTER(ParamRow), [POINTER(c_uint32)]),
    "phys_param_get": (c_double, [c_void_p, POINTER(ParamRow)]),
    "phys_param_set": (c_int32, [c_void_p, POINTER(ParamRow), c_double, _ERROR_OUT]),
    "phys_params_check": (c_int32, [c_void_p, _ERROR_OUT]),
    "phys_report_init": (c_int32, [c_void_p, c_size_t]),
    "phys_energy": (c_int32, [c_void_p, c_void_p, c_void_p, POINTER(c_double)]),
    "phys_registry_create": (c_int32, [_HANDLE_OUT, _ERROR_OUT]),
    "phys_registry_destroy": (None, [c_void_p]),
    "phys_registry_load_file": (c_int32, [c_void_p, c_char_p, _ERROR_OUT]),
    "phys_registry_scan": (c_int32, [c_void_p, c_char_p, SCAN_FUNCTION, c_void_p, _ERROR_OUT]),
    "phys_registry_count": (c_uint32, [c_void_p]),
    "phys_registry_info": (c_int32, [c_void_p, c_uint32, POINTER(StepperInfo)]),
    "phys_registry_find": (c_int32, [c_void_p, c_char_p, POINTER(StepperInfo), _ERROR_OUT]),
    "phys_stepper_info_init_params": (c_int32, [POINTER(StepperInfo), c_void_p]),
    "phys_stepper_create": (c_int32, [c_void_p, c_char_p, c_void_p, _HANDLE_OUT, _ERROR_OUT]),
    "phys_stepper_destroy": (None, [c_void_p]),
    "phys_step": (c_int32, [c_void_p, c_void_p, c_double, c_void_p, c_void_p, c_void_p, _ERROR_OUT]),
    "phys_stepper_requirements": (c_int32, [c_void_p, c_void_p, c_double, c_void_p, POINTER(Requirements), _ERROR_OUT]),
    "phys_batch_init": (c_int32, [POINTER(Batch), c_size_t]),
    "phys_batch_run": (c_int32, [c_void_p, POINTER(Batch), c_uint64, c_uint64, _ERROR_OUT]),
}


def _library_files() -> list[str]:
    """Where to look: what PHYSICS_LIBRARY names; the builds of the source tree that this file lies in, or lib of the
    prefix that it is installed in (lib/python3/dist-packages); the system."""
    named = os.environ.get("PHYSICS_LIBRARY")
    if named:
        return [named]
    tree = Path(__file__).resolve().parents[3]
    is_source_tree = (tree / "libphysics" / "python").is_dir()
    builds = [tree / "build" / preset / "libphysics" / "libphysics.so.1" for preset in ("release", "dev")]
    files = builds if is_source_tree else [tree / "libphysics.so.1"]
    return [str(file) for file in files if file.is_file()] + ["libphysics.so.1"]


def _load() -> ctypes.CDLL:
    problems = []
    for file in _library_files():
        try:
            library = ctypes.CDLL(file)
            for name, (result, arguments) in _FUNCTIONS.items():
                function = getattr(library, name)
                function.restype, function.argtypes = result, arguments
            return library
        except (OSError, AttributeError) as problem:
            problems.append(str(problem))
    raise ImportError("libphysics 1.1 or later wasn't found; PHYSICS_LIBRARY can name its file: " + "; ".join(problems))


lib = _load()


def check(status: int, error: Error | None = None) -> None:
    """Raises PhysicsError unless status is PHYS_OK."""
    if status != 0:
        text = error.text if error is not None and error.status == status else lib.phys_status_text(status)
        raise PhysicsError(status, text.decode(errors="replace"))


def expect(holds: NDArray[Any], values: NDArray[Any], name: str, unit: str, expected: str) -> None:
    """Names the first of the values that doesn't hold, for functions of the library that tell no more than a status."""
    wrong = values[~holds]
    if wrong.size:
        raise PhysicsError(_ERROR_ARGUMENT, f"{name} is {wrong[0]:.9g} {unit}; expected {expected}")


class Handle:
    """Owns an object of the library. It is destroyed once, when nothing refers to it any more, and before the objects it was
    made from, in whatever order the interpreter drops them. ctypes passes a Handle as the pointer.
    """

    __slots__ = ("_as_parameter_", "__weakref__")

    def __init__(self, create: Callable[..., int], destroy: Callable[[c_void_p], None], *arguments: Any) -> None:
        pointer, error = c_void_p(), Error()
        check(create(*arguments, byref(pointer), byref(error)), error)
        self._as_parameter_ = pointer
        needed = [argument for argument in arguments if isinstance(argument, Handle)]
        weakref.finalize(self, _destroy, destroy, pointer, needed).atexit = False


def _destroy(destroy: Callable[[c_void_p], None], pointer: c_void_p, needed: list[Handle]) -> None:
    destroy(pointer)  # before `needed` is dropped


class Owner:
    """Base of immutable classes that own handles: a copy is the object itself."""

    __slots__ = ()

    def __copy__(self) -> Any:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        return self

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} can't be pickled: make another where it is needed")


def address(array: NDArray[Any]) -> int:
    """Of the first element. The caller keeps the array alive."""
    return array.ctypes.data  # __array_interface__ describes the members of records first, which takes ten times as long


def library_rows() -> list[ParamRow]:
    count = c_uint32()
    rows: list[ParamRow] = lib.phys_param_rows(byref(count))[:count.value]
    return rows


def _expect(holds: bool, what: str) -> None:
    if not holds:
        raise ImportError(f"this package and {lib._name}, libphysics {lib.phys_version().decode()}, disagree about {what}: "
                          "build it anew, or name another by PHYSICS_LIBRARY")


def _compare_sizes() -> None:
    for init, dtype, name in ((lib.phys_params_init, records.params_dtype, "phys_params"),
                              (lib.phys_report_init, records.report_dtype, "phys_report")):
        memory = np.zeros(dtype.itemsize + 8, "u1")
        refuses_more = init(address(memory), dtype.itemsize + 8) != 0
        _expect(refuses_more and init(address(memory), dtype.itemsize) == 0, name)
    for init, struct in ((lib.phys_scene_desc_init, SceneDesc), (lib.phys_batch_init, Batch)):
        _expect(init(byref(struct()), ctypes.sizeof(struct)) == 0, struct.__name__)


def _compare_rows() -> None:
    for row in library_rows():
        member, _, axis = row.id.decode().partition("_")
        name, place = (member, "xyz".index(axis)) if member == "gravity" else (row.id.decode(), 0)
        field = (records.params_dtype.fields or {}).get(name)
        if field is not None:  # a row of a later version is one that this package doesn't offer
            _expect(field[1] + 8 * place == row.offset, f"phys_params.{name}")


def _compare_a_step() -> None:
    """A ball just before a wall: its state, the contact and the impact show where every member lies."""
    boxes = np.array([[(-1, -1, -1), (2, 1, 0)], [(1, -1, 0), (2, 1, 1)]], "f8")
    desc = SceneDesc()
    lib.phys_scene_desc_init(byref(desc), ctypes.sizeof(desc))
    desc.box_count, desc.boxes, desc.radius = 2, address(boxes), 0.125
    desc.start[:] = (0.75, 0.25, 0.125)
    scene, stepper, count = c_void_p(), c_void_p(), c_uint32()
    _expect(lib.phys_scene_create(byref(desc), byref(scene), None) == 0, "phys_scene_desc")
    state, params = np.full(2, 7, records.state_dtype), np.zeros((), records.params_dtype)
    report, events = np.zeros((), records.report_dtype), np.zeros(2, records.event_dtype)
    contact = np.zeros(2, records.contact_dtype)
    lib.phys_scene_start(scene, address(state))
    _expect(state[0]["position"].tolist() == [0.75, 0.25, 0.125] and state[0]["orientation"].tolist() == [0, 0, 0, 1]
            and state[0]["flags"] == 0 and state[1]["time"] == 7, "phys_state")
    lib.phys_scene_contacts(scene, address(state) + 16, 0.25, address(contact), 2, byref(count))
    _expect(count.value == 2 and contact[1]["normal"].tolist() == [-1, 0, 0] and contact[1]["gap"] == 0.125
            and contact[1]["box"] == 1 and contact[1]["feature"] == 1, "phys_contact")
    lib.phys_params_init(address(params), records.params_dtype.itemsize)
    lib.phys_report_init(address(report), records.report_dtype.itemsize)
    report["events"], report["event_capacity"] = address(events), 2
    state[0]["velocity"], state[0]["spin"] = (1, 0, 0), (0, 8, 0)
    lib.phys_stepper_create(None, b"swept", scene, byref(stepper), None)
    status = lib.phys_step(stepper, address(params), 0.25, address(state), address(state), address(report), None)
    _expect(bool(status == 0 and report["event_count"] >= 1 and state[0]["time"] == 0.25 and state[0]["step"] == 1
                 and events[0]["kind"] == records.EVENT_IMPACT and events[0]["box"] == 1
                 and events[0]["speed_before"] < 0 and report["energy_before"] > report["energy_after"]),
            "phys_report or phys_event")
    lib.phys_stepper_destroy(stepper)
    lib.phys_scene_destroy(scene)


_compare_sizes()
_compare_rows()
_compare_a_step()
