# SPDX-License-Identifier: MIT
"""Scenes: boxes, ball and start."""
from __future__ import annotations

import ctypes
import functools
import os
from ctypes import byref, c_double, c_uint32
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arguments import (MOST_U32, laid_out, new_array, number, numbers, path as path_of, record, shape as shape_of, vector,
                         whole)
from ._library import Error, Handle, Owner, SceneDesc, address, check, expect, lib
from ._records import contact_dtype, state_dtype


class Scene(Owner):
    """An immutable scene, from a maze file, a maze's text, or boxes.

    path: of a maze text file. text: of one in memory. boxes: shape (n, 2, 3), the lower and the upper corner of each, m;
    with them radius (m) and start (m; default: where the library puts it). Just one of path, text and boxes. A scene is
    pickled by its boxes, radius and start.
    """

    __slots__ = ("_handle", "__weakref__")

    def __init__(self, path: str | os.PathLike[str] | None = None, *, text: str | bytes | None = None, boxes: Any = None,
                 radius: float | None = None, start: Any = None) -> None:
        if (path is not None) + (text is not None) + (boxes is not None) != 1:
            raise TypeError("Scene takes one of path, text and boxes")
        if boxes is None and not (radius is None and start is None):
            raise TypeError("radius and start go with boxes")
        if path is not None:
            self._handle = Handle(lib.phys_scene_load, lib.phys_scene_destroy, path_of(path, "path"))
        elif text is not None:
            if not isinstance(text, (str, bytes)):
                raise TypeError(f"text has the type {type(text).__name__}; expected str or bytes")
            data = text.encode() if isinstance(text, str) else text
            self._handle = Handle(lib.phys_scene_parse, lib.phys_scene_destroy, data, len(data), None)
        else:
            self._handle = _create(boxes, radius, start)

    def __reduce__(self) -> Any:
        made = functools.partial(_remade, boxes=self.boxes, radius=self.radius, start=self.start()["position"])
        return made, (type(self),), getattr(self, "__dict__", None)

    @property
    def radius(self) -> float:
        """Of the ball, m."""
        return float(lib.phys_scene_radius(self._handle))

    @property
    def boxes(self) -> NDArray[Any]:
        """As given, shape (n, 2, 3), m: a read-only copy. Events and contacts count in it."""
        count = lib.phys_scene_box_count(self._handle)
        if count == 0:
            return _read_only(np.zeros((0, 2, 3)))
        memory = (c_double * (6 * count)).from_address(lib.phys_scene_boxes(self._handle))
        return _read_only(np.frombuffer(memory, "f8").reshape(count, 2, 3).copy())

    @property
    def bounds(self) -> NDArray[Any]:
        """The smallest box around all boxes, shape (2, 3), m; read-only."""
        out = np.zeros((2, 3))
        check(lib.phys_scene_bounds(self._handle, address(out)))
        return _read_only(out)

    def start(self, shape: int | tuple[int, ...] = ()) -> NDArray[Any]:
        """The state at the start, at rest: an array of state_dtype and this shape, each element the same."""
        out = np.zeros((), state_dtype)
        check(lib.phys_scene_start(self._handle, address(out)))
        states = new_array(shape_of(shape), state_dtype, "states")
        states[...] = out
        return states

    def contacts(self, centre: Any, reach: float = 0.0) -> NDArray[Any]:
        """All boxes whose gap to a ball at `centre` (3, m) is at most `reach` (m): an array of contact_dtype, by box.

        Flush and identical boxes whose union is a box are one, with the number of that one of them that is nearest to the
        contact's point, the lowest of several.
        """
        place, reach, count = vector(centre, "centre"), number(reach, "reach"), c_uint32()
        expect(np.abs(place) <= 2.0**100, place, "a coordinate of centre", "m", "a number within +-2^100")
        expect(np.array(0 <= reach < np.inf), np.array(reach), "reach", "m", "a finite number, 0 or more")
        check(lib.phys_scene_contacts(self._handle, address(place), reach, None, 0, byref(count)))
        out = np.zeros(count.value, contact_dtype)
        if out.size:
            check(lib.phys_scene_contacts(self._handle, address(place), reach, address(out), out.size, byref(count)))
        return out

    def why_not_planar(self) -> str:
        """Empty if all contacts of a rolling ball are horizontal; else the box and the reason."""
        error = Error()
        return str(error.text, "utf-8") if lib.phys_scene_check_planar(self._handle, byref(error)) else ""

    def __repr__(self) -> str:
        return f"<Scene, {lib.phys_scene_box_count(self._handle)} boxes, radius {self.radius:g} m>"


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Of an immutable scene: what is written into it would have no effect."""
    array.flags.writeable = False
    return array


def _remade(kind: type[Scene], **parts: Any) -> Scene:
    """Of a class that may have an __init__ of its own."""
    scene = object.__new__(kind)
    Scene.__init__(scene, **parts)
    return scene


def _create(boxes: Any, radius: float | None, start: Any) -> Handle:
    array = laid_out(numbers(boxes, "boxes"))
    if array.shape != (0,) and (array.ndim != 3 or array.shape[1:] != (2, 3)):
        raise ValueError(f"boxes has the shape {array.shape}; expected (n, 2, 3)")
    desc = SceneDesc()
    check(lib.phys_scene_desc_init(byref(desc), ctypes.sizeof(desc)))
    desc.box_count, desc.boxes = whole(len(array), "len(boxes)", 0, MOST_U32), address(array) if array.size else None
    if radius is not None:
        desc.radius = number(radius, "radius")
        desc.start[:] = (0.0, 0.0, desc.radius)
    if start is not None:
        desc.start[:] = vector(start, "start").tolist()
    return Handle(lib.phys_scene_create, lib.phys_scene_destroy, byref(desc))


def state_hash(state: NDArray[Any]) -> int:
    """64-bit hash (FNV-1a) of one state's 128 bytes."""
    one = record(state, state_dtype, "state")  # lives until the call is over
    return int(lib.phys_state_hash(address(one)))
