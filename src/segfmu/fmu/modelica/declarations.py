"""The public part of a Modelica class for an FMU: connectors, parameters, calculated values."""

from __future__ import annotations

from segfmu.fmu.modelica.drawing import Place
from segfmu.fmu.modelica.names import (
    CONNECTORS,
    identifier,
    listed,
    literal,
    modifiers,
    quoted,
    title,
    type_of,
)
from segfmu.fmu.standard.spec import Array, Spec, Variable

# inputs that a model may leave without a connection, by the first part of their names
UNUSED = ("wind",)

FOLDER = (
    '  parameter String folder = "" "folder of the unpacked FMU; empty: that in Resources/FMUs" '
    'annotation(Dialog(tab = "FMU"));'
)


def groups(spec: Spec) -> list[str]:
    """First parts of the names of the inputs."""
    return list(dict.fromkeys(title(v.name) for v in spec.where("input")))


def switches(spec: Spec) -> list[str]:
    """Parameters that say which inputs are connectors."""
    return [
        f"  parameter Boolean use_{group} = {'false' if group in UNUSED else 'true'} "
        f'"the connectors {group}_* are there; else the FMU has their start values" '
        'annotation(Dialog(tab = "inputs"), choices(checkBox = true));'
        for group in groups(spec)
    ]


def connectors(spec: Spec, where: dict[str, Place]) -> list[str]:
    """Connectors, and the values of inputs that are none."""
    lines = []
    for v in spec.where("input"):
        name = identifier(v.name)
        lines += [
            f"  Interfaces.RealInput {name}{modifiers(v, start=True)} if use_{title(v.name)} "
            f"{quoted(v.description)} {where[v.name].annotation};",
            f"  parameter Real {name}_start{modifiers(v)} = {literal(v, v.start or 0.0)} "
            f"{quoted(f'value where {name} is not there')} "
            'annotation(Dialog(tab = "inputs"));',
        ]
    for v in spec.where("output"):
        lines.append(
            f"  Interfaces.{CONNECTORS[v.kind]} {identifier(v.name)}{modifiers(v)} "
            f"{quoted(v.description)} {where[v.name].annotation};"
        )
    return lines


def parameters(spec: Spec) -> list[str]:
    """Parameters, enumerations by their types and arrays as tables."""
    arrays = {a.members[0]: a for a in spec.arrays}
    members = {m for a in spec.arrays for m in a.members}
    counts = {a.rows for a in spec.arrays}
    lines = []
    for v in settable(spec):
        if v.name in arrays:
            lines += _table(spec, arrays[v.name])
        elif v.name not in members and v.name not in counts:
            lines.append(
                f"  parameter {type_of(v)} {parameter_name(v)}{modifiers(v)} = "
                f"{literal(v, v.start or 0)} {quoted(_text(v))} "
                f"annotation(Dialog(tab = {quoted(_tab(v))}));"
            )
    return lines


def settable(spec: Spec) -> list[Variable]:
    """Parameters, and start values of calculated variables."""
    return [v for v in spec.variables if v.initial == "exact"]


def parameter_name(v: Variable) -> str:
    """The name of a parameter, which may be the start value of an output."""
    return identifier(v.name) + ("" if v.causality == "parameter" else "_start")


def _text(v: Variable) -> str:
    return v.description if v.causality == "parameter" else f"start value: {v.description}"


def _tab(v: Variable) -> str:
    return title(v.name) if v.causality == "parameter" else "start"


def _table(spec: Spec, array: Array) -> list[str]:
    """A table of parameters; the first one of several with the same rows counts them."""
    variables = {v.name: v for v in spec.variables}
    name, count = identifier(array.name), identifier(array.rows)
    first = next(a for a in spec.arrays if a.rows == array.rows)
    used = int(variables[array.rows].start or 0)
    v = variables[array.members[0]]
    starts = [variables[m].start or 0 for m in array.members[: used * array.columns]]
    values = [literal(v, start) for start in starts]
    rows = [values[i : i + array.columns] for i in range(0, len(values), array.columns)]
    columns = "" if array.columns == 1 else f", {array.columns}"
    size = f"{used if array is first else count}{columns}"
    if used == 0 or (array is not first and len(set(starts)) == 1):
        zero = v.kind == "Real" and not v.start
        value = f"zeros({size})" if zero else f"fill({literal(v, v.start or 0)}, {size})"
    elif array.columns == 1:
        value = listed(values)
    else:
        value = "[" + ";\n      ".join(", ".join(row) for row in rows) + "]"
    lines = [
        f"  parameter {v.kind} {name}[{':' if array is first else count}{columns}]"
        f"{modifiers(v, each=True)} = {value} {quoted(array.description)} "
        f"annotation(Dialog(tab = {quoted(title(array.name))}));"
    ]
    if array is first:
        text = quoted(variables[array.rows].description)
        lines.append(f"  final parameter Integer {count} = size({name}, 1) {text};")
    return lines


def others(spec: Spec) -> list[str]:
    """Calculated values of the FMU other than outputs, each once."""
    lines = []
    for v in (v for v in spec.where("calculatedParameter", "local") if v.same_as is None):
        fixed = "final parameter " if v.causality == "calculatedParameter" else ""
        own = modifiers(v)
        if fixed:
            own = own[:-1] + ", fixed = false)" if own else "(fixed = false)"
        lines.append(
            f"  {fixed}Real {identifier(v.name)}{own} {quoted(v.description)};"
        )
    return lines
