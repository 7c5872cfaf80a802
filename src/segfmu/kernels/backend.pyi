# Generated from the kernels in Python by `python -m segfmu.codegen`; never edited.
"""The entry points of the kernels, see backend.py."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

COMPILED: bool

def feedback_correction(
    state: Floats,
    reference: Floats,
    lengths: Floats,
    gains: Floats,
    correction: Floats,
    /,
) -> None: ...

def feedback_bandwidth(
    ratio: float,
    length: float,
    gravity: float,
    delay: float,
    largest: float,
    /,
) -> float: ...

def feedback_gains(
    driven: bool,
    length: float,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    bandwidth: float,
    hoist_bandwidth: float,
    damping: float,
    gains: Floats,
    /,
) -> None: ...

def observer_design(
    driven: bool,
    sample_time: float,
    length: float,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    lag: Floats,
    expected: Floats,
    work: Floats,
    table: Floats,
    /,
) -> None: ...

def observer_predict(
    length: float,
    lengths: Floats,
    table: Floats,
    command: Floats,
    held: Floats,
    estimate: Floats,
    scratch: Floats,
    /,
) -> None: ...

def observer_correct(
    length: float,
    lengths: Floats,
    table: Floats,
    measured: Floats,
    reference: Floats,
    estimate: Floats,
    /,
) -> None: ...

def track_setpoint(
    parameters: Floats,
    lengths: Floats,
    table: Floats,
    gain_lengths: Floats,
    gains: Floats,
    measured: Floats,
    reference: Floats,
    feedforward: Floats,
    memory: Floats,
    correction: Floats,
    /,
) -> None: ...

def crane_rhs(
    state: Floats,
    generalized_force: Floats,
    load_force: Floats,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    derivative: Floats,
    /,
) -> None: ...

def crane_driven(
    state: Floats,
    carriage: Floats,
    generalized_force: Floats,
    load_force: Floats,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    derivative: Floats,
    force: Floats,
    /,
) -> None: ...

def crane_flat_inverse(
    flat: Floats,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    force: Floats,
    state: Floats,
    acceleration: Floats,
    /,
) -> None: ...

def crane_load(
    state: Floats,
    load: Floats,
    /,
) -> None: ...

def crane_energy(
    state: Floats,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    energy: Floats,
    /,
) -> None: ...

def crane_load_partials(
    state: Floats,
    partials: Floats,
    /,
) -> None: ...

def crane_energy_partials(
    state: Floats,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    partials: Floats,
    /,
) -> None: ...

def flat_derivatives(
    flat: Floats,
    order: int,
    masses: Floats,
    work: Floats,
    found: Floats,
    /,
) -> None: ...

def compensate_setpoints(
    velocity: Floats,
    acceleration: Floats,
    lag: Floats,
    viscous: Floats,
    coulomb: Floats,
    width: float,
    force: Floats,
    setpoint: Floats,
    /,
) -> None: ...

def seed_numbers(
    seed: int,
    numbers: Floats,
    /,
) -> None: ...

def next_uniform(
    numbers: Floats,
    /,
) -> float: ...

def noise_components(
    bandwidth: float,
    deviation: Floats,
    numbers: Floats,
    components: Floats,
    /,
) -> None: ...

def plant_advance(
    parameters: Floats,
    components: Floats,
    time: float,
    state: Floats,
    command: Floats,
    rate: Floats,
    load_force: Floats,
    duration: float,
    tolerance: float,
    work: Floats,
    report: Floats,
    /,
) -> int: ...

def evaluate(
    times: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    derivative: int,
    values: Floats,
    /,
) -> None: ...

def evaluate_orders(
    time: float,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    values: Floats,
    /,
) -> None: ...

def check_plan(
    states: Floats,
    times: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    limits: Floats,
    tolerance: float,
    work: Floats,
    /,
) -> int: ...

def check_rope(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    bounds: Floats,
    work: Floats,
    report: Floats,
    /,
) -> int: ...

def ramp_duration(
    change: float,
    axis: Floats,
    /,
) -> tuple[float, float, float]: ...

def measure_phases(
    phases: Floats,
    count: int,
    v: float,
    within: float,
    axis: Floats,
    /,
) -> tuple[float, float, float, float, float]: ...

def shortest_profile(
    problem: Floats,
    axis: Floats,
    phases: Floats,
    work: Floats,
    /,
) -> int: ...

def timed_profile(
    target: float,
    axis: Floats,
    cell: Floats,
    work: Floats,
    /,
) -> float: ...

def axis_limits(
    smoothness: int,
    shape: int,
    limits: Floats,
    axis: Floats,
    /,
) -> None: ...

def ramp_parameters(
    share: float,
    axis: Floats,
    work: Floats,
    /,
) -> bool: ...

def plan_phases(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    options: Floats,
    axes: Floats,
    cells: Floats,
    work: Floats,
    /,
) -> int: ...

def measure_state(
    state: Floats,
    sensors: Floats,
    numbers: Floats,
    measured: Floats,
    /,
) -> None: ...

def switch_correction(
    loop: Floats,
    memory: Floats,
    /,
) -> None: ...

def rig_next_event(
    loop: Floats,
    sensors: Floats,
    memory: Floats,
    /,
) -> float: ...

def rig_event(
    loop: Floats,
    sensors: Floats,
    changes: Floats,
    tracking: Floats,
    lengths: Floats,
    table: Floats,
    gain_lengths: Floats,
    gains: Floats,
    tracker: Floats,
    setpoints: Floats,
    time: float,
    memory: Floats,
    /,
) -> None: ...

def rig_signals(
    sensors: Floats,
    time: float,
    memory: Floats,
    /,
) -> None: ...

def rig_rates(
    components: Floats,
    setpoints: Floats,
    time: float,
    memory: Floats,
    derivative: Floats,
    /,
) -> int: ...

def rig_partials(
    components: Floats,
    time: float,
    memory: Floats,
    work: Floats,
    partials: Floats,
    /,
) -> bool: ...

def rig_rows(
    sample_time: float,
    dead_time: float,
    /,
) -> int: ...

def rig_start(
    loop: Floats,
    sensors: Floats,
    changes: Floats,
    parameters: Floats,
    state: Floats,
    setpoints: Floats,
    start: float,
    memory: Floats,
    /,
) -> None: ...

def rig_step(
    loop: Floats,
    sensors: Floats,
    components: Floats,
    changes: Floats,
    tracking: Floats,
    lengths: Floats,
    table: Floats,
    gain_lengths: Floats,
    gains: Floats,
    tracker: Floats,
    setpoints: Floats,
    duration: float,
    memory: Floats,
    /,
) -> int: ...

def rig_balance(
    memory: Floats,
    balance: Floats,
    /,
) -> None: ...

def rig_imbalance(
    balance: Floats,
    /,
) -> float: ...

def same_break(
    time: float,
    /,
) -> float: ...

def next_plan_event(
    time: float,
    start: float,
    timing: Floats,
    offsets: Integers,
    ends: Floats,
    times: Floats,
    /,
) -> float: ...

def right_of_break(
    time: float,
    start: float,
    timing: Floats,
    offsets: Integers,
    ends: Floats,
    /,
) -> float: ...

def expand_phases(
    phases: Floats,
    count: int,
    axis: Floats,
    timing: Floats,
    coefficients: Floats,
    row: int,
    work: Floats,
    /,
) -> int: ...

def count_pieces(
    axes: Floats,
    cells: Floats,
    /,
) -> int: ...

def expand_plan(
    states: Floats,
    dwells: Floats,
    axes: Floats,
    cells: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    times: Floats,
    work: Floats,
    /,
) -> int: ...
