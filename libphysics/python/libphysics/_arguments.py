# SPDX-License-Identifier: MIT
"""Arguments of C functions: numbers, texts and arrays, checked here before ctypes could wrap, cut or cast them."""
from __future__ import annotations

import math
import operator
import os
from reprlib import repr as short
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._records import params_dtype, state_dtype

MOST_U32, MOST_U64 = 2**32 - 1, 2**64 - 1

_ALIGNMENT = 8  # of every struct of the library
_NAMES = {state_dtype: "state_dtype", params_dtype: "params_dtype, as Params makes it"}


def whole(value: Any, name: str, least: int, most: int) -> int:
    """An integer within its range; a float is none, even a whole one."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {short(value)}; expected an integer") from None
    if not least <= number <= most:
        raise ValueError(f"{name} is {number}; expected {least} .. {most}")
    return number


def numbers(value: Any, name: str, expected: str = "numbers") -> NDArray[Any]:
    """An array of doubles. Texts, None, complex numbers and records are no numbers. expected: for the message."""
    array = _array(value, name, expected)
    if array.dtype.kind not in "buifO":
        raise TypeError(f"{name} is {short(value)}; expected {expected}")
    try:
        if array.dtype.kind == "O":  # integers beyond 64 bits, fractions: as float() takes them, which refuses None
            return np.array([_real(one) for one in array.ravel()], "f8").reshape(array.shape)
        return np.asarray(array, "f8")
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name} is {short(value)}; expected {expected}") from None


def _array(value: Any, name: str, expected: str) -> NDArray[Any]:
    if isinstance(value, np.ma.MaskedArray):  # whose masked elements would count as any others
        raise TypeError(f"{name} is a masked array; expected {expected} without a mask")
    try:
        return np.asarray(value)
    except ValueError:  # rows of different lengths
        raise TypeError(f"{name} is {short(value)}; expected {expected}") from None


def _real(value: Any) -> float:
    if isinstance(value, (str, bytes)):
        raise TypeError
    return float(value)


def number(value: Any, name: str) -> float:
    """One double."""
    if type(value) is float:
        return value
    array = numbers(value, name, "a number")
    if array.size != 1:
        raise TypeError(f"{name} has the shape {array.shape}; expected one number")
    return float(array.item())


def vector(value: Any, name: str) -> NDArray[Any]:
    """Three contiguous doubles."""
    array = numbers(value, name)
    if array.shape != (3,):
        raise ValueError(f"{name} has the shape {array.shape}; expected (3,)")
    return laid_out(array)


def text(value: Any, name: str) -> bytes:
    """A C string."""
    if not isinstance(value, str):
        raise TypeError(f"{name} is {short(value)}; expected a str")
    return _ended(value.encode(), name)


def path(value: Any, name: str) -> bytes:
    """A C string that names a file."""
    try:
        encoded = os.fsencode(value)
    except TypeError:
        raise TypeError(f"{name} is {short(value)}; expected a path") from None
    return _ended(encoded, name)


def _ended(value: bytes, name: str) -> bytes:
    if b"\0" in value:
        raise ValueError(f"{name} is {short(value)}; expected a text without NUL")
    return value


def common_shape(**shapes: tuple[int, ...]) -> tuple[int, ...]:
    """To which the arguments broadcast."""
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise ValueError(f"shapes that don't broadcast: {listed}") from None


def is_laid_out(array: NDArray[Any]) -> bool:
    """Whether C may read it: contiguous in C order and aligned."""
    return array.flags.c_contiguous and array.ctypes.data % _ALIGNMENT == 0


def laid_out(array: NDArray[Any]) -> NDArray[Any]:
    """The array, or a copy of it that C may read."""
    return array if is_laid_out(array) else np.array(array, order="C")


def records(value: Any, dtype: np.dtype[Any], name: str) -> NDArray[Any]:
    """An array of one of the C structs."""
    array = _array(value, name, _NAMES[dtype])
    if array.dtype != dtype:
        if array.dtype.names and array.dtype == dtype.newbyteorder():
            raise TypeError(f"{name} has the other order of bytes; expected {_NAMES[dtype]}: use {name}.astype({name}.dtype."
                            "newbyteorder('='))")
        found = "an array of other records" if array.dtype.names else f"an array of {array.dtype}"
        raise TypeError(f"{name} is {short(value) if array.dtype == object else found}; expected {_NAMES[dtype]}")
    return array


def shape(value: Any) -> tuple[int, ...]:
    """Of an array: one length or several."""
    try:
        lengths = tuple(value)
    except TypeError:
        lengths = (value,)
    return tuple(whole(length, "shape", 0, MOST_U64) for length in lengths)


def record(value: Any, dtype: np.dtype[Any], name: str) -> NDArray[Any]:
    """One of the C structs."""
    array = records(value, dtype, name)
    if array.size != 1:
        raise TypeError(f"{name} has {array.size} elements; expected one")
    return laid_out(array)


def new_array(shape: tuple[int, ...], dtype: np.dtype[Any], name: str) -> NDArray[Any]:
    """A new array for results, not filled. MemoryError also where numpy would raise ValueError, from 2^63 bytes on."""
    if math.prod(shape) * dtype.itemsize >= 2**63:
        raise MemoryError(f"{name}: an array of the shape {shape} doesn't fit into memory")
    return np.empty(shape, dtype)
