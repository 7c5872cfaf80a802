"""What an FMU shows to its importer, as plain data; every description is generated from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal

from segfmu.kernels.numerics.records import GivenTime

Kind = Literal["Real", "Integer", "Boolean", "Enumeration"]
Causality = Literal[
    "input", "output", "parameter", "calculatedParameter", "local", "independent"
]
Variability = Literal["continuous", "discrete", "fixed", "tunable"]
Value = float | int | bool
# of an input in its unit: beyond it is a fault, and the equations overflow
LARGEST = 1e20


@dataclass(frozen=True)
class Enumeration:
    """An enumeration type; items count from 1."""

    name: str
    items: tuple[str, ...]
    description: str


@dataclass(frozen=True)
class Variable:
    """One variable. `start` is None exactly where the FMU calculates the initial value.

    `computed` marks a start value that was computed from those of other variables. Its last digits
    may depend on the machine, so it is no part of the FMU's identity. `same_as` names the variable
    whose value this one has as well. `commands` marks a tunable parameter that `connected` makes an
    input.
    """

    name: str
    kind: Kind
    causality: Causality
    variability: Variability
    description: str
    start: Value | None = None
    unit: str | None = None
    minimum: float | None = None
    maximum: float | None = None
    nominal: float | None = None
    enumeration: Enumeration | None = None
    computed: bool = False
    same_as: str | None = None
    commands: bool = False

    @property
    def initial(self) -> str | None:
        """The FMI attribute `initial`; inputs and time have none."""
        if self.causality in ("input", "independent"):
            return None
        return "calculated" if self.start is None else "exact"


@dataclass(frozen=True)
class Array:
    """Scalars of FMI 2.0 that are one array in FMI 3.0, row by row.

    `rows` names the variable that counts the rows in use; a row has `columns` members, and the
    array has one dimension where `columns` is 1. `fixed`: it has as many rows in every build,
    others have those that the build makes room for.
    """

    name: str
    members: tuple[str, ...]
    rows: str
    columns: int
    description: str
    fixed: bool = False


@dataclass(frozen=True)
class Terminal:
    """A bus that connects FMUs: inputs and outputs whose names begin with one of these words."""

    name: str
    description: str
    words: tuple[str, ...]


@dataclass(frozen=True)
class Spec:
    """One FMU: its variables in the order of their value references.

    What follows the step size is for native FMUs alone: arrays of FMI 3.0, continuous states of
    model exchange with their derivatives, the variables that an unknown depends on, the highest
    order of output derivatives, the interfaces with directional derivatives, and constants of the
    Python package that the model in C shares; terminals are of FMI 3.0.
    """

    name: str
    description: str
    variables: tuple[Variable, ...]
    stop_time: float
    step_size: float
    arrays: tuple[Array, ...] = ()
    states: tuple[tuple[str, str], ...] = ()
    dependencies: tuple[tuple[str, tuple[str, ...]], ...] = ()
    orders: int = 0
    partials: tuple[str, ...] = ("ModelExchange", "CoSimulation")
    constants: tuple[tuple[str, float], ...] = ()
    terminals: tuple[Terminal, ...] = ()
    references: dict[str, int] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        # from 1 on, as some importers take them for indices
        references = {v.name: i for i, v in enumerate(self.variables, 1)}
        if len(references) != len(self.variables):
            raise AssertionError("variable names are unique by construction")
        if any(v.causality == "independent" for v in self.variables[:-1]):
            raise AssertionError("time is last, as FMI 2.0 does without it")
        rates = (self.variables[references[rate] - 1] for _, rate in self.states)
        if any(v.causality != "local" for v in rates):
            raise AssertionError("derivatives are variables of their own, as by `derivative`")
        object.__setattr__(self, "references", references)

    def variable(self, name: str) -> Variable:
        """The variable with a name."""
        return self.variables[self.references[name] - 1]

    @cached_property
    def starts(self) -> Mapping[str, Value | None]:
        """Start values of all variables, by name."""
        return {v.name: v.start for v in self.variables}

    def where(self, *causalities: Causality) -> tuple[Variable, ...]:
        """The variables with one of the given causalities."""
        return tuple(v for v in self.variables if v.causality in causalities)

    @property
    def signals(self) -> tuple[Variable, ...]:
        """The continuous inputs."""
        return tuple(v for v in self.where("input") if v.variability == "continuous")

    @property
    def enumerations(self) -> tuple[Enumeration, ...]:
        """Enumeration types in use, in the order of their first use."""
        return tuple(dict.fromkeys(v.enumeration for v in self.variables if v.enumeration))


def started(spec: Spec, values: Mapping[str, Value | str], **changes: Any) -> Spec:
    """A specification with other start values, enumerations also by item, and other fields.

    A value that is given counts as declared, also where the variable's was computed.

    Raises
    ------
    KeyError
        For a name that the specification does not have.
    """
    numbers = _numbers(spec, values)
    variables = tuple(
        replace(v, start=numbers[v.name], computed=False) if v.name in numbers else v
        for v in spec.variables
    )
    return replace(spec, variables=variables, **changes)


def start_values(spec: Spec, values: Mapping[str, Value | str]) -> dict[str, Value | None]:
    """Start values of all variables, by name, where those given take the place of its own.

    Raises
    ------
    KeyError
        For a name that the specification does not have.
    """
    return {**spec.starts, **_numbers(spec, values)}


def _numbers(spec: Spec, values: Mapping[str, Value | str]) -> dict[str, Value]:
    """Values of variables as numbers of their kind."""
    unknown = values.keys() - spec.references.keys()
    if unknown:
        raise KeyError(f"{spec.name} has no {', '.join(sorted(unknown))}")

    def number(v: Variable, value: Value | str) -> Value:
        if isinstance(value, str):
            if v.enumeration is None:
                raise TypeError(f"{v.name} takes a number, got {value!r}")
            return v.enumeration.items.index(value) + 1
        return value if v.kind == "Real" else bool(value) if v.kind == "Boolean" else int(value)

    return {name: number(spec.variable(name), value) for name, value in values.items()}


def numbered(spec: Spec) -> Spec:
    """A specification with integers in place of enumerations, for importers without them.

    The description of each says what its numbers mean.
    """

    def number(v: Variable) -> Variable:
        if v.enumeration is None:
            return v
        items = ", ".join(f"{i}: {item}" for i, item in enumerate(v.enumeration.items, 1))
        return replace(
            v, kind="Integer", enumeration=None, minimum=1, maximum=len(v.enumeration.items),
            description=f"{v.description} ({items})",
        )

    return replace(spec, variables=tuple(map(number, spec.variables)))


def connected(spec: Spec) -> Spec:
    """A specification with discrete inputs in place of commands.

    Not by default: some importers have zeros where nothing is connected, others need a connection.
    """
    variables = tuple(
        replace(v, causality="input", variability="discrete") if v.commands else v
        for v in spec.variables
    )
    return replace(spec, variables=variables)


def output(
    name: str, unit: str | None, description: str, *, nominal: float | None = None,
    start: float | None = None, kind: Kind = "Real",
) -> Variable:
    """An output: continuous if real, else discrete."""
    variability: Variability = "continuous" if kind == "Real" else "discrete"
    return Variable(
        name, kind, "output", variability, description, start, unit, nominal=nominal
    )


def derivative(state: str, rate: Variable) -> Variable:
    """The derivative of a state whose value is that of an output.

    Importers such as CasADi take every variable for one thing, so it is a variable of its own.
    """
    return Variable(
        f"der({state})", "Real", "local", "continuous", f"derivative of {state}: {rate.name}",
        unit=rate.unit, nominal=rate.nominal, same_as=rate.name,
    )


def signal(name: str, unit: str, description: str) -> Variable:
    """A continuous real input that starts at zero."""
    return Variable(
        name, "Real", "input", "continuous", description, 0.0, unit, -LARGEST, LARGEST
    )


def command(
    name: str, start: Value, unit: str | None, description: str, *,
    minimum: float | None = None, maximum: float | None = None, kind: Kind = "Real",
    enumeration: Enumeration | None = None,
) -> Variable:
    """A tunable parameter that FMUs may have as an input instead, see `connected`."""
    return Variable(
        name, kind, "parameter", "tunable", description, start, unit, minimum, maximum,
        enumeration=enumeration, commands=True,
    )


def parameter(
    name: str, start: Value, unit: str | None, description: str, *,
    minimum: float | None = None, maximum: float | None = None, kind: Kind = "Real",
    tunable: bool = False, computed: bool = False,
) -> Variable:
    """A fixed or tunable parameter."""
    return Variable(
        name, kind, "parameter", "tunable" if tunable else "fixed", description, start, unit,
        minimum, maximum, computed=computed,
    )


def calculated(name: str, unit: str | None, description: str) -> Variable:
    """A real number that initialisation finds."""
    return Variable(name, "Real", "calculatedParameter", "fixed", description, unit=unit)


def beginning(name: str, description: str) -> Variable:
    """A fixed parameter for the time at which something begins: by default with the simulation."""
    first = float(GivenTime.AT_START)
    return parameter(
        name, first, "s", f"{description}; {first:g}: the start of the simulation", minimum=first
    )


def choice(name: str, enumeration: Enumeration, start: str, description: str) -> Variable:
    """A fixed enumeration parameter."""
    return Variable(
        name, "Enumeration", "parameter", "fixed", description,
        enumeration.items.index(start) + 1, enumeration=enumeration,
    )


def triple(
    prefix: str, unit: str, description: str, names: Sequence[str] = ("x", "y", "z"),
    *, suffix: str = "",
) -> list[Variable]:
    """Three outputs of one quantity."""
    return [output(f"{prefix}.{n}{suffix}", unit, f"{description}, {n}") for n in names]


def triple_parameter(
    prefix: str, start: float, unit: str, description: str, *, minimum: float | None = None,
    maximum: float | None = None,
) -> list[Variable]:
    """Three fixed parameters of one quantity, along x, y and z."""
    return [
        parameter(
            f"{prefix}.{a}", start, unit, f"{description}, {a}", minimum=minimum, maximum=maximum
        )
        for a in "xyz"
    ]


def time() -> Variable:
    """The independent variable, for descriptions that name it."""
    return Variable("time", "Real", "independent", "continuous", "time", unit="s")
