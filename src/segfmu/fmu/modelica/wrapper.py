"""A Modelica class that runs one FMU, from its interface specification.

The class has the connectors and parameters of the specification. The FMU is an external object. All
its results are functions of time, states and inputs, so that tools can order, repeat and
numerically differentiate the calls. The FMU gives the times of events.
"""

from __future__ import annotations

from segfmu.fmu.modelica.declarations import (
    FOLDER,
    connectors,
    groups,
    others,
    parameter_name,
    parameters,
    settable,
    switches,
)
from segfmu.fmu.modelica.drawing import icon, places
from segfmu.fmu.modelica.names import identifier, listed, quoted, title
from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.spec import Array, Kind, Spec, Variable

# between the parts of a vector
JOINT = ",\n      "
# inputs that start values of states can follow from
REFERENCE = "reference"


def wrapper(spec: Spec) -> str:
    """The text of a class for one FMU."""
    where = places(spec)
    lines = [
        "within Segfmu;",
        f"model {spec.name} {quoted(spec.description)}",
        FOLDER, *switches(spec), *connectors(spec, where), *parameters(spec),
        *others(spec),
        "protected", *_hidden(spec),
        "initial equation", *_initial(spec),
        "equation", *_equations(spec),
        f"  annotation({icon(spec)});",
        f"end {spec.name};", "",
    ]
    return "\n".join(lines)


def _hidden(spec: Spec) -> list[str]:
    return [*_real_parameters(spec), *_discrete_parameters(spec), *_used(spec), *_state(spec)]


def _used(spec: Spec) -> list[str]:
    """Inputs as the FMU has them: connected, or at their start values."""
    inputs = spec.where("input")
    refs = _vector([str(spec.references[v.name]) for v in inputs], "0")
    values = _vector([f"{identifier(v.name)}_used" for v in inputs], "0.0")
    return [
        f"  constant Integer input_references[{len(inputs)}] = {refs};",
        *(f"  Interfaces.RealInput {identifier(v.name)}_used;" for v in inputs),
        f"  Real inputs[{len(inputs)}] = {values};",
    ]


def _state(spec: Spec) -> list[str]:
    # solvers bound errors by the tolerance times the sizes of the states
    sizes = "(each stateSelect = StateSelect.always, each nominal = 0.1)" if spec.states else ""
    return [
        f"  FMI.Instance fmu = FMI.Instance(folder, {quoted(spec.name)}, getInstanceName(),\n"
        f"      {quoted(guid(spec))}, {len(spec.states)});",
        '  final parameter Real started(fixed = false) "the FMU has its parameters";',
        '  final parameter Real begun(fixed = false) "the FMU is initialised";',
        f'  Real x[{len(spec.states)}]{sizes} "states of the FMU";',
        '  discrete Real next(start = 0, fixed = true) "time of the next event";',
        '  Real last "changes with every event";',
    ]


def _vector(items: list[str], zero: str) -> str:
    return listed(items) if items else f"fill({zero}, 0)"


def _real_parameters(spec: Spec) -> list[str]:
    """Value references and values, scalars first, then the used rows of every table."""
    members = {m for a in spec.arrays for m in a.members}
    scalars = [v for v in settable(spec) if v.kind == "Real" and v.name not in members]
    refs, values = _tables(spec, "Real", "rows")
    refs.insert(0, listed(spec.references[v.name] for v in scalars))
    values.insert(0, listed(parameter_name(v) for v in scalars))
    return [
        *(_table_references(spec, array) for array in spec.arrays),
        f"  final parameter Integer real_references[:] = cat(1, {JOINT.join(refs)});",
        f"  final parameter Real reals[:] = cat(1, {JOINT.join(values)});",
    ]


def _tables(spec: Spec, kind: Kind, function: str) -> tuple[list[str], list[str]]:
    """Value references and values of the used rows of tables of a kind, the values by a function.

    A single column is taken as it is if it is real.
    """
    refs, values = [], []
    for array in (a for a in spec.arrays if spec.variable(a.members[0]).kind == kind):
        name, count = identifier(array.name), identifier(array.rows)
        flat = array.columns == 1
        refs.append(
            f"{name}_references[1:{count}]" if flat
            else f"FMI.references({name}_references, {count})"
        )
        table = f"matrix({name})" if flat else name
        values.append(name if flat and kind == "Real" else f"FMI.{function}({table})")
    return refs, values


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
    members = {m for a in spec.arrays for m in a.members}
    integers, booleans = [], []
    for v in (v for v in settable(spec) if v.name not in members):
        name, reference = parameter_name(v), str(spec.references[v.name])
        if v.kind == "Boolean":
            booleans.append((reference, f"if {name} then 1 else 0"))
        elif v.kind == "Enumeration":
            integers.append((reference, f"Integer({name})"))
        elif v.kind == "Integer":
            integers.append((reference, name))
    lines = []
    for kind, rows in (("integer", integers), ("boolean", booleans)):
        refs, values = _vector([r for r, _ in rows], "0"), _vector([v for _, v in rows], "0")
        tables = _tables(spec, "Boolean", "truths") if kind == "boolean" else ([], [])
        size, use = str(len(rows)), "constant"
        if tables[0]:
            refs, values = (
                f"cat(1, {JOINT.join([one, *others])})"
                for one, others in zip((refs, values), tables, strict=True)
            )
            size, use = ":", "final parameter"
        lines += [
            f"  {use} Integer {kind}_references[{size}] = {refs};",
            f"  final parameter Integer {kind}s[{size}] = {values};",
        ]
    return lines


def _calls(spec: Spec) -> list[tuple[tuple[str, ...], list[Variable]]]:
    """Real outputs, grouped by the inputs with direct effect on them.

    In one call all outputs would depend on all inputs, and a controller would close algebraic
    loops.
    """
    inputs = {v.name for v in spec.where("input")}
    found: dict[tuple[str, ...], list[Variable]] = {}
    for v in spec.where("output", "local"):
        if v.kind == "Real" and v.same_as is None:
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
        references = tuple(v.name for v in spec.where("input") if title(v.name) == REFERENCE)
        lines.append(
            f"  x = FMI.states(fmu, {_given(spec, references)}, {len(spec.states)}, started);"
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
    return [
        *_input_equations(spec),
        "  when {initial(), time >= pre(next)} then",
        "    next = FMI.event(fmu, time, x, input_references, inputs, begun);",
        "  end when;",
        "  // what an event changed is seen behind it",
        "  last = started + pre(next);",
        *_rates(spec), *_outputs(spec),
    ]


def _input_equations(spec: Spec) -> list[str]:
    names = {v.name: identifier(v.name) for v in spec.where("input")}
    lines = [f"  connect({name}, {name}_used);" for name in names.values()]
    for group in groups(spec):
        own = [name for n, name in names.items() if title(n) == group]
        lines += [
            f"  if not use_{group} then",
            *(f"    {name}_used = {name}_start;" for name in own),
            "  end if;",
        ]
    return lines


def _rates(spec: Spec) -> list[str]:
    if not spec.states:
        return []
    known = {
        n for _, rate in spec.states for n in dict(spec.dependencies).get(rate, ())
    }
    acting = tuple(v.name for v in spec.where("input") if v.name in known)
    return [f"  der(x) = FMI.derivatives(fmu, time, x, {_given(spec, acting)}, last);"]


def _outputs(spec: Spec) -> list[str]:
    lines = []
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
