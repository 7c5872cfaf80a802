"""Which backend builds the FMUs, and for which platforms."""

from __future__ import annotations

from dataclasses import dataclass, replace

from segfmu.arrays import shown
from segfmu.errors import InputError
from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import sources
from segfmu.fmu.native.binaries import packaged
from segfmu.fmu.native.compilers import PLATFORMS, available, host

BACKENDS = ("native", "python")
ENUMERATIONS = ("enumeration", "integer")
COMMANDS = ("parameters", "inputs")


@dataclass(frozen=True)
class Choice:
    """A backend, its platforms (the host's where there are none), and what the user must know.

    `numbered` makes enumerations integers, `connected` commands inputs.
    """

    native: bool
    fmi: int = 2
    platforms: tuple[str, ...] = ()
    note: str = ""
    numbered: bool = False
    connected: bool = False


def require_native(choice: Choice, option: str, versions: tuple[int, ...] = (2, 3)) -> None:
    """Refuse `option`, which asks for files for other tools, if the FMUs do not support it.

    Raises
    ------
    InputError
        For other FMUs than native ones with enumerations, of one of these versions of FMI.
    """
    if choice.connected:
        raise InputError(f"{option} needs commands as parameters: leave out commands inputs")
    if choice.numbered:
        raise InputError(f"{option} needs enumerations: leave out enumerations integer")
    if not choice.native:
        raise InputError(
            f"{option} needs native FMUs: omit backend, and install a C compiler, or the extra "
            "segfmu[platforms]"
        )
    if choice.fmi not in versions:
        raise InputError(f"{option} needs FMUs of FMI 2: omit fmi")


def chosen(
    fmi: int, backend: str, platforms: str, *, everywhere: bool = True,
    enumerations: str = "enumeration", commands: str = "parameters",
) -> Choice:
    """The backend asked for, or Python where there is neither a binary nor a C compiler.

    `platforms` is a list with commas, or "all". If empty: all platforms whose binaries come with
    the package, else this machine's; without `everywhere`: this machine's.

    Raises
    ------
    InputError
        For choices that do not exist or exclude each other.
    """
    if fmi not in (2, 3):
        raise InputError(f"fmi must be 2 or 3, got {shown(fmi)}")
    _require_one_of("backend", backend, BACKENDS)
    _require_one_of("enumerations", enumerations, ENUMERATIONS)
    _require_one_of("commands", commands, COMMANDS)
    return replace(
        _backend(fmi, backend, platforms, everywhere), numbered=enumerations == "integer",
        connected=commands == "inputs",
    )


def _backend(fmi: int, backend: str, platforms: str, everywhere: bool) -> Choice:
    names = tuple(PLATFORMS) if platforms == "all" else tuple(
        n.strip() for n in platforms.split(",") if n.strip()
    )
    for name in names:
        if name not in PLATFORMS:
            raise InputError(
                f"platforms must be all or some of {', '.join(PLATFORMS)}, got {shown(name)}"
            )
    if backend == "python":
        if fmi == 3 or names:
            raise InputError("backend python has neither FMI 3 nor platforms; use native")
        return Choice(native=False)
    if not names and everywhere:
        names = _packaged(fmi)
    if names or fmi == 3 or available() or host() in _packaged(fmi):
        return Choice(True, fmi, names)
    return Choice(
        native=False,
        note="no C compiler found; built with the Python backend. Install a C compiler, or the "
        "extra segfmu[platforms]",
    )


def _packaged(fmi: int) -> tuple[str, ...]:
    """Platforms whose binaries of all models come with the package: to look takes half a second."""
    return packaged((m.name, sources(m.name, fmi)) for m in registered())


def _require_one_of(name: str, value: object, known: tuple[str, ...]) -> None:
    if not isinstance(value, str) or value not in known:
        raise InputError(f"{name} must be one of {', '.join(known)}, got {shown(value)}")
