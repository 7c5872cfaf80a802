"""Compilers: which is the machine's own, and what is stopped ends whole."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from threading import Event

import pytest

from segfmu.errors import BuildError
from segfmu.fmu.native import compilers, processes
from segfmu.fmu.native.compilers import PLATFORMS, Compiler

# a compiler that runs another program, which goes on for long
SCRIPT = "sleep 60 & echo $! > program.part; mv program.part program; wait"


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs /proc and process groups")
@pytest.mark.parametrize("count", [1, 2])
def test_stopped_compilers_end_the_programs_that_they_run(
    count: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiler = Compiler(("sh", "-c", SCRIPT), PLATFORMS["x86_64-linux"], "")
    folders = [tmp_path / str(number) for number in range(count)]
    programs = [folder / "program" for folder in folders]
    for folder in folders:
        folder.mkdir()
    monkeypatch.setattr(processes.os, "cpu_count", lambda: count)

    def build(folder: Path) -> None:
        compiler.build(folder / "fmu.c", folder / "fmu.so")

    stopped = 0.0

    def stop(*_: object) -> None:
        nonlocal stopped
        stopped = time.monotonic()
        raise KeyboardInterrupt

    def look(*_: object) -> None:
        # once the programs run
        signal.signal(signal.SIGALRM, stop if all(p.exists() for p in programs) else look)
        signal.setitimer(signal.ITIMER_REAL, 0.05)

    before = signal.signal(signal.SIGALRM, look)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyboardInterrupt):
            build(folders[0]) if count == 1 else processes.on_all_cores(build, folders)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    while any(_runs(int(p.read_text())) for p in programs):
        time.sleep(0.01)
    assert time.monotonic() < stopped + 10.0


@pytest.mark.skipif(os.name != "posix", reason="needs a shell")
def test_no_compiler_begins_once_the_work_is_stopped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One whose sources were still being written compiled to its end, for 20 s."""
    monkeypatch.setattr(processes.os, "cpu_count", lambda: 2)
    writes = Event()

    def work(late: bool) -> None:
        if not late:
            writes.wait(10.0)
            raise KeyboardInterrupt
        writes.set()
        time.sleep(0.3)
        processes.run(("sh", "-c", "touch made"), tmp_path)

    with pytest.raises(KeyboardInterrupt):
        processes.on_all_cores(work, [False, True])
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize(("configured", "name"), [
    ("gcc", "gcc"), ("ccache gcc -pthread", "gcc"), ("clang -B /x", "cc"), ("", "cc"),
])
def test_the_compiler_that_python_was_built_with(
    configured: str, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(compilers.sysconfig, "get_config_var", lambda _: configured)
    known = ("gcc", "cc", "clang", "ccache")
    monkeypatch.setattr(compilers.shutil, "which", lambda n: f"/bin/{n}" if n in known else None)
    assert compilers._own() == f"/bin/{name}"


@pytest.mark.skipif(os.name != "posix", reason="needs permissions of POSIX")
def test_a_compiler_that_cannot_be_run_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "cc"
    broken.write_bytes(b"\x7fELF, of another machine")
    broken.chmod(0o755)
    monkeypatch.setattr(compilers, "_own", lambda: str(broken))
    name = compilers.host()
    assert name is not None
    with pytest.raises(BuildError, match=rf"{broken} cannot be run: "):
        compilers.compiler(name)


def _runs(program: int) -> bool:
    """Whether a process is there and not just waiting to be collected."""
    try:
        state = Path(f"/proc/{program}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"
