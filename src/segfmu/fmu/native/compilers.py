"""C compilers for the binaries of native FMUs: the host's own, and ziglang for every platform."""

from __future__ import annotations

import platform
import shutil
import struct
import subprocess
import sys
import sysconfig
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from segfmu.errors import BuildError

OPTIONS = (
    "-std=c99", "-O3", "-DNDEBUG", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math",
    "-fvisibility=hidden", "-ffunction-sections", "-fdata-sections",
)
# what the glue and the models, written by hand, must pass
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")


@dataclass(frozen=True)
class Platform:
    """A platform: its folder in archives of FMI 2 and 3, its name for zig, and what links."""

    name: str
    folder: str
    target: str
    suffix: str
    link: tuple[str, ...]


_ELF = ("-shared", "-s", "-Wl,--gc-sections", "-lm")
PLATFORMS = {
    p.name: p
    for p in (
        # glibc 2.17 is that of all Linux distributions still in use
        Platform("x86_64-linux", "linux64", "x86_64-linux-gnu.2.17", ".so", _ELF),
        Platform("aarch64-linux", "aarch64-linux", "aarch64-linux-gnu.2.17", ".so", _ELF),
        Platform("x86_64-windows", "win64", "x86_64-windows-gnu", ".dll", ("-shared", "-s")),
        Platform("x86_64-darwin", "darwin64", "x86_64-macos", ".dylib", ("-shared",)),
        Platform("aarch64-darwin", "aarch64-darwin", "aarch64-macos", ".dylib", ("-shared",)),
    )
}


@dataclass(frozen=True)
class Compiler:
    """A command that compiles C for one platform."""

    command: tuple[str, ...]
    platform: Platform

    def compile(self, source: Path, target: Path, options: tuple[str, ...] = ()) -> None:
        """Compile one source to an object file."""
        position = () if self.platform.suffix == ".dll" else ("-fPIC",)
        self._run(*OPTIONS, *position, *options, "-c", str(source), "-o", str(target))

    def link(self, objects: list[Path], target: Path) -> None:
        """Link a shared library that shows nothing but the functions of FMI."""
        self._run(*map(str, objects), "-o", str(target), *self.platform.link)

    def _run(self, *arguments: str) -> None:
        command = [*self.command, *arguments]
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, errors="replace", check=False
            )
        except OSError as error:
            raise BuildError(f"{command[0]} cannot be run: {error.strerror}") from None
        if done.returncode != 0:
            lines = [line for line in done.stderr.splitlines() if "error" in line]
            told = (lines or done.stderr.splitlines() or [f"exit code {done.returncode}"])[0]
            raise BuildError(f"compiling for {self.platform.name} failed: {told}")


# of the two in a universal binary: type and subtype of the processor, by Apple's mach/machine.h
_MACHINES = {"x86_64-darwin": (0x01000007, 3), "aarch64-darwin": (0x0100000C, 0)}
_ALIGNMENT = 14


def universal(slices: dict[str, bytes]) -> bytes:
    """One macOS library from those of several processors, by platform: Apple's fat format."""
    unit = 1 << _ALIGNMENT
    found = struct.pack(">II", 0xCAFEBABE, len(slices))
    place, body = unit, b""
    for name, content in slices.items():
        found += struct.pack(">IIIII", *_MACHINES[name], place, len(content), _ALIGNMENT)
        body += content + bytes(-len(content) % unit)
        place = unit + len(body)
    return found + bytes(unit - len(found)) + body


def host() -> str | None:
    """The name of the platform this runs on; None where it is none of ours."""
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(
        platform.machine().lower(), platform.machine().lower()
    )
    name = f"{machine}-{platform.system().lower()}"
    return name if name in PLATFORMS else None


def available() -> bool:
    """Whether there is a compiler for the host."""
    return host() is not None and (_own() is not None or _has_zig())


def compiler(name: str) -> Compiler:
    """The compiler for a platform.

    Raises
    ------
    BuildError
        For an unknown platform, and where no compiler for it is installed.
    """
    if name not in PLATFORMS:
        raise BuildError(f"platform must be one of {', '.join(PLATFORMS)}, got {name!r}")
    own = _own()
    if name == host() and own is not None:
        return Compiler((own,), PLATFORMS[name])
    if not _has_zig():
        raise BuildError(
            f"no C compiler for {name}; install the extra segfmu[platforms], which has ziglang"
        )
    target = PLATFORMS[name].target
    return Compiler((sys.executable, "-m", "ziglang", "cc", "-target", target), PLATFORMS[name])


def _has_zig() -> bool:
    return find_spec("ziglang") is not None


def _own() -> str | None:
    """The C compiler that Python was built with, or another one of the usual names."""
    configured = str(sysconfig.get_config_var("CC") or "").split()
    for name in (*configured[:1], "cc", "gcc", "clang"):
        found: str | None = shutil.which(name)
        if found is not None:
            return found
    return None
