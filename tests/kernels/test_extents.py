"""Arrays that are too small raise IndexError; those that are just large enough are enough."""

from __future__ import annotations

from functools import cache
from importlib import import_module

import numpy as np
import pytest

from segfmu.codegen import extension
from segfmu.codegen.functions import Function, functions
from segfmu.errors import BuildError
from segfmu.kernels.entry_point import EntryPoint
from segfmu.kernels.entry_points import ENTRY_POINTS, MAY_BE_EMPTY
from tests.compiler import compiled_kernels
from tests.kernels.calls import Call, calls

compiled = compiled_kernels()
INTERPRETED = {
    e.name: getattr(import_module(f"segfmu.kernels.{e.module}"), e.name) for e in ENTRY_POINTS
}
POINTS = {e.name: e for e in ENTRY_POINTS}


@cache
def function(name: str) -> Function:
    """A kernel's arguments: not read for a collection of tests, which all processes make."""
    return next(f for f in functions() if f.name == name)


@pytest.fixture(scope="module")
def valid() -> dict[str, Call]:
    return calls()


def least_extents(point: EntryPoint, arguments: Call) -> dict[str, tuple[int, ...]]:
    """The least extents of the arrays of a call, where names have the extents that they have."""
    named = dict(zip((n for n, _ in function(point.name).arguments), arguments, strict=True))
    counts = {n: value for n, value in named.items() if type(value) is int}
    names = dict(counts)
    for array, extents in point.extents.items():
        for i, extent in enumerate(extents):
            if isinstance(extent, str) and extent.isidentifier():
                names.setdefault(extent, named[array].shape[i])
    found = {}
    for array, extents in point.extents.items():
        # an array and an extent may have the same name
        known = [
            names | named if "[" in str(e) or "pieces(" in str(e) else named | names
            for e in extents
        ]
        found[array] = tuple(
            int(eval(str(e), {**INTERPRETED, **k})) for e, k in zip(extents, known, strict=True)
        )
    return found


def least(point: EntryPoint, arguments: Call) -> list:
    """Copies of the arguments of a call, arrays with their least extents."""
    extents = least_extents(point, arguments)
    shrunk = []
    for (name, _), value in zip(function(point.name).arguments, arguments, strict=True):
        if isinstance(value, np.ndarray):
            assert all(a >= b for a, b in zip(value.shape, extents[name], strict=True)), name
            value = value[tuple(slice(e) for e in extents[name])].copy()
        shrunk.append(value)
    return shrunk


def checked(point: EntryPoint) -> list[tuple[str, int]]:
    """Dimensions that cannot be less: all but those that give a name its value and stand alone."""
    arguments = function(point.name).arguments
    arrays = [n for n, kind in arguments if kind in extension.ARRAYS]
    uses = [str(e) for extents in point.extents.values() for e in extents]
    alone = {e for e in uses if uses.count(e) == 1 and e.isidentifier()}
    alone -= {n for n, kind in arguments if kind == "int"}
    return [
        (name, i)
        for name in arrays
        for i, extent in enumerate(point.extents[name])
        if extent not in alone
    ]


def test_every_entry_point_has_a_call(valid: dict[str, Call]) -> None:
    assert set(valid) == set(POINTS)


@pytest.mark.parametrize("name", POINTS)
def test_least_extents_are_enough(name: str, valid: dict[str, Call]) -> None:
    # interpreted, what lies outside of an array would raise
    given = [least(POINTS[name], valid[name]) for _ in range(2)]
    results = [INTERPRETED[name](*given[0]), getattr(compiled, name)(*given[1])]
    for one, other in (results, *zip(*given, strict=True)):
        if one is not None:
            assert np.allclose(one, other, rtol=1e-9, atol=1e-11, equal_nan=True)


def accepts(name: str, call: Call, array: str, dimension: int, extent: int) -> bool:
    """Whether a kernel takes an array of which one extent is less than it may be."""
    given = least(POINTS[name], call)
    place = [n for n, _ in function(name).arguments].index(array)
    smaller = [slice(None)] * given[place].ndim
    smaller[dimension] = slice(extent if extent >= 0 else given[place].shape[dimension] + extent)
    given[place] = given[place][tuple(smaller)].copy()
    try:
        getattr(compiled, name)(*given)
    except IndexError as error:
        assert f"{name}() argument" in str(error), (array, dimension)
        return False
    return True


@pytest.mark.parametrize("name", [e.name for e in ENTRY_POINTS if e.extents])
def test_smaller_arrays_raise(name: str, valid: dict[str, Call]) -> None:
    places = checked(POINTS[name])
    assert [place for place in places if accepts(name, valid[name], *place, -1)] == []


def filled(point: EntryPoint) -> list[tuple[str, int]]:
    """Dimensions of a name that may not be 0."""
    return [
        (array, i)
        for array, extents in point.extents.items()
        for i, extent in enumerate(extents)
        if str(extent).isidentifier() and extent not in MAY_BE_EMPTY
    ]


@pytest.mark.parametrize("name", [e.name for e in ENTRY_POINTS if filled(e)])
def test_empty_arrays_raise(name: str, valid: dict[str, Call]) -> None:
    places = filled(POINTS[name])
    assert [place for place in places if accepts(name, valid[name], *place, 0)] == []


@pytest.mark.parametrize("offsets", [[0, 3, 2, 5], [-1, 1, 2, 3], [0, 1, 1, 2], [0, 1, 2, 10**6]])
def test_pieces_that_do_not_exist_raise(offsets: list[int], valid: dict[str, Call]) -> None:
    given_to = [n for n, e in POINTS.items()
                if "offsets" in e.extents and "offsets" not in function(n).written]
    assert len(given_to) > 20
    for name in given_to:
        given = least(POINTS[name], valid[name])
        place = [n for n, _ in function(name).arguments].index("offsets")
        given[place] = np.array(offsets)
        with pytest.raises(IndexError, match="argument offsets: must ascend"):
            getattr(compiled, name)(*given)


@pytest.mark.parametrize("name", [n for n, e in POINTS.items() if e.extents])
def test_other_types_and_ranks_raise(name: str, valid: dict[str, Call]) -> None:
    for i, value in enumerate(valid[name]):
        if not isinstance(value, np.ndarray):
            continue
        single = np.zeros(value.shape, np.float32)
        for wrong in (single, value.reshape((*value.shape, 1)), value.ravel()):
            given = least(POINTS[name], valid[name])
            given[i] = wrong
            if wrong.ndim != value.ndim or wrong.dtype != value.dtype:
                with pytest.raises(TypeError, match="expected a"):
                    getattr(compiled, name)(*given)


@pytest.mark.parametrize(
    "extents", [{}, {"state": (10,)}, {"state": (10,), "load": (2,)},
                {"state": (10,), "load": (2, "unknown + 1")},
                {"state": (10,), "load": (2, 3), "other": (1,)}]
)
def test_extents_that_miss_something_do_not_build(
    extents: dict, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        extension, "ENTRY_POINTS", (EntryPoint("crane._crane", "crane_load", extents),)
    )
    with pytest.raises(BuildError, match="crane_load"):
        extension.generate()
