"""The declaration of a model, stated in its folder; everything else follows from it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import files

from segfmu.fmu.sources import sources_of
from segfmu.fmu.standard.spec import Spec
from segfmu.kernels.records import Record

# where a model's page shows the drawing of the crane
DRAWING = "<!-- crane.svg -->"


@dataclass(frozen=True)
class Model:
    """A model from which FMUs are built.

    Attributes
    ----------
    name : str
        Of the FMU, as in its specification.
    package : str
        The model's folder. It has `c`, the sources of the model in C, `about.html`, the model's
        part of the documentation page, and `icon.png` unless the first shared package has it.
    spec : callable
        The interface on PythonFMU.
    native_spec : callable
        The interface of native FMUs, from that on PythonFMU with any start values.
    largest : callable
        The native interface with as many rows as its arrays can have, which the binary is made of.
        Rows are its last variables; an archive may describe fewer.
    records : tuple of type of Record
        Those of the kernels that the model in C fills from variables, or shows as variables.
    shared : tuple of str
        Packages whose sources in C the model has too.
    slave : str
        The slave on PythonFMU as module:class, which only that backend imports; empty for none.
    """

    name: str
    package: str
    spec: Callable[[], Spec]
    native_spec: Callable[[Spec], Spec]
    largest: Callable[[], Spec]
    records: tuple[type[Record], ...] = ()
    shared: tuple[str, ...] = ()
    slave: str = ""

    @property
    def sources(self) -> dict[str, bytes]:
        """Texts of the model in C by the names of their files."""
        found: dict[str, bytes] = {}
        for package in (*self.shared, self.package):
            found |= sources_of(package)
        return found

    @property
    def icon(self) -> bytes:
        """The picture that importers show."""
        own = files(self.package).joinpath("icon.png")
        found = own if own.is_file() else files(self.shared[0]).joinpath("icon.png")
        return found.read_bytes()

    @property
    def about(self) -> str:
        """What the model does, its equations and its use, as HTML."""
        text = files(self.package).joinpath("about.html").read_text(encoding="utf-8")
        drawing = files("segfmu.fmu").joinpath("crane.svg").read_text(encoding="utf-8")
        # without the lines that only a file of its own has
        return text.replace(DRAWING, drawing[drawing.index("<svg") :])
