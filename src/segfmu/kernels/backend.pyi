# Generated from the kernels in Python by `python -m segfmu.codegen`; never edited.
"""The entry points of the kernels, see backend.py."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

COMPILED: bool

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

def state_scale(
    order: int,
    duration: float,
    limits: Floats,
    /,
) -> float: ...

def check_rope(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    bounds: Floats,
    work: Floats,
    report: Floats,
    /,
) -> int: ...

def clearance_spans(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    gravity: float,
    work: Floats,
    spans: Floats,
    /,
) -> int: ...

def contact_times(
    part: int,
    until: float,
    count: int,
    box: Floats,
    spans: Floats,
    stack: Floats,
    times: Floats,
    place: Floats,
    /,
) -> int: ...

def path_excursion(
    led: Floats,
    positions: Floats,
    times: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    work: Floats,
    excursion: Floats,
    /,
) -> int: ...

def leaves_range(
    axis: int,
    begin: float,
    end: float,
    low: float,
    high: float,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    work: Floats,
    excursion: Floats,
    /,
) -> bool: ...

def path_ranges(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    gravity: float,
    work: Floats,
    ranges: Floats,
    /,
) -> None: ...

def first_contact(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    gravity: float,
    boxes: Floats,
    work: Floats,
    stack: Floats,
    ranges: Floats,
    lasting: bool,
    report: Floats,
    /,
) -> int: ...

def shrink_boxes(
    touch: float,
    boxes: Floats,
    /,
) -> None: ...

def write_box(
    space: Floats,
    obstacle: Floats,
    box: Floats,
    /,
) -> None: ...

def space_contact(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    space: Floats,
    obstacles: Floats,
    boxes: Floats,
    work: Floats,
    stack: Floats,
    ranges: Floats,
    lasting: bool,
    fault: Floats,
    /,
) -> int: ...

def crane_rhs(
    state: Floats,
    generalized_force: Floats,
    load_force: Floats,
    masses: Floats,
    derivative: Floats,
    /,
) -> None: ...

def crane_driven(
    state: Floats,
    carriage: Floats,
    generalized_force: Floats,
    load_force: Floats,
    masses: Floats,
    derivative: Floats,
    force: Floats,
    /,
) -> None: ...

def crane_flat_inverse(
    flat: Floats,
    masses: Floats,
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
    masses: Floats,
    energy: Floats,
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

def hook_derivatives(
    flat: Floats,
    order: int,
    masses: Floats,
    hook_mass: float,
    sling: float,
    work: Floats,
    found: Floats,
    /,
) -> None: ...

def flat_orders(
    resistance: Floats,
    /,
) -> int: ...

def feedback_correction(
    state: Floats,
    reference: Floats,
    added: Floats,
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
    plant: Floats,
    length: float,
    bandwidth: float,
    pendulum: float,
    hoist_bandwidth: float,
    damping: float,
    gains: Floats,
    /,
) -> None: ...

def observer_predict(
    axis: int,
    length: float,
    table: Floats,
    command: float,
    correction: float,
    estimate: Floats,
    scratch: Floats,
    /,
) -> None: ...

def observer_correct(
    length: float,
    table: Floats,
    measured: Floats,
    reference: Floats,
    estimate: Floats,
    /,
) -> None: ...

def observer_design(
    plant: Floats,
    sample_time: float,
    length: float,
    expected: Floats,
    work: Floats,
    table: Floats,
    /,
) -> None: ...

def rope_range(
    length: float,
    shortest: float,
    longest: float,
    found: Floats,
    /,
) -> None: ...

def table_lengths(
    shortest: float,
    longest: float,
    rows: int,
    lengths: Floats,
    /,
) -> int: ...

def flat_table(
    plant: Floats,
    design: Floats,
    rows: int,
    lengths: Floats,
    table: Floats,
    /,
) -> None: ...

def set_steps(
    sensors: Floats,
    longest: float,
    uncertainty: Floats,
    /,
) -> None: ...

def observer_table(
    plant: Floats,
    sample_time: float,
    uncertainty: Floats,
    rows: int,
    lengths: Floats,
    expected: Floats,
    work: Floats,
    table: Floats,
    /,
) -> bool: ...

def nominal_payload(
    expected: float,
    payload: float,
    /,
) -> float: ...

def signal_age(
    dead_time: float,
    sampling: float,
    period: float,
    /,
) -> float: ...

def drive_bound(
    plant: Floats,
    axis: int,
    sign: float,
    /,
) -> float: ...

def set_walks(
    plant: Floats,
    uncertainty: Floats,
    /,
) -> None: ...

def set_drives(
    plant: Floats,
    tracking: Floats,
    /,
) -> None: ...

def set_tracking(
    plant: Floats,
    design: Floats,
    longest: float,
    tracking: Floats,
    /,
) -> None: ...

def set_fading(
    tracking: Floats,
    /,
) -> None: ...

def check_gains(
    plant: Floats,
    period: float,
    predicted: int,
    ends: Floats,
    table: Floats,
    work: Floats,
    fault: Floats,
    /,
) -> int: ...

def track_setpoint(
    parameters: Floats,
    table: Floats,
    gains: Floats,
    tick: Floats,
    memory: Floats,
    /,
) -> None: ...

def crane_load_partials(
    state: Floats,
    partials: Floats,
    /,
) -> None: ...

def crane_energy_partials(
    state: Floats,
    masses: Floats,
    partials: Floats,
    /,
) -> None: ...

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

def resists(
    resistance: Floats,
    axis: int,
    /,
) -> bool: ...

def planned_friction(
    resistance: Floats,
    axis: int,
    time: float,
    position: float,
    velocity: float,
    contacts: Floats,
    /,
) -> float: ...

def contact_history(
    axis: int,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    resistance: Floats,
    work: Floats,
    contacts: Floats,
    /,
) -> int: ...

def next_contact_event(
    time: float,
    start: float,
    contacts: Floats,
    /,
) -> float: ...

def drive_demands(
    flat: Floats,
    times: Floats,
    resistance: Floats,
    contacts: Floats,
    work: Floats,
    demands: Floats,
    /,
) -> None: ...

def plant_failure(
    status: int,
    time: float,
    state: Floats,
    plant: Floats,
    fault: Floats,
    /,
) -> int: ...

def friction_derivative(
    resistance: Floats,
    axis: int,
    time: float,
    motion: Floats,
    order: int,
    contacts: Floats,
    work: Floats,
    /,
) -> float: ...

def demand_peaks(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    resistance: Floats,
    contacts: Floats,
    work: Floats,
    peaks: Floats,
    times: Floats,
    /,
) -> None: ...

def demand_samples(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    resistance: Floats,
    contacts: Floats,
    work: Floats,
    peaks: Floats,
    times: Floats,
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

def turbulence_components(
    speed: float,
    length: float,
    bandwidth: float,
    deviation: Floats,
    numbers: Floats,
    components: Floats,
    /,
) -> None: ...

def plant_advance(
    plant: Floats,
    components: Floats,
    time: float,
    state: Floats,
    duration: float,
    tolerance: float,
    work: Floats,
    report: Floats,
    /,
) -> int: ...

def bound_uses(
    peaks: Floats,
    times: Floats,
    bounds: Floats,
    uses: Floats,
    fault: Floats,
    /,
) -> int: ...

def has_bounds(
    first: int,
    last: int,
    bounds: Floats,
    /,
) -> bool: ...

def paced_use(
    uses: Floats,
    /,
) -> float: ...

def hook_design(
    plant: Floats,
    sample_time: float,
    length: float,
    weights: Floats,
    work: Floats,
    table: Floats,
    /,
) -> None: ...

def hook_correction(
    table: Floats,
    limits: Floats,
    measured: Floats,
    reference: Floats,
    feedforward: Floats,
    estimates: Floats,
    correction: Floats,
    /,
) -> None: ...

def hook_frequencies(
    rope: float,
    masses: Floats,
    found: Floats,
    /,
) -> None: ...

def hook_load_motion(
    state: Floats,
    tension: Floats,
    masses: Floats,
    work: Floats,
    load: Floats,
    /,
) -> None: ...

def hook_outputs(
    memory: Floats,
    outputs: Floats,
    /,
) -> None: ...

def check_hook(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    masses: Floats,
    hook_mass: float,
    sling: float,
    bounds: Floats,
    polynomials: Floats,
    work: Floats,
    report: Floats,
    /,
) -> int: ...

def write_heading(
    places: Floats,
    heading: Floats,
    /,
) -> None: ...

def begin_pace(
    most: float,
    full: float,
    pace: Floats,
    /,
) -> None: ...

def next_pace(
    use: float,
    pace: Floats,
    /,
) -> bool: ...

def unite_waypoints(
    states: Floats,
    place: Floats,
    /,
) -> None: ...

def write_free(
    states: Floats,
    place: Floats,
    dwells: Floats,
    heading: Floats,
    kinds: Floats,
    led: Floats,
    /,
) -> None: ...

def write_states(
    unknowns: Floats,
    kinds: Floats,
    table: Floats,
    place: Floats,
    heading: Floats,
    states: Floats,
    /,
) -> None: ...

def is_judged(
    duration: float,
    uses: Floats,
    search: Floats,
    /,
) -> bool: ...

def cap_best(
    axes: Floats,
    search: Floats,
    /,
) -> None: ...

def write_best(
    pace: float,
    search: Floats,
    /,
) -> None: ...

def keep_best(
    pace: float,
    search: Floats,
    /,
) -> None: ...

def begin_limits(
    starts: Floats,
    kinds: Floats,
    search: Floats,
    /,
) -> None: ...

def next_limits(
    duration: float,
    uses: Floats,
    starts: Floats,
    search: Floats,
    values: Floats,
    slopes: Floats,
    newton: Floats,
    /,
) -> bool: ...

def write_axes(
    narrow: bool,
    positions: Floats,
    velocities: Floats,
    accelerations: Floats,
    bounds: Floats,
    caps: Floats,
    resistance: Floats,
    axes: Floats,
    /,
) -> None: ...

def narrow_bounds(
    bounds: Floats,
    caps: Floats,
    /,
) -> None: ...

def write_kinds(
    axes: Floats,
    kinds: Floats,
    /,
) -> None: ...

def write_limits(
    unknowns: Floats,
    axes: Floats,
    table: Floats,
    /,
) -> None: ...

def write_shares(
    peaks: Floats,
    bounds: Floats,
    axes: Floats,
    uses: Floats,
    /,
) -> None: ...

def write_starts(
    rope: float,
    bounds: Floats,
    resistance: Floats,
    axes: Floats,
    starts: Floats,
    fault: Floats,
    /,
) -> int: ...

def write_passing(
    positions: Floats,
    kinds: Floats,
    axes: Floats,
    heading: Floats,
    start: Floats,
    /,
) -> None: ...

def check_range(
    value: float,
    least: float,
    most: float,
    fault: Floats,
    /,
) -> int: ...

def begin_time(
    given: float,
    start: float,
    /,
) -> float: ...

def ramp_duration(
    change: float,
    axis: Floats,
    /,
) -> tuple[float, float]: ...

def ramp_pieces(
    axis: Floats,
    /,
) -> int: ...

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

def cut_plan(
    time: float,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    cut_timing: Floats,
    cut_coefficients: Floats,
    cut_offsets: Integers,
    /,
) -> int: ...

def meet_ends(
    clock: float,
    dwell: float,
    timing: Floats,
    offsets: Integers,
    /,
) -> None: ...

def anchor_plan(
    ends: Floats,
    limits: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    /,
) -> None: ...

def join_plans(
    lead_timing: Floats,
    lead_coefficients: Floats,
    lead_offsets: Integers,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    joined_timing: Floats,
    joined_coefficients: Floats,
    joined_offsets: Integers,
    /,
) -> int: ...

def measure_phases(
    phases: Floats,
    count: int,
    v: float,
    within: float,
    axis: Floats,
    /,
) -> tuple[float, float, float, float, float]: ...

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

def shortest_profile(
    problem: Floats,
    axis: Floats,
    phases: Floats,
    work: Floats,
    /,
) -> int: ...

def find_brake(
    whole: bool,
    limits: Floats,
    lead: Floats,
    timing: Floats,
    coefficients: Floats,
    /,
) -> int: ...

def plan_ends(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    ends: Floats,
    /,
) -> None: ...

def are_at_velocities(
    targets: Floats,
    limits: Floats,
    ends: Floats,
    /,
) -> bool: ...

def find_leads(
    states: Floats,
    limits: Floats,
    lower: Floats,
    plan_offsets: Integers,
    plan_timing: Floats,
    plan_coefficients: Floats,
    ends: Floats,
    lead: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    /,
) -> int: ...

def find_brakes(
    start: Floats,
    limits: Floats,
    lower: Floats,
    brakes: Floats,
    lead: Floats,
    timing: Floats,
    coefficients: Floats,
    /,
) -> bool: ...

def timed_profile(
    target: float,
    axis: Floats,
    cell: Floats,
    work: Floats,
    /,
) -> float: ...

def plan_phases(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    lower: Floats,
    options: Floats,
    axes: Floats,
    cells: Floats,
    work: Floats,
    /,
) -> int: ...

def spline_share(
    highest: bool,
    duration: float,
    first: Floats,
    last: Floats,
    allowed: Floats,
    axis: Floats,
    work: Floats,
    /,
) -> float: ...

def append_spline(
    duration: float,
    first: Floats,
    last: Floats,
    timing: Floats,
    coefficients: Floats,
    row: int,
    state: Floats,
    work: Floats,
    /,
) -> int: ...

def count_pieces(
    axes: Floats,
    cells: Floats,
    /,
) -> int: ...

def judge_pieces(
    states: Floats,
    times: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    limits: Floats,
    lower: Floats,
    brakes: Floats,
    lead: Floats,
    spare_timing: Floats,
    spare_coefficients: Floats,
    /,
) -> bool: ...

def plan_onward(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    lower: Floats,
    axes: Floats,
    cells: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    times: Floats,
    lead: Floats,
    /,
) -> int: ...

def keeps_drives(
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    known: Floats,
    work: Floats,
    /,
) -> bool: ...

def foresee_emergency(
    operation: Floats,
    known: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    work: Floats,
    /,
) -> bool: ...

def take_over_measured(
    operation: Floats,
    known: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    work: Floats,
    stack: Floats,
    /,
) -> int: ...

def begin_operation(
    time: float,
    operation: Floats,
    /,
) -> None: ...

def operate(
    operation: Floats,
    limits: Floats,
    known: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    states: Floats,
    cells: Floats,
    lead: Floats,
    work: Floats,
    stack: Floats,
    /,
) -> bool: ...

def check_ready(
    compensation: Floats,
    resistance: Floats,
    pieces: int,
    fault: Floats,
    /,
) -> int: ...

def next_operation(
    operation: Floats,
    /,
) -> float: ...

def check_problem(
    states: Floats,
    limits: Floats,
    report: Floats,
    /,
) -> int: ...

def motion_scale(
    order: int,
    states: Floats,
    limits: Floats,
    /,
) -> float: ...

def settle_states(
    first: int,
    states: Floats,
    limits: Floats,
    lower: Floats,
    /,
) -> int: ...

def settle_dwells(
    sample_time: float,
    dwells: Floats,
    /,
) -> int: ...

def usual_room() -> float: ...

def begin_choice(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    lower: Floats,
    allowed: Floats,
    choice: Floats,
    place: Floats,
    tools: Floats,
    axes: Floats,
    spots: Floats,
    work: Floats,
    /,
) -> bool: ...

def next_passage(
    tools: Floats,
    spots: Floats,
    /,
) -> bool: ...

def choose_passage(
    choice: Floats,
    tools: Floats,
    axes: Floats,
    spots: Floats,
    links: Floats,
    spans: Floats,
    band: Floats,
    cells: Floats,
    timing: Floats,
    coefficients: Floats,
    work: Floats,
    /,
) -> None: ...

def end_choice(
    states: Floats,
    place: Floats,
    choice: Floats,
    tools: Floats,
    axes: Floats,
    /,
) -> None: ...

def measure_state(
    state: Floats,
    sensors: Floats,
    numbers: Floats,
    measured: Floats,
    /,
) -> None: ...

def rig_next_event(
    settings: Floats,
    memory: Floats,
    /,
) -> float: ...

def switch_correction(
    settings: Floats,
    memory: Floats,
    /,
) -> None: ...

def rig_event(
    settings: Floats,
    changes: Floats,
    table: Floats,
    gains: Floats,
    tracker: Floats,
    setpoints: Floats,
    time: float,
    memory: Floats,
    /,
) -> None: ...

def rig_signals(
    settings: Floats,
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

def rig_rows(
    settings: Floats,
    /,
) -> int: ...

def rig_start(
    settings: Floats,
    components: Floats,
    changes: Floats,
    state: Floats,
    setpoints: Floats,
    start: float,
    memory: Floats,
    /,
) -> None: ...

def rig_step(
    settings: Floats,
    components: Floats,
    changes: Floats,
    table: Floats,
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

def rig_outputs(
    target: Floats,
    memory: Floats,
    balance: Floats,
    outputs: Floats,
    /,
) -> None: ...

def tracking_estimates(
    parameters: Floats,
    tracker: Floats,
    estimates: Floats,
    /,
) -> None: ...

def rig_partials(
    components: Floats,
    time: float,
    memory: Floats,
    work: Floats,
    partials: Floats,
    /,
) -> bool: ...

def check_travel(
    least: Floats,
    greatest: Floats,
    fault: Floats,
    /,
) -> int: ...

def check_lags(
    plant: Floats,
    exchange: int,
    fault: Floats,
    /,
) -> int: ...

def check_friction(
    static: Floats,
    coulomb: Floats,
    fault: Floats,
    /,
) -> int: ...

def wind_speed(
    speed: Floats,
    /,
) -> float: ...

def check_turbulence(
    speed: Floats,
    deviation: Floats,
    fault: Floats,
    /,
) -> int: ...

def check_changes(
    changes: Floats,
    fault: Floats,
    /,
) -> int: ...

def check_slack(
    plant: Floats,
    exchange: int,
    fault: Floats,
    /,
) -> int: ...

def check_delays(
    plant: Floats,
    period: float,
    exchange: int,
    fault: Floats,
    /,
) -> int: ...

def check_sensors(
    sensors: Floats,
    fault: Floats,
    /,
) -> int: ...

def check_rope_bounds(
    length: float,
    shortest: float,
    longest: float,
    fault: Floats,
    /,
) -> int: ...

def check_lengths(
    lengths: Floats,
    fault: Floats,
    /,
) -> int: ...

def start_state(
    own: Floats,
    held: Floats,
    reference: Floats,
    state: Floats,
    /,
) -> None: ...

def check_start(
    state: Floats,
    reference: Floats,
    fault: Floats,
    /,
) -> int: ...

def judge_start(
    state: Floats,
    reference: Floats,
    gravity: float,
    fault: Floats,
    /,
) -> int: ...

def check_start_rope(
    length: float,
    shortest: float,
    longest: float,
    fault: Floats,
    /,
) -> int: ...

def is_elsewhere(
    before: Floats,
    reference: Floats,
    step: float,
    /,
) -> int: ...

def plan_motion(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    lower: Floats,
    axes: Floats,
    cells: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    times: Floats,
    work: Floats,
    /,
) -> int: ...

def expand_motion(
    states: Floats,
    dwells: Floats,
    limits: Floats,
    lower: Floats,
    axes: Floats,
    cells: Floats,
    timing: Floats,
    coefficients: Floats,
    offsets: Integers,
    times: Floats,
    work: Floats,
    /,
) -> int: ...
