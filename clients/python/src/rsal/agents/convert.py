"""Values as the frames have them, and as agents have them: dataclasses, enumerations, numpy arrays.

A field is called as in Java in frames (``baseFromLaser``), and as usual in Python in dataclasses (``base_from_laser``).
"""

from __future__ import annotations

import dataclasses
import enum
import re
import types
import typing
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np

Decoder = Callable[[Any, memoryview], Any]
"""Makes a value of words and arrays."""


def wire_name(name: str) -> str:
    """``base_from_laser`` → ``baseFromLaser``."""
    return re.sub(r"_(\w)", lambda found: found.group(1).upper(), name)


def _plain(words: Any, _arrays: memoryview) -> Any:
    return words


def _array(words: Any, arrays: memoryview) -> Any:
    array = np.frombuffer(arrays, np.dtype("<" + words["array"]), words["count"], words["at"])
    array.flags.writeable = False
    return array


def _float(words: Any, _arrays: memoryview) -> float:
    return float(words)


@cache
def decoder(kind: Any) -> Decoder:  # noqa: PLR0911 - one for each kind of annotation
    """Return what makes values of an annotation, as ``list[Pose2d]``."""
    origin = typing.get_origin(kind)
    if origin is None and isinstance(kind, type):
        if dataclasses.is_dataclass(kind):
            return _dataclass(kind)
        if issubclass(kind, enum.Enum):
            return lambda words, _arrays: kind(words)
        if issubclass(kind, np.ndarray):
            return _array
        return _float if kind is float else _plain
    inner = typing.get_args(kind)
    if origin is np.ndarray:
        return _array
    if origin in (typing.Union, types.UnionType):
        return _union([each for each in inner if each is not type(None)])
    if origin in (list, tuple):
        item = decoder(inner[0])
        make = tuple if origin is tuple else list
        return lambda words, arrays: make([item(each, arrays) for each in words])
    if origin is dict:
        value = decoder(inner[1])
        return lambda words, arrays: {name: value(each, arrays) for name, each in words.items()}
    return _plain


def _union(kinds: list[Any]) -> Decoder:
    """Of ``X | None``, or of dataclasses, which the frames name by ``type``."""
    if len(kinds) == 1:
        only = decoder(kinds[0])
        return lambda words, arrays: None if words is None else only(words, arrays)
    by_name = {getattr(kind, "_type", kind.__name__): decoder(kind) for kind in kinds}
    return lambda words, arrays: by_name[words["type"]](words, arrays)


def _dataclass(kind: Any) -> Decoder:
    """Written out field by field: readings come often, and a loop over fields would take twice as long."""
    hints = typing.get_type_hints(kind)
    names: dict[str, Any] = {"kind": kind}
    parts = []
    for index, field in enumerate(dataclasses.fields(kind)):
        item = decoder(hints[field.name])
        word = f"words[{wire_name(field.name)!r}]"
        if item is _plain:
            parts.append(word)
        elif item is _float:
            parts.append(f"float({word})")
        else:
            names[f"item{index}"] = item
            parts.append(f"item{index}({word}, arrays)")
    made: Decoder = eval(f"lambda words, arrays: kind({', '.join(parts)})", names)  # noqa: S307 - of names of fields
    return made


def _dataclass_encoder(kind: Any) -> Callable[[Any], dict[str, Any]]:
    parts = [f"{wire_name(field.name)!r}: encode(value.{field.name})" for field in dataclasses.fields(kind)]
    tag = getattr(kind, "_type", None)
    if tag is not None:
        parts.append(f"'type': {tag!r}")
    text = f"lambda value: {{{', '.join(parts)}}}"
    made: Callable[[Any], dict[str, Any]] = eval(text, {"encode": encode})  # noqa: S307 - of names of fields
    return made


_DATACLASSES: dict[type, Callable[[Any], dict[str, Any]]] = {}
_AS_IT_IS = frozenset({float, int, str, bool, type(None)})


def encode(value: Any) -> Any:  # noqa: PLR0911 - one for each kind of value
    """Return a value as words. Numbers of numpy become numbers, its arrays lists."""
    kind = type(value)
    if kind in _AS_IT_IS:
        return value
    encoder = _DATACLASSES.get(kind)
    if encoder is not None:
        return encoder(value)
    if isinstance(value, enum.Enum):
        return value.value
    if isinstance(value, (str, int, float)):  # of a class that inherits from these, as numpy's float64
        return value
    if dataclasses.is_dataclass(kind):
        encoder = _DATACLASSES[kind] = _dataclass_encoder(kind)
        return encoder(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Mapping):
        return {str(name): encode(each) for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [encode(each) for each in value]
    raise TypeError(
        f"A value of type '{type(value).__name__}' cannot be sent."
        " Maybe use numbers, texts, lists, dicts or dataclasses."
    )
