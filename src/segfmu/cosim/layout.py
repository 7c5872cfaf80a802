"""The structures and codes of c/loop.h, in its order."""

from __future__ import annotations

from ctypes import Structure, c_double, c_int64, c_size_t, c_void_p
from typing import Any, ClassVar

import numpy as np

# enum type
TYPES = {
    np.dtype(kind): code
    for code, kind in enumerate(
        ("float64", "float32", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",
         "uint64", "bool")
    )
}
# enum form, kind and outcome
FORMS = ("access2", "access3", "slopes")
KINDS = ("call", "copy", "step", "meet", "gate")
OUTCOMES = ("done", "call", "step", "enter", "update", "leave", "step ended", "event ended",
            "stalled", "event stalled", "off tape")
# enum tape_use
UNUSED, RECORDS, REPEATS = range(3)

Fields = list[tuple[str, Any]]


def _fields(kind: Any, *names: str) -> Fields:
    return [(name, kind) for name in names]


class CCall(Structure):
    """call"""

    _fields_: ClassVar[Fields] = [
        ("form", c_int64), *_fields(c_void_p, "function", "instance", "references"),
        ("count", c_size_t), *_fields(c_void_p, "orders", "values"),
        *_fields(c_size_t, "size", "taped"),
    ]


class CCopy(Structure):
    """copy"""

    _fields_: ClassVar[Fields] = [
        *_fields(c_int64, "from_type", "to_type", "count"),
        *_fields(c_void_p, "source", "index", "target"), ("offset", c_int64),
    ]


class COperation(Structure):
    """operation"""

    _fields_: ClassVar[Fields] = _fields(c_int64, "kind", "item", "extra")


class CSequence(Structure):
    """sequence"""

    _fields_: ClassVar[Fields] = [("items", c_void_p), ("count", c_int64)]


class CUnit(Structure):
    """unit"""

    _fields_: ClassVar[Fields] = [
        ("version", c_int64),
        *_fields(c_void_p, "instance", "do_step", "enter_event", "update", "enter_step"),
        *_fields(c_int64, "has_events", "at_event", "taped"),
    ]


class CAssignment(Structure):
    """assignment"""

    _fields_: ClassVar[Fields] = [("item", c_int64), ("data", c_void_p), ("bytes", c_size_t)]


class CChange(Structure):
    """change"""

    _fields_: ClassVar[Fields] = [("time", c_double), *_fields(c_int64, "unit", "first", "count")]


class CTape(Structure):
    """tape"""

    _fields_: ClassVar[Fields] = [
        ("use", c_int64), ("data", c_void_p), *_fields(c_size_t, "size", "place"),
    ]


class CSimulation(Structure):
    """simulation"""

    _fields_: ClassVar[Fields] = [
        *_fields(c_void_p, "units", "calls", "copies", "columns"), ("column_count", c_int64),
        *_fields(CSequence, "advance", "exchange", "refresh", "point"),
        ("events", c_void_p), ("event_count", c_int64),
        ("changes", c_void_p), *_fields(c_int64, "change_count", "next_change"),
        *_fields(c_void_p, "assignments", "points", "rows"), ("row_size", c_int64),
        ("instant", c_double), ("most_stalls", c_int64),
        *_fields(c_double, "time", "reached"),
        *_fields(c_int64, "stalls", "outcome", "item", "status", "row"), ("lasts", c_void_p),
        ("tape", CTape),
    ]
