"""Base of the PythonFMU slaves: values by value reference, as the specification numbers them."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from math import inf, isfinite
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from pythonfmu import Fmi2Slave
from pythonfmu.enums import Fmi2Status

from segfmu.arrays import FloatArray
from segfmu.crane.variables import filled
from segfmu.errors import InputError, SegfmuError, SimulationError
from segfmu.fmu.python.release import release_at_exit
from segfmu.fmu.standard.spec import Spec, Value, Variable
from segfmu.fmu.standard.times import LATEST, REPEATED, ROUNDING, SAME
from segfmu.kernels import backend
from segfmu.kernels.messages import ACCESS, RANGE
from segfmu.kernels.numerics.records import AccessStatus, RangeFault, RangeStatus
from segfmu.kernels.records import Record

KINDS = {
    "real": ("Real",),
    "integer": ("Integer", "Enumeration"),
    "boolean": ("Boolean",),
    "string": (),
}


class SpecSlave(Fmi2Slave):  # type: ignore[misc]
    """A slave whose variables are those of a specification.

    Subclasses implement `initialise` (at the end of initialisation) and `advance` (a step), and
    read and write values by name.
    """

    spec: Spec
    # values in place of the specification's, where an FMU was built for a mission
    starts: ClassVar[dict[str, Value]] = {}

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.modelName = self.spec.name
        folder = Path(kwargs.get("resources") or "").parent
        release_at_exit(folder / "binaries" / "linux64" / f"{self.spec.name}.so")
        # by value reference
        self._values: dict[int, Value] = {
            r: 0 if v.start is None else v.start
            for r, v in enumerate(self.spec.variables, 1)
        }
        for name, value in self.starts.items():
            self._values[self.spec.references[name]] = value
        self.start_time = 0.0
        # the communication point, from the end of initialisation on
        self._now: float | None = None
        # why no step is possible: of a variable that is not set PythonFMU would make a fatal error
        self._refusal: str | None = None

    @abstractmethod
    def initialise(self) -> None:
        """Compute everything that follows from parameters and start values."""

    @abstractmethod
    def advance(self, time: float, step: float) -> None:
        """Advance from `time` by `step`."""

    def value(self, name: str) -> Any:
        """Value of a variable."""
        return self._values[self.spec.references[name]]

    def assign(self, names: tuple[str, ...], values: Any) -> None:
        """Set variables by name."""
        references = self.spec.references
        for name, value in zip(names, values, strict=True):
            self._values[references[name]] = value

    def filled(self, record: type[Record]) -> FloatArray:
        """A record of the kernels from the variables that feed it."""
        return filled(record, self.value)

    def show(self, record: type[Record], values: FloatArray) -> None:
        """Set the variables of a record; a Boolean is true above 0."""
        for place, name, _ in record.feeds():
            boolean = self.spec.variable(name).kind == "Boolean"
            self.assign((name,), (values[place] > 0.0 if boolean else values[place],))

    def setup_experiment(
        self, start_time: float, stop_time: float | None, tolerance: float | None
    ) -> None:
        self.start_time = start_time

    def exit_initialization_mode(self) -> None:
        self.compute(self.initialise)
        self._now = self.start_time

    def compute(self, follow: Callable[[], None]) -> None:
        """Check all ranges and compute what follows; the log says why that fails."""
        try:
            _require_time("the start time", self.start_time)
            self._require_ranges()
            follow()
        except SegfmuError as error:
            self.log(f"initialisation failed: {error}", Fmi2Status.error)
            raise

    def do_step(self, current_time: float, step_size: float) -> bool:
        try:
            self._require_step(current_time, step_size)
            # a step that fails leaves the model somewhere within it
            self._refusal = "no step is possible after one that failed"
            self.advance(current_time, step_size)
        except SegfmuError as error:
            self.log(str(error), Fmi2Status.error)
            return False
        self._refusal = None
        self._now = current_time + step_size
        return True

    def _require_step(self, time: float, step: float) -> None:
        """Raise SimulationError for a step that is none."""
        now = self._now
        if self._refusal is not None:
            raise SimulationError(self._refusal)
        if now is None:
            raise SimulationError("a step before the end of initialisation")
        if not 0.0 < step < inf:
            raise SimulationError(f"a step lasts longer than 0 s and ends, got {step:g} s")
        least = ROUNDING * (1.0 + abs(time))
        if not abs(time - now) <= min(SAME * (1.0 + abs(now)), REPEATED * step + least):
            raise SimulationError(f"the next step begins at {now:.15g} s, not at {time:.15g} s")
        _require_time("the step's end", time + step)
        if not time + step > time + least:
            raise SimulationError(
                f"at {time:.9g} s a step must be longer than {least:.3g} s, got {step:g} s"
            )

    def _require_ranges(self) -> None:
        """Raise InputError for a parameter outside the range that the specification gives."""
        for variable, value in zip(self.spec.variables, self._values.values(), strict=True):
            fault = _range_fault(variable, value)
            if fault is not None:
                raise InputError(fault)

    def _get(self, kind: str, references: list[int]) -> list[Any]:
        self._check(kind, references)
        return [self._values[r] for r in references]

    def _set(self, kind: str, references: list[int], values: list[Any]) -> None:
        self._check(kind, references)
        for reference, value in zip(references, values, strict=True):
            variable = self.spec.variables[reference - 1]
            if self._is_settable(variable) and self._fits(variable, value):
                self._values[reference] = value

    def _is_settable(self, variable: Variable) -> bool:
        """Whether a variable may be set now; if not, the next step is refused for it."""
        when = ""
        if variable.causality != "input" and variable.start is None:
            when = "at all"
        elif self._now is not None and (
            variable.causality == "output" or variable.variability == "fixed"
        ):
            when = "now"
        if when:
            self._refusal = f"{variable.name} cannot be set {when}"
            self.log(self._refusal, Fmi2Status.error)
        return not when

    def _fits(self, variable: Variable, value: Any) -> bool:
        """Whether a running model takes a value; if not, the next step is refused for it."""
        fault = None
        if self._now is not None:
            fault = _range_fault(variable, value)
        if fault is not None:
            signal = variable.causality == "input"
            refused = "input refused" if signal else "tuning refused"
            self._refusal = f"{refused}: {fault}"
            self.log(self._refusal, Fmi2Status.error)
        return fault is None

    def _check(self, kind: str, references: list[int]) -> None:
        for reference in references:
            if reference not in self._values:
                raise ValueError(ACCESS.text(AccessStatus.NO_VARIABLE, [reference]))
            variable = self.spec.variables[reference - 1]
            if variable.kind not in KINDS[kind]:
                raise TypeError(f"{variable.name} is of type {variable.kind}, not {kind}")

    def get_real(self, vrs: list[int]) -> list[float]:
        return [float(v) for v in self._get("real", vrs)]

    def get_integer(self, vrs: list[int]) -> list[int]:
        return [int(v) for v in self._get("integer", vrs)]

    def get_boolean(self, vrs: list[int]) -> list[bool]:
        return [bool(v) for v in self._get("boolean", vrs)]

    def get_string(self, vrs: list[int]) -> list[str]:
        return self._get("string", vrs)

    def set_real(self, vrs: list[int], values: list[float]) -> None:
        self._set("real", vrs, values)

    def set_integer(self, vrs: list[int], values: list[int]) -> None:
        self._set("integer", vrs, values)

    def set_boolean(self, vrs: list[int], values: list[bool]) -> None:
        self._set("boolean", vrs, values)

    def set_string(self, vrs: list[int], values: list[str]) -> None:
        self._set("string", vrs, values)


def _range_fault(variable: Variable, value: float) -> str | None:
    """What is wrong with a value outside of its variable's range, or with one that is no number."""
    if not isfinite(value):
        return f"{variable.name} must be finite, got {value:g}"
    least, most = variable.minimum, variable.maximum
    if variable.enumeration is not None:
        least, most = 1, len(variable.enumeration.items)
    if least is None and most is None:
        return None
    fault = np.zeros(RangeFault.SIZE)
    status = backend.check_range(
        value, -inf if least is None else least, inf if most is None else most, fault
    )
    if status == RangeStatus.INSIDE:
        return None
    return f"{variable.name} {RANGE.text(status, fault.tolist())}"


def _require_time(what: str, time: float) -> None:
    """Raise SimulationError for a time that has no digits for a clock behind it."""
    if not abs(time) <= LATEST:
        raise SimulationError(f"{what} must be within {LATEST:g} s of 0, got {time:.15g} s")
