"""The documentation page inside an FMU, from its specification."""

from __future__ import annotations

from html import escape

from segfmu.fmu.standard.spec import Spec, Variable

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 62rem; padding: 0 1rem;
  color: #1c2733; }
h1, h2 { line-height: 1.2; color: #12395b; } h2 { margin-top: 2.2rem; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #d8e0e8;
  vertical-align: top; }
th { background: #eef3f8; } code { background: #f2f5f8; padding: 0 .2rem; }
pre { background: #f2f5f8; padding: .8rem; overflow-x: auto; }
"""

ABOUT = {
    "GantryFeedforward": """
<p>At the end of initialisation the waypoints and limits are turned into a trajectory of the load
made of segmented transition polynomials: every derivative up to the order
<code>planner.smoothness</code> is continuous, every limit is kept, every waypoint is met with its
velocity and acceleration.
The crane is differentially flat, so forces, velocities and the whole state follow from the load's
position and its derivatives without integration.</p>
<p>All outputs are functions of time and of the parameters alone: any communication step is exact,
and there is no feedthrough. A plan that the limits, the rope or gravity do not admit ends the
initialisation with an error; the log names axis, waypoint interval and limit.</p>
<h2>Equations</h2>
<pre>w = p'' + g e_z        F_l = -m_p |w|        e = -w / |w|        l = p_z / e_z
(x_t, y_t) = (p - l e)_xy
F_x = (m_b + m_t) x_t'' + m_p p_x''        F_y = m_t y_t'' + m_p p_y''</pre>
<h2>Use</h2>
<p>Set <code>waypoint.count</code>, the waypoints, limits and masses before initialisation. Connect
every output to the input of GantryCrane with the same name, or the velocity setpoints to your
drives. Heights are negative below the trolley.</p>""",
    "GantryCrane": """
<p>The bridge moves in x and carries the trolley, which moves in y; the load hangs on a rope of
variable length. The equations are Lagrange's, solved exactly; the integration is adaptive. In mode
<code>force</code> the drives apply the force setpoints, in mode <code>velocity</code> bridge,
trolley and rope follow the velocity setpoints. A sampled state feedback, scheduled by rope length,
corrects the setpoints by the deviation of the state from its reference.</p>
<p>With <code>feedback.source</code> at <code>state</code> the feedback knows the true state. At
<code>measured</code> it gets <code>measured.*</code> alone: a Kalman filter for the crane of
<code>crane.*</code> with <code>feedback.payload_mass</code> finds velocities, rates, and unknown
accelerations of carriages, rope and load, which are rejected; the load's mass is estimated from the
force that holds it; setpoints stay within the drives' bounds without windup, and what is switched
or tuned fades in with <code>feedback.fade</code>.</p>
<p>Setpoints and references are taken as linear in time between the end of one step and the end of
the next: set the inputs to their values at the end of the step, as a co-simulation does that steps
GantryFeedforward first. Where input derivatives are given (native FMI 2.0, orders 1 to 3), they are
polynomials from the values at the beginning of the step instead.</p>
<h2>Equations</h2>
<pre>x_p = x_t + l sin(phi_x)
y_p = y_t - l cos(phi_x) sin(phi_y)
z_p = -l cos(phi_x) cos(phi_y)
T = m_p |p'|^2 / 2 + m_t (x_t'^2 + y_t'^2) / 2 + m_b x_t'^2 / 2        V = m_p g z_p
d/dt dL/dq' - dL/dq = Q        u = u* - K(l) (x - x*)
velocity drives: v' = clamp((v* - v) / lag, acceleration_max), force at most force_max
friction: viscous v + coulomb tanh(v / width), torque -friction.sway.viscous phi'
energy.kinetic + energy.potential
  = their start + energy.drives + energy.wind + energy.payload - energy.dissipated
observer, an axis: p' = v   v' = (u + m_p g phi) / m + d   l phi'' = -g phi - v' + w   d', w' noise
  (velocity drives: v' = a + d, or (v* - v) / lag + d); it expects signals that are one sample old
  where sensor.dead_time is half a feedback.sample_time or more</pre>
<h2>Use</h2>
<p>The start values of bridge, trolley, rope and sway set the initial state. The sign of
<code>force.hoist</code> is that of the rope's lengthening: tension is negative.</p>
<p>Everything is ideal by default. <code>drive.*</code> give the drives lag and bounds,
<code>friction.*</code> friction, <code>travel.*</code> end stops, <code>sensor.*</code> quantised,
noisy and late signals in <code>measured.*</code>, <code>wind.*</code> wind on the load, and
<code>payload[i]</code> changes of the load's mass. Random numbers follow their seeds. A step fails,
with the reason in the log, when an end stop is reached, the rope goes slack, or a sway angle comes
to 90 degrees.</p>""",
}

TITLES = {
    "input": "Inputs",
    "output": "Outputs",
    "local": "Local variables",
    "calculatedParameter": "Calculated parameters",
    "parameter": "Parameters",
}


def page(spec: Spec, version: str) -> str:
    """The page's HTML text."""
    tables = "".join(
        f"<h2>{title}</h2>{_table(rows)}"
        for causality, title in TITLES.items()
        if (rows := tuple(v for v in spec.variables if v.causality == causality))
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{spec.name}</title><style>{STYLE}</style></head><body>"
        f"<h1>{spec.name}</h1><p><strong>{escape(spec.description)}.</strong> "
        f"segfmu {escape(version)}; SI units.</p>{ABOUT[spec.name]}{tables}</body></html>\n"
    )


def _table(rows: tuple[Variable, ...]) -> str:
    body = "".join(
        f"<tr><td><code>{escape(v.name)}</code></td><td>{escape(v.unit or '-')}</td>"
        f"<td>{_start(v)}</td><td>{escape(v.description)}{_choices(v)}</td></tr>"
        for v in rows
    )
    return (
        "<table><tr><th>name</th><th>unit</th><th>start</th><th>meaning</th></tr>"
        f"{body}</table>"
    )


def _start(variable: Variable) -> str:
    if variable.start is None:
        return "-"
    if variable.enumeration is not None:
        return variable.enumeration.items[int(variable.start) - 1]
    return str(variable.start).lower() if variable.kind == "Boolean" else f"{variable.start:g}"


def _choices(variable: Variable) -> str:
    if variable.enumeration is None:
        return ""
    return f" ({', '.join(variable.enumeration.items)})"
