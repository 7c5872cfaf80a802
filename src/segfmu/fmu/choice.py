"""Which backend builds the FMUs, and for which platforms."""

from __future__ import annotations

from dataclasses import dataclass

from segfmu.errors import InputError
from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import sources
from segfmu.fmu.native.binaries import packaged
from segfmu.fmu.native.compilers import PLATFORMS, available, host

BACKENDS = ("native", "python")


@dataclass(frozen=True)
class Choice:
    """A backend, its platforms (none: the host's), and a note for the user."""

    native: bool
    fmi: int = 2
    platforms: tuple[str, ...] = ()
    note: str = ""


def require_native(choice: Choice, option: str) -> None:
    """Refuse `option`, which asks for files for other tools, if the FMUs do not support it.

    Raises
    ------
    InputError
        For other FMUs than native ones of FMI 2.0.
    """
    if not choice.native or choice.fmi != 2:
        raise InputError(
            f"{option} needs native FMUs of FMI 2: omit --fmi and --backend, and install a C "
            "compiler, or the extra segfmu[platforms]"
        )


def chosen(fmi: int, backend: str, platforms: str, *, everywhere: bool = True) -> Choice:
    """The requested backend, or Python if there is neither a binary nor a C compiler.

    `platforms` is a list with commas, or "all". If empty: all platforms whose binaries come with
    the package, else this machine's; without `everywhere`: this machine's.

    Raises
    ------
    InputError
        For choices that do not exist or exclude each other.
    """
    if fmi not in (2, 3):
        raise InputError(f"--fmi must be 2 or 3, got {fmi}")
    if backend not in BACKENDS:
        raise InputError(f"--backend must be one of {', '.join(BACKENDS)}, got {backend!r}")
    names = tuple(PLATFORMS) if platforms == "all" else tuple(
        n.strip() for n in platforms.split(",") if n.strip()
    )
    for name in names:
        if name not in PLATFORMS:
            raise InputError(
                f"--platforms must be all or some of {', '.join(PLATFORMS)}, got {name!r}"
            )
    if backend == "python":
        if fmi == 3 or names:
            raise InputError("--backend python has neither FMI 3 nor platforms; use native")
        return Choice(native=False)
    ready = packaged((m.name, sources(m.name, fmi)) for m in registered())
    if names or (ready and everywhere):
        return Choice(True, fmi, names or ready)
    if fmi == 3 or available() or host() in ready:
        return Choice(True, fmi)
    return Choice(
        native=False,
        note="no C compiler found; built with the Python backend. Install a C compiler, or the "
        "extra segfmu[platforms]",
    )
