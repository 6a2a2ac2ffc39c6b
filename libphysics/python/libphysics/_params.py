# SPDX-License-Identifier: MIT
"""Parameters by name, with the library's ranges and defaults; one set or an array of them."""
from __future__ import annotations

import functools
from collections.abc import Iterable
from ctypes import byref
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._arguments import common_shape, laid_out, new_array, numbers
from ._library import Error, ParamRow, address, check, expect, lib, library_rows
from ._records import params_dtype

_CHOICE, _SWITCH = 1, 8  # flags of rows
_OPTIONS = {"orientation": 1, "all_stages": 2}


def gravity_from_tilt(tilt_x: Any, tilt_y: Any, strength: Any = 9.81) -> NDArray[Any]:
    """Gravity (m/s^2) of a board tilted by two angles (rad, within +-pi/2); the arguments broadcast.

    Returns an array of their common shape + (3,): the bits of phys_gravity_from_tilt.
    """
    given = [numbers(tilt_x, "tilt_x"), numbers(tilt_y, "tilt_y"), numbers(strength, "strength")]
    shape = common_shape(tilt_x=given[0].shape, tilt_y=given[1].shape, strength=given[2].shape)
    gravity = new_array(shape + (3,), np.dtype("f8"), "gravity")
    each = [laid_out(np.broadcast_to(values, shape)) for values in given]
    if lib.phys_gravities_from_tilts(gravity.size // 3, *map(address, each), address(gravity)) != 0:
        for values, name in zip(given, ("tilt_x", "tilt_y")):
            expect(np.abs(values) < np.pi / 2, values, name, "rad", "a number between -pi/2 and pi/2")
        expect((given[2] >= 0) & (given[2] <= 2.0**100), given[2], "strength", "m/s^2", "a number from 0 to 2^100")
    return gravity


def _assign(view: NDArray[Any], value: NDArray[Any], name: str) -> None:
    try:
        view[...] = value
    except ValueError:
        raise ValueError(f"{name} has the shape {value.shape}; expected {view.shape} or one that broadcasts to it") from None


class Row(NamedTuple):
    """A ParamRow by value, which another process understands, too."""

    id: bytes
    label: bytes
    unit: bytes
    help: bytes
    choices: bytes
    min: float
    max: float
    low: float
    high: float
    initial: float
    step: float
    offset: int
    flags: int


def _by_name(rows: Iterable[ParamRow]) -> dict[str, Row]:
    """A later library may have rows whose values lie behind the struct that this package knows: without those."""
    copies = (Row(*(getattr(row, name) for name in Row._fields)) for row in rows)
    return {row.id.decode(): row for row in copies if row.offset + 4 <= params_dtype.itemsize}


@functools.cache
def _rows_of_library() -> dict[str, Row]:
    return _by_name(library_rows())


class Params:
    """What a step obeys: parameters by name, checked against their ranges as they are set.

    Names are those of the library's rows (`restitution_wall`, `rolling_friction`, ...; `Params.rows()` lists them), of
    the stepper's own (made by `Stepper.params`), `gravity` (m/s^2, shape + (3,)) and the switches `orientation` and
    `all_stages`. Values may be arrays: the set then has their common shape, and `Stepper.run` broadcasts it. What is
    written into such an array in place (`params.restitution_wall[1] = 7`, `params.gravity[2] = 5`) is checked by the step;
    those of the switches are read-only. Sets of the same names, shape and values are equal; as they can change, they have no
    hash.
    """

    __slots__ = ("record", "_rows")
    record: NDArray[Any]  #: the C structs, dtype params_dtype

    def __init__(self, own_rows: list[ParamRow] | None = None, /, **values: Any) -> None:
        object.__setattr__(self, "_rows", _rows_of_library() | _by_name(own_rows or []))
        for name in values.keys() - set(self.names()):
            raise TypeError(self._unknown(name))
        given = {name: self._numbers(value, name) for name, value in values.items()}
        shape = common_shape(**{name: value.shape[:-1] if name == "gravity" else value.shape for name, value in given.items()})
        first = np.zeros((), params_dtype)
        check(lib.phys_params_init(address(first), params_dtype.itemsize))
        for row in own_rows or []:
            check(lib.phys_param_set(address(first), byref(row), row.initial, None))
        object.__setattr__(self, "record", np.full(shape, first))
        for name, value in given.items():
            setattr(self, name, value)

    @staticmethod
    def rows() -> list[dict[str, Any]]:
        """The library's rows: id, label, unit, help, choices, min, max, low, high, initial, step."""
        names = [name for name, _ in ParamRow._fields_][:11]
        values = ([getattr(row, name) for name in names] for row in library_rows())
        return [{n: v.decode() if isinstance(v, bytes) else v for n, v in zip(names, row)} for row in values]

    @property
    def shape(self) -> tuple[int, ...]:
        """() for one set."""
        return self.record.shape

    def names(self) -> list[str]:
        """All names that can be read and set."""
        return [*self._rows, "gravity", *_OPTIONS]

    def _view(self, row: Row) -> NDArray[Any]:
        kind = "u4" if row.flags & _CHOICE else "f8"
        if not self.record.size:  # without memory to look at
            return np.empty(self.shape, kind)
        return np.ndarray(self.shape, kind, self.record, row.offset, self.record.strides)

    def __getattr__(self, name: str) -> Any:
        if name == "gravity":
            return self.record["gravity"]
        if name in _OPTIONS:
            values = np.asarray((self.record["options"] & _OPTIONS[name]) != 0)
            values.flags.writeable = False  # a copy
            return values if self.shape else values.item()
        if name.startswith("_") or name not in self._rows:  # _rows itself, before there is one
            raise AttributeError(self._unknown(name))
        values = self._view(self._rows[name])
        return values if self.shape else values.item()

    def __setattr__(self, name: str, value: Any) -> None:
        if name != "gravity" and name not in _OPTIONS and name not in self._rows:
            raise AttributeError(self._unknown(name))
        value = self._numbers(value, name)
        if name in _OPTIONS:
            bit = np.uint32(_OPTIONS[name])
            if not np.isin(value, (0, 1)).all():
                raise ValueError(f"{name} is {value}; expected True or False")
            self.record["options"] = np.where(value, self.record["options"] | bit, self.record["options"] & ~bit)
        elif name == "gravity":
            if value.shape[-1:] != (3,):
                raise ValueError(f"gravity has the shape {value.shape}; expected (..., 3)")
            for axis, letter in enumerate("xyz"):
                self._check(self._rows["gravity_" + letter], value[..., axis])
            _assign(self.record["gravity"], value, name)
        else:
            row = self._rows[name]
            self._check(row, value)
            _assign(self._view(row), value, name)

    def _numbers(self, value: Any, name: str) -> NDArray[Any]:
        row = self._rows.get(name)
        choices = row.choices.decode().split("\n") if row and row.flags & _CHOICE else []
        return numbers(value, name, " or ".join(f"{n} ({choice})" for n, choice in enumerate(choices)) or "numbers")

    def _check(self, row: Row, values: NDArray[Any]) -> None:
        """Asks the library about the values that are least likely to pass: each that isn't within the range."""
        whole = values == np.floor(values)
        outside = values[~((values >= row.min) & (values <= row.max) & (whole | (row.flags & (_CHOICE | _SWITCH) == 0)))]
        if outside.size:
            scratch, error = np.array(self.record.ravel()[:1]), Error()
            check(lib.phys_param_set(address(scratch), byref(ParamRow(*row)), float(outside.flat[0]), byref(error)), error)

    def _unknown(self, name: str) -> str:
        return f"no parameter is called '{name}'; known are {', '.join(sorted(self.names()))}"

    def copy(self) -> "Params":
        """Independent of this one, as copy.copy and copy.deepcopy give it, too."""
        record, own_rows = self.__getstate__()
        other = object.__new__(type(self))
        other.__setstate__((record.copy(), own_rows))
        return other

    def __copy__(self) -> "Params":
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> "Params":
        return self.copy()

    def __getstate__(self) -> tuple[NDArray[Any], dict[str, Row]]:
        """The values and the stepper's own rows; those of the library are the same in each process."""
        return self.record, {name: row for name, row in self._rows.items() if name not in _rows_of_library()}

    def __setstate__(self, state: tuple[NDArray[Any], dict[str, Row]]) -> None:
        record, own_rows = state
        object.__setattr__(self, "_rows", _rows_of_library() | own_rows)
        object.__setattr__(self, "record", record)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Params):
            return NotImplemented
        return self._rows == other._rows and np.array_equal(self.record, other.record)

    def __dir__(self) -> list[str]:
        return sorted([*object.__dir__(self), *self.names()])

    def __repr__(self) -> str:
        shown = [f"{name}={getattr(self, name)!r}" for name in self.names() if not name.startswith("gravity_")]
        return f"Params({', '.join(shown)})" if not self.shape else f"<Params, shape {self.shape}>"


def rows_of(info: Any) -> list[ParamRow]:
    """The rows of a stepper's own."""
    return [info.rows[i].contents for i in range(info.row_count)]
