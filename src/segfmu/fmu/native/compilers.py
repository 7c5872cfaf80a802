"""C compilers for the binaries of native FMUs: the host's own, and ziglang for every platform."""

from __future__ import annotations

import platform
import shutil
import struct
import subprocess
import sys
import sysconfig
from dataclasses import dataclass
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

from segfmu.errors import BuildError
from segfmu.fmu.native import processes

# small code: a wheel carries the binaries of all platforms
OPTIONS = (
    "-std=c99", "-O3", "-DNDEBUG", "-DSPAN_INLINE=", "-w", "-ffp-contract=off", "-fno-math-errno",
    "-fno-trapping-math", "-fno-tree-vectorize", "-fno-unroll-loops", "-fvisibility=hidden",
    "-ffunction-sections", "-fdata-sections",
)


@dataclass(frozen=True)
class Platform:
    """A platform: its folder in archives of FMI 2 and 3, its name for zig, and options."""

    name: str
    folder: str
    target: str
    suffix: str
    compile: tuple[str, ...]
    link: tuple[str, ...]

    @property
    def options(self) -> tuple[str, ...]:
        """All options of the platform."""
        return *self.compile, *self.link


# C has nothing to unwind
_CODE = ("-fPIC", "-fno-asynchronous-unwind-tables", "-fno-unwind-tables")
# No model calls all kernels. Without optimisation, zig would compile a library of checks, which
# nothing here needs, for each platform.
_LINK = ("-O3", "-shared", "-s")
_MACH = (*_LINK, "-Wl,-dead_strip")
_ELF = (*_LINK, "-Wl,--gc-sections", "-Wl,-z,defs", "-lm")
# what clang inlines at most; its usual 225 makes binaries larger by 9 %, and hardly faster
_ZIG = ("-mllvm", "-inline-threshold=80")
# zig would compile for each platform what processors lack, of which nothing is used on these
_WHOLE = (".so", ".dylib")
PLATFORMS = {
    p.name: p
    for p in (
        # glibc 2.17 is that of all Linux distributions still in use
        Platform(
            "x86_64-linux", "linux64", "x86_64-linux-gnu.2.17", ".so",
            (*_CODE, "-DSEGFMU_OLDEST_GLIBC"), _ELF,
        ),
        Platform("aarch64-linux", "aarch64-linux", "aarch64-linux-gnu.2.17", ".so", _CODE, _ELF),
        Platform(
            "x86_64-windows", "win64", "x86_64-windows-gnu", ".dll", (),
            (*_LINK, "-Wl,--gc-sections"),
        ),
        # macOS 11 is the first one for both processors
        Platform("x86_64-darwin", "darwin64", "x86_64-macos.11.0", ".dylib", _CODE, _MACH),
        Platform("aarch64-darwin", "aarch64-darwin", "aarch64-macos.11.0", ".dylib", _CODE, _MACH),
    )
}

# Of pages: no archive has it. The library initialises itself when it is loaded; the page gives it
# files and messages by WASI preview 1, a function by a place in its table, and memory for values.
BROWSER = Platform(
    "wasm32-wasi", "", "wasm32-wasi", ".wasm", (),
    (
        "-O3", "-mexec-model=reactor", "-s", "-Wl,--gc-sections", "-Wl,--export-dynamic",
        "-Wl,--export=malloc", "-Wl,--export-table", "-Wl,--growable-table",
    ),
)
TARGETS = PLATFORMS | {BROWSER.name: BROWSER}


@dataclass(frozen=True)
class Compiler:
    """A command that compiles C for one platform; `version` tells one compiler from another."""

    command: tuple[str, ...]
    platform: Platform
    version: str

    @property
    def identity(self) -> str:
        """What a binary follows from beside its sources."""
        return " ".join((*self.command, self.version, *OPTIONS, *self.platform.options))

    def build(self, source: Path, library: Path) -> Path:
        """Compile one source, beside those that it includes, to a shared library.

        It shows nothing but the functions of FMI, and equal sources give equal bytes.

        Raises
        ------
        BuildError
            With the compiler's first error.
        """
        return self.link(library, self.compile(source))

    def compile(self, source: Path, *options: str) -> Path:
        """The object file of a source; no path of this machine gets into it."""
        target = source.with_name(f"{source.name}.o")
        self._run(
            *OPTIONS, f"-ffile-prefix-map={source.parent}=.", *self.platform.compile, *options,
            "-c", source.name, "-o", target.name, folder=source.parent,
        )
        return target

    def link(self, library: Path, *objects: Path) -> Path:
        """The shared library of object files that are in its folder."""
        install = ("-Wl,-install_name,@rpath/" + library.name,) * (library.suffix == ".dylib")
        self._run(
            *(o.name for o in objects), "-o", library.name, *self.platform.link, *install,
            folder=library.parent,
        )
        if library.suffix == ".dll":
            library.write_bytes(without_date(library.read_bytes()))
        return library

    def _run(self, *arguments: str, folder: Path) -> None:
        code, said = processes.run([*self.command, *arguments], folder)
        if code != 0:
            lines = [line for line in said.splitlines() if "error" in line]
            told = (lines or said.splitlines() or [f"exit code {code}"])[0]
            raise BuildError(f"compiling for {self.platform.name} failed: {told}")


# place of the offset of the header in a DLL, and of the date in that header: Microsoft's PE format
_PE_HEADER, _PE_DATE = 0x3C, 8


def without_date(library: bytes) -> bytes:
    """A DLL without the time at which it was linked."""
    (header,) = struct.unpack_from("<I", library, _PE_HEADER)
    place = header + _PE_DATE
    return library[:place] + bytes(4) + library[place + 4 :]


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
    """The name of the platform this runs on; None if it is not supported."""
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(
        platform.machine().lower(), platform.machine().lower()
    )
    name = f"{machine}-{platform.system().lower()}"
    return name if name in PLATFORMS else None


def available() -> bool:
    """Whether there is a compiler for the host."""
    return host() is not None and (_own() is not None or _has_zig())


def compiler(name: str) -> Compiler:
    """The compiler for one of `TARGETS`.

    Raises
    ------
    BuildError
        For an unknown platform, and where no compiler for it is installed.
    """
    if name not in TARGETS:
        raise BuildError(f"platform must be one of {', '.join(TARGETS)}, got {name!r}")
    own = _own()
    if name == host() and own is not None:
        return Compiler((own,), PLATFORMS[name], _version(own))
    return portable(name)


def portable(name: str) -> Compiler:
    """The compiler whose binaries run on old systems of a platform as well.

    Raises
    ------
    BuildError
        Where it is not installed.
    """
    if not _has_zig():
        raise BuildError(
            f"no C compiler for {name}; install the extra segfmu[platforms], which has ziglang"
        )
    chosen = TARGETS[name]
    options = (*_ZIG, *(("-rtlib=none",) if chosen.suffix in _WHOLE else ()))
    return Compiler(
        (sys.executable, "-m", "ziglang", "cc", "-target", chosen.target, *options), chosen,
        metadata.version("ziglang"),
    )


def _version(command: str) -> str:
    """The version text of a compiler."""
    try:
        done = subprocess.run(
            [command, "--version"], capture_output=True, text=True, errors="replace", check=False
        )
    except OSError as error:
        raise BuildError(f"{command} cannot be run: {error.strerror}") from None
    return done.stdout.strip()


def _has_zig() -> bool:
    return find_spec("ziglang") is not None


def _own() -> str | None:
    """The C compiler that Python was built with, or another one of the usual names."""
    # the name may follow that of a program that runs it, such as ccache
    configured = [w for w in str(sysconfig.get_config_var("CC") or "").split() if w[0] != "-"]
    for name in (*configured[-1:], "cc", "gcc", "clang"):
        found: str | None = shutil.which(name)
        if found is not None:
            return found
    return None
