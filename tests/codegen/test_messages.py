"""The messages in C are those of Python, word for word."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Iterator

import pytest

from segfmu.codegen import messages, native
from segfmu.kernels.messages import PLACE, TABLES, Messages
from tests.compiler import CC, require_cc

FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fPIC", "-shared"]
NUMBERS = ((0.0, 2.5, 1e-7), (-123456.789, 1e22, 0.0), (1.0 / 3.0, 7.0, -1.0))


def reports(table: Messages, status: int) -> Iterator[list[float]]:
    """Reports for a text: any numbers, but integers where it counts or names."""
    places = PLACE.findall(table.texts[status])
    for shift, numbers in enumerate(NUMBERS):
        report = [numbers[i % len(numbers)] for i in range(table.report.SIZE)]
        for name, _, form in places:
            words = table.words.get(name)
            if words or not form:
                report[getattr(table.report, name)] = float(shift % len(words or NUMBERS))
        yield report


def test_generated_messages_are_up_to_date() -> None:
    for name, text in messages.generate().items():
        assert (native.TARGET / name).read_text(encoding="utf-8") == text, name


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    require_cc()
    target = tmp_path_factory.mktemp("messages") / "messages.so"
    source = native.TARGET / "messages.c"
    subprocess.run([CC, *FLAGS, str(source), "-o", str(target)], check=True)
    return ctypes.CDLL(str(target))


def in_c(library: ctypes.CDLL, table: Messages, status: int, report: list[float]) -> str | None:
    function = getattr(library, f"segfmu_{table.name}_message")
    function.restype = ctypes.c_bool
    text = ctypes.create_string_buffer(400)
    numbers = (ctypes.c_double * len(report))(*report)
    found = function(ctypes.c_int64(status), numbers, text, ctypes.c_size_t(len(text)))
    return text.value.decode() if found else None


@pytest.mark.parametrize("table", TABLES, ids=lambda t: t.name)
def test_both_languages_say_the_same(library: ctypes.CDLL, table: Messages) -> None:
    for status in table.texts:
        for report in reports(table, status):
            said = in_c(library, table, status, report)
            assert said == table.text(status, report)
            assert "{" not in said and "\n" not in said and len(said) < 399
    assert in_c(library, table, 0, [0.0] * table.report.SIZE) is None


def test_words_of_the_caller_take_the_place_of_the_tables_own() -> None:
    plan = next(table for table in TABLES if table.name == "plan")
    said = plan.text(-9, [1.0, 2.0, 1.0 / 3.0, 0.0, 1.0], AXIS=("left", "right"))
    assert said.startswith("axis right: no limit bounds")
