"""A Modelica class that runs one FMU, from its interface specification.

The class has the connectors and parameters of the specification. The FMU is an external object, and
all that its functions return is written as a function of time, states and inputs, so that tools can
order, repeat and differentiate numerically what they like. Events are those that the FMU names.
"""

from __future__ import annotations

from segfmu.fmu.modelica.drawing import Place, icon, places
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
from segfmu.fmu.standard.fmi2 import guid
from segfmu.fmu.standard.spec import Array, Spec, Variable

# inputs that a model may leave without a connection, by the first part of their names
UNUSED = ("wind",)
# inputs that start values of states can follow from
REFERENCE = "reference"

FOLDER = (
    '  parameter String folder = "" "folder of the unpacked FMU; empty: that in Resources/FMUs" '
    'annotation(Dialog(tab = "FMU"));'
)


def wrapper(spec: Spec) -> str:
    """The text of a class for one FMU."""
    where = places(spec)
    lines = [
        "within Segfmu;",
        f"model {spec.name} {quoted(spec.description)}",
        FOLDER, *_switches(spec), *_connectors(spec, where), *_parameters(spec),
        *_others(spec),
        "protected", *_hidden(spec),
        "initial equation", *_initial(spec),
        "equation", *_equations(spec),
        f"  annotation({icon(spec)});",
        f"end {spec.name};", "",
    ]
    return "\n".join(lines)


# ---- what users see ----


def _groups(spec: Spec) -> list[str]:
    return list(dict.fromkeys(title(v.name) for v in spec.where("input")))


def _switches(spec: Spec) -> list[str]:
    return [
        f"  parameter Boolean use_{group} = {'false' if group in UNUSED else 'true'} "
        f'"the connectors {group}_* are there; else the FMU has their start values" '
        'annotation(Dialog(tab = "inputs"), choices(checkBox = true));'
        for group in _groups(spec)
    ]


def _connectors(spec: Spec, where: dict[str, Place]) -> list[str]:
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


def _parameters(spec: Spec) -> list[str]:
    arrays = {a.members[0]: a for a in spec.arrays}
    members = {m for a in spec.arrays for m in a.members}
    counts = {a.rows for a in spec.arrays}
    lines = []
    for v in _settable(spec):
        if v.name in arrays:
            lines += _table(spec, arrays[v.name])
        elif v.name not in members and v.name not in counts:
            lines.append(
                f"  parameter {type_of(v)} {_parameter(v)}{modifiers(v)} = "
                f"{literal(v, v.start or 0)} {quoted(_text(v))} "
                f"annotation(Dialog(tab = {quoted(_tab(v))}));"
            )
    return lines


def _settable(spec: Spec) -> list[Variable]:
    """Parameters, and start values of what is calculated later."""
    return [v for v in spec.variables if v.initial == "exact"]


def _parameter(v: Variable) -> str:
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
    values = [float(variables[m].start or 0.0) for m in array.members[: used * array.columns]]
    rows = [values[i : i + array.columns] for i in range(0, len(values), array.columns)]
    columns = "" if array.columns == 1 else f", {array.columns}"
    if array is not first and not any(values):
        value = f"zeros({count}{columns})"
    elif array.columns == 1:
        value = listed(map(repr, values))
    else:
        value = "[" + ";\n      ".join(", ".join(map(repr, row)) for row in rows) + "]"
    v = variables[array.members[0]]
    lines = [
        f"  parameter Real {name}[{':' if array is first else count}{columns}]"
        f"{modifiers(v, each=True)} = {value} {quoted(array.description)} "
        f"annotation(Dialog(tab = {quoted(title(array.name))}));"
    ]
    if array is first:
        text = quoted(variables[array.rows].description)
        lines.append(f"  final parameter Integer {count} = size({name}, 1) {text};")
    return lines


def _others(spec: Spec) -> list[str]:
    lines = []
    for v in spec.where("calculatedParameter", "local"):
        fixed = "final parameter " if v.causality == "calculatedParameter" else ""
        own = modifiers(v)
        if fixed:
            own = own[:-1] + ", fixed = false)" if own else "(fixed = false)"
        lines.append(
            f"  {fixed}Real {identifier(v.name)}{own} {quoted(v.description)};"
        )
    return lines


# ---- how it works ----


def _hidden(spec: Spec) -> list[str]:
    inputs = [identifier(v.name) for v in spec.where("input")]
    scalars, tables = _real_parameters(spec)
    refs = [listed(spec.references[v.name] for v in scalars)]
    values = [listed(_parameter(v) for v in scalars)]
    lines = []
    for array in tables:
        name, count = identifier(array.name), identifier(array.rows)
        lines.append(_table_references(spec, array))
        if array.columns == 1:
            refs.append(f"{name}_references[1:{count}]")
            values.append(name)
        else:
            refs.append(f"FMI.references({name}_references, {count})")
            values.append(f"FMI.rows({name})")
    joint = ",\n      "
    lines += [
        f"  final parameter Integer real_references[:] = cat(1, {joint.join(refs)});",
        f"  final parameter Real reals[:] = cat(1, {joint.join(values)});",
        *_discrete_parameters(spec),
        f"  constant Integer input_references[{len(inputs)}] = "
        + _vector([str(spec.references[v.name]) for v in spec.where("input")], "0") + ";",
    ]
    lines += [f"  Interfaces.RealInput {name}_used;" for name in inputs]
    lines.append(f"  Real inputs[{len(inputs)}] = "
                 + _vector([f"{name}_used" for name in inputs], "0.0") + ";")
    lines += [
        f"  FMI.Instance fmu = FMI.Instance(folder, {quoted(spec.name)}, getInstanceName(),\n"
        f"      {quoted(guid(spec))}, {len(spec.states)});",
        '  final parameter Real started(fixed = false) "the FMU has its parameters";',
        '  final parameter Real begun(fixed = false) "the FMU is initialised";',
        # solvers bound errors by the tolerance times the sizes of the states
        f"  Real x[{len(spec.states)}]"
        + ("(each stateSelect = StateSelect.always, each nominal = 0.1)" if spec.states else "")
        + ' "states of the FMU";',
        '  discrete Real next(start = 0, fixed = true) "time of the next event";',
        '  Real last "changes with every event";',
    ]
    return lines


def _vector(items: list[str], zero: str) -> str:
    return listed(items) if items else f"fill({zero}, 0)"


def _real_parameters(spec: Spec) -> tuple[list[Variable], list[Array]]:
    members = {m for a in spec.arrays for m in a.members}
    scalars = [v for v in _settable(spec) if v.kind == "Real" and v.name not in members]
    return scalars, list(spec.arrays)


def _table_references(spec: Spec, array: Array) -> str:
    refs = [str(spec.references[m]) for m in array.members]
    name, rows = identifier(array.name), len(refs) // array.columns
    if array.columns == 1:
        return f"  constant Integer {name}_references[{rows}] = {listed(refs)};"
    table = ";\n      ".join(
        ", ".join(refs[i : i + array.columns]) for i in range(0, len(refs), array.columns)
    )
    return f"  constant Integer {name}_references[{rows}, {array.columns}] = [{table}];"


def _discrete_parameters(spec: Spec) -> list[str]:
    integers, booleans = [], []
    for v in _settable(spec):
        name, reference = _parameter(v), str(spec.references[v.name])
        if v.kind == "Boolean":
            booleans.append((reference, f"if {name} then 1 else 0"))
        elif v.kind == "Enumeration":
            integers.append((reference, f"Integer({name})"))
        elif v.kind == "Integer":
            integers.append((reference, name))
    lines = []
    for kind, rows in (("integer", integers), ("boolean", booleans)):
        lines += [
            f"  constant Integer {kind}_references[{len(rows)}] = "
            + _vector([r for r, _ in rows], "0") + ";",
            f"  final parameter Integer {kind}s[{len(rows)}] = "
            + _vector([value for _, value in rows], "0") + ";",
        ]
    return lines


def _calls(spec: Spec) -> list[tuple[tuple[str, ...], list[Variable]]]:
    """Real outputs by the inputs that they follow from at one time.

    In one call they would all follow from all inputs, and a controller would close algebraic loops.
    """
    inputs = {v.name for v in spec.where("input")}
    found: dict[tuple[str, ...], list[Variable]] = {}
    for v in spec.where("output", "local"):
        if v.kind == "Real":
            known = dict(spec.dependencies).get(v.name, ())
            found.setdefault(tuple(n for n in known if n in inputs), []).append(v)
    return list(found.items())


def _given(spec: Spec, names: tuple[str, ...]) -> str:
    """Value references and values of inputs, as arguments."""
    refs = [str(spec.references[n]) for n in names]
    values = [f"{identifier(n)}_used" for n in names]
    return f"{_vector(refs, '0')},\n      {_vector(values, '0.0')}"


def _initial(spec: Spec) -> list[str]:
    lines = [
        "  started = FMI.start(fmu, time, real_references, reals, integer_references, integers,\n"
        "      boolean_references, booleans);",
        "  begun = FMI.begin(fmu, input_references, inputs, started);",
    ]
    if spec.states:
        names = tuple(v.name for v in spec.where("input") if title(v.name) == REFERENCE)
        lines.append(
            f"  x = FMI.states(fmu, {_given(spec, names)}, {len(spec.states)}, started);"
        )
    calculated = spec.where("calculatedParameter")
    if calculated:
        refs = listed(spec.references[v.name] for v in calculated)
        names = listed(identifier(v.name) for v in calculated)
        lines.append(
            f"  {names} = FMI.reals(fmu, time, x, fill(0, 0), fill(0.0, 0), {refs}, started);"
        )
    return lines


def _equations(spec: Spec) -> list[str]:
    lines = []
    for v in spec.where("input"):
        name = identifier(v.name)
        lines.append(f"  connect({name}, {name}_used);")
    for group in _groups(spec):
        lines.append(f"  if not use_{group} then")
        for v in spec.where("input"):
            if title(v.name) == group:
                lines.append(f"    {identifier(v.name)}_used = {identifier(v.name)}_start;")
        lines.append("  end if;")
    lines += [
        "  when {initial(), time >= pre(next)} then",
        "    next = FMI.event(fmu, time, x, input_references, inputs, begun);",
        "  end when;",
        "  // what an event changed is seen behind it",
        "  last = started + pre(next);",
    ]
    if spec.states:
        acting = tuple(dict.fromkeys(
            n for _, rate in spec.states for n in dict(spec.dependencies).get(rate, ())
            if n in {v.name for v in spec.where("input")}
        ))
        lines.append(f"  der(x) = FMI.derivatives(fmu, time, x, {_given(spec, acting)}, last);")
    for names, members in _calls(spec):
        refs = listed(spec.references[v.name] for v in members)
        lines.append(
            f"  {listed(identifier(v.name) for v in members)}\n"
            f"      = FMI.reals(fmu, time, x, {_given(spec, names)},\n      {refs}, last);"
        )
    for v in spec.where("output"):
        if v.kind in ("Integer", "Boolean"):
            lines.append(
                f"  {identifier(v.name)} = FMI.{v.kind.lower()}"
                f"(fmu, {spec.references[v.name]}, last);"
            )
    return lines
