# SPDX-License-Identifier: MIT
"""The C API for Python, by ctypes alone: no packages, nothing to compile.

    scene = physics.Scene("mazes/levels/01.txt")
    stepper = physics.Stepper("symplectic-euler", scene)
    params = physics.default_params()
    params.gravity = physics.gravity_from_tilt(0.10, 0.05)
    state = scene.start()
    while state.time < 1.0:
        stepper.step(params, 0.01, state)

The library is libphysics.so.1 of the loader's search path, or the file that PHYSICS_LIBRARY names.
"""
import ctypes
import os
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

AT_REST, AIRBORNE, OUT, SLIPPING = 1, 2, 4, 8


class Vec3(ctypes.Structure):
    _fields_ = [("x", c_double), ("y", c_double), ("z", c_double)]


class Box(ctypes.Structure):
    _fields_ = [("min", Vec3), ("max", Vec3)]


class State(ctypes.Structure):
    """Everything that a ball is; copy it with State.from_buffer_copy(state)."""

    _fields_ = [("time", c_double), ("step", c_uint64), ("position", Vec3), ("velocity", Vec3), ("spin", Vec3),
                ("orientation", c_double * 4), ("flags", c_uint64)]


class Params(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("model", c_uint32), ("gravity", Vec3), ("restitution_wall", c_double),
                ("restitution_floor", c_double), ("rolling_friction", c_double), ("sliding_friction", c_double),
                ("wall_friction", c_double), ("options", c_uint32), ("reserved", c_uint32), ("stepper", c_double * 8)]


class StepperInfo(ctypes.Structure):
    _fields_ = [("id", c_char_p), ("name", c_char_p), ("version", c_char_p), ("summary", c_char_p),
                ("file", c_char_p), ("rows", c_void_p), ("row_count", c_uint32), ("flags", c_uint32)]


class _Error(ctypes.Structure):
    _fields_ = [("status", c_int32), ("reserved", c_int32), ("text", c_char * 248)]


class PhysicsError(Exception):
    """A call failed: what, which value, what was allowed."""

    def __init__(self, status, text):
        super().__init__(text)
        self.status = status


_lib = ctypes.CDLL(os.environ.get("PHYSICS_LIBRARY", "libphysics.so.1"))


def _declare(name, *arguments, result=c_int32):
    function = getattr(_lib, name)
    function.argtypes = arguments
    function.restype = result
    return function


_status_text = _declare("phys_status_text", c_int32, result=c_char_p)
_params_init = _declare("phys_params_init", POINTER(Params), c_size_t)
_gravity_from_tilt = _declare("phys_gravity_from_tilt", c_double, c_double, c_double, POINTER(Vec3))
_scene_load = _declare("phys_scene_load", c_char_p, POINTER(c_void_p), POINTER(_Error))
_scene_destroy = _declare("phys_scene_destroy", c_void_p, result=None)
_scene_start = _declare("phys_scene_start", c_void_p, POINTER(State))
_scene_radius = _declare("phys_scene_radius", c_void_p, result=c_double)
_scene_box_count = _declare("phys_scene_box_count", c_void_p, result=c_uint32)
_scene_boxes = _declare("phys_scene_boxes", c_void_p, result=POINTER(Box))
_registry_create = _declare("phys_registry_create", POINTER(c_void_p), POINTER(_Error))
_registry_destroy = _declare("phys_registry_destroy", c_void_p, result=None)
_registry_load_file = _declare("phys_registry_load_file", c_void_p, c_char_p, POINTER(_Error))
_registry_count = _declare("phys_registry_count", c_void_p, result=c_uint32)
_registry_info = _declare("phys_registry_info", c_void_p, c_uint32, POINTER(StepperInfo))
_registry_find = _declare("phys_registry_find", c_void_p, c_char_p, POINTER(StepperInfo), POINTER(_Error))
_info_init_params = _declare("phys_stepper_info_init_params", POINTER(StepperInfo), POINTER(Params))
_stepper_create = _declare("phys_stepper_create", c_void_p, c_char_p, c_void_p, POINTER(c_void_p), POINTER(_Error))
_stepper_destroy = _declare("phys_stepper_destroy", c_void_p, result=None)
_step = _declare("phys_step", c_void_p, POINTER(Params), c_double, POINTER(State), POINTER(State), c_void_p,
                 POINTER(_Error))


def _check(status, error=None):
    if status != 0:
        raise PhysicsError(status, (error.text if error else _status_text(status)).decode())


def default_params():
    params = Params()
    _check(_params_init(byref(params), ctypes.sizeof(params)))
    return params


def gravity_from_tilt(tilt_x, tilt_y, strength=9.81):
    """Gravity (m/s^2) of a board tilted by two angles (rad)."""
    gravity = Vec3()
    _check(_gravity_from_tilt(tilt_x, tilt_y, strength, byref(gravity)))
    return gravity


class Scene:
    def __init__(self, path):
        self._handle, error = c_void_p(), _Error()
        _check(_scene_load(os.fsencode(path), byref(self._handle), byref(error)), error)

    def __del__(self):
        _scene_destroy(self._handle)

    @property
    def radius(self):
        return _scene_radius(self._handle)

    @property
    def boxes(self):
        return _scene_boxes(self._handle)[:_scene_box_count(self._handle)]

    def start(self):
        state = State()
        _check(_scene_start(self._handle, byref(state)))
        return state


class Registry:
    """The built-in steppers and those of the plugin files that are loaded."""

    def __init__(self, *plugins):
        self._handle, error = c_void_p(), _Error()
        _check(_registry_create(byref(self._handle), byref(error)), error)
        for plugin in plugins:
            _check(_registry_load_file(self._handle, os.fsencode(plugin), byref(error)), error)

    def __del__(self):
        _registry_destroy(self._handle)

    def ids(self):
        info = StepperInfo()
        for index in range(_registry_count(self._handle)):
            _check(_registry_info(self._handle, index, byref(info)))
            yield info.id.decode()

    def init_params(self, stepper_id, params):
        """Sets the stepper's own parameters to their defaults."""
        info, error = StepperInfo(), _Error()
        _check(_registry_find(self._handle, stepper_id.encode(), byref(info), byref(error)), error)
        _check(_info_init_params(byref(info), byref(params)))


class Stepper:
    def __init__(self, stepper_id, scene, registry=None):
        self._scene, self._registry = scene, registry  # both must outlive it
        self._handle, self._error = c_void_p(), _Error()
        _check(_stepper_create(registry._handle if registry else None, stepper_id.encode(), scene._handle,
                               byref(self._handle), byref(self._error)), self._error)

    def __del__(self):
        _stepper_destroy(self._handle)

    def step(self, params, dt, state):
        """Moves the state dt seconds on; it stays as it was if that fails."""
        _check(_step(self._handle, byref(params), dt, byref(state), byref(state), None, byref(self._error)),
               self._error)
