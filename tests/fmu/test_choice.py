"""Which backend is chosen, for which platforms, and what is said where there is no compiler."""

from __future__ import annotations

import struct

import pytest

from segfmu.errors import BuildError, InputError
from segfmu.fmu import choice
from segfmu.fmu.native import compilers
from tests.compiler import needs_native


@pytest.fixture(autouse=True)
def nothing_packaged(monkeypatch: pytest.MonkeyPatch) -> None:
    """As in a checkout whose wheel was never made."""
    monkeypatch.setattr(choice, "packaged", lambda models: ())


def test_native_is_the_default_where_it_can_be_built(monkeypatch) -> None:
    monkeypatch.setattr(choice, "available", lambda: True)
    assert choice.chosen(2, "native", "") == choice.Choice(native=True)
    assert choice.chosen(3, "native", "all").platforms == tuple(compilers.PLATFORMS)
    assert choice.chosen(2, "native", "x86_64-linux, x86_64-windows").platforms == (
        "x86_64-linux", "x86_64-windows",
    )
    assert not choice.chosen(2, "python", "").native


def test_without_a_compiler_python_is_used_and_said(monkeypatch) -> None:
    monkeypatch.setattr(choice, "available", lambda: False)
    found = choice.chosen(2, "native", "")
    assert not found.native and found.note.startswith("no C compiler found")
    assert "\n" not in found.note


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((4, "native", ""), "fmi must be 2 or 3, got 4"),
        ((2, "rust", ""), "backend must be one of native, python"),
        ((2, "native", "vax"), "platforms must be all or some of"),
        ((3, "python", ""), "backend python has neither FMI 3 nor platforms"),
    ],
)
def test_what_does_not_exist_is_refused(arguments, words: str) -> None:
    with pytest.raises(InputError, match=words):
        choice.chosen(*arguments)


def test_a_platform_without_compiler_is_told(monkeypatch) -> None:
    monkeypatch.setattr(compilers, "_own", lambda: None)
    monkeypatch.setattr(compilers, "_has_zig", lambda: False)
    assert not compilers.available()
    with pytest.raises(BuildError, match="install the extra segfmu"):
        compilers.compiler("aarch64-darwin")
    with pytest.raises(BuildError, match="platform must be one of"):
        compilers.compiler("pdp11-unix")


def test_other_platforms_are_for_zig(monkeypatch) -> None:
    monkeypatch.setattr(compilers, "_has_zig", lambda: True)
    monkeypatch.setattr(compilers.metadata, "version", lambda name: "0.13.0")
    monkeypatch.setattr(compilers, "host", lambda: "x86_64-linux")
    command = compilers.compiler("aarch64-linux").command
    target = ("-m", "ziglang", "cc", "-target", "aarch64-linux-gnu.2.17")
    assert command[1:] == (*target, "-mllvm", "-inline-threshold=80", "-rtlib=none")
    # there zig's library has what the processor and Microsoft's lack
    assert "-rtlib=none" not in compilers.compiler("x86_64-windows").command


@needs_native
def test_a_compiler_that_fails_is_quoted_in_one_line(tmp_path) -> None:
    name = compilers.host()
    (tmp_path / "wrong.c").write_text("int main(void) { return nothing; }\n")
    library = tmp_path / "wrong.so"
    with pytest.raises(BuildError, match=f"compiling for {name} failed: .*nothing") as caught:
        compilers.compiler(name).build(tmp_path / "wrong.c", library)
    assert "\n" not in str(caught.value)


def test_a_universal_binary_holds_both_unchanged() -> None:
    slices = {"x86_64-darwin": b"intel" * 5000, "aarch64-darwin": b"arm" * 11}
    found = compilers.universal(slices)
    magic, count = struct.unpack_from(">II", found)
    assert (magic, count) == (0xCAFEBABE, 2)
    for i, content in enumerate(slices.values()):
        _, _, offset, size, align = struct.unpack_from(">IIIII", found, 8 + 20 * i)
        assert offset % (1 << align) == 0
        assert found[offset : offset + size] == content


def test_packaged_binaries_need_no_compiler(monkeypatch) -> None:
    platforms = tuple(compilers.PLATFORMS)
    monkeypatch.setattr(choice, "packaged", lambda models: platforms)
    monkeypatch.setattr(choice, "available", lambda: False)
    assert choice.chosen(2, "native", "").platforms == platforms
    here = choice.chosen(2, "native", "", everywhere=False)
    assert here.native == (compilers.host() in platforms) and here.platforms == ()
    assert choice.chosen(3, "native", "x86_64-windows").platforms == ("x86_64-windows",)
