"""Friction of the axes along a plan, by the history of their contacts.

The friction of the plant (friction.py) depends on what was before: from where an axis turned, its
contact is deflected by the way until it slides. So a plan has a table of `Contact` rows for each
axis, from the start, each turning point, and each rest; with it friction is known at any time.

A stop needs Coulomb friction alone, so that an axis which is slightly fast is not driven on where
its friction rises to static friction. At rest a contact is released: what holds it deflected is the
force with which an axis is about to go. It springs back by what it was deflected. A rest too short
for that is held.

`resistance` is a `Resistance`; timing, coefficients, offsets and ends are those of the plan, see
trajectory/evaluate.py.
"""

from math import sqrt

from segfmu.kernels.crane.bounds import carriage_mass, hanging_mass
from segfmu.kernels.crane.friction import (
    dry_friction,
    dry_level,
    first_deflection,
    rubs,
    smooth_friction,
)
from segfmu.kernels.crane.records import (
    Axes,
    Contact,
    ContactWork,
    History,
    MostSeries,
    Resistance,
    State,
)
from segfmu.kernels.crane.suspension import crane_inverse, flat_orders
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.trajectory.breaks import next_break, same_break
from segfmu.kernels.trajectory.evaluate import evaluate_orders


def resists(resistance: 'float[:]', axis: int) -> bool:
    """Whether an axis has friction."""
    smooth = resistance[Resistance.VISCOUS + axis] + resistance[Resistance.DRAG + axis]
    return smooth > 0.0 or rubs(resistance, axis)


def release_time(resistance: 'float[:]', axis: int) -> float:
    """Time [s] in which a contact is released: slow for the mass that swings on it."""
    mass = carriage_mass(resistance, axis)
    if axis == Axes.ROPE:
        mass = hanging_mass(resistance)
    static = max(resistance[Resistance.STATIC + axis], resistance[Resistance.COULOMB + axis])
    return 20.0 * sqrt(resistance[Resistance.PRESLIDING] * mass / (1.5 * static))


def axis_motion(
    time: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', work: 'float[:,:]',
) -> 'tuple[float, float]':
    """Planned position [m] and velocity [m/s] of the axis."""
    crane = work[ContactWork.RESISTANCE, :]
    load = work[ContactWork.LOAD:ContactWork.LOAD + flat_orders(crane), :]
    series = work[ContactWork.SERIES:ContactWork.SERIES + MostSeries.SIZE, :]
    axis = int(work[ContactWork.HISTORY, History.AXIS])
    evaluate_orders(time, timing, coefficients, offsets, ends, load)
    crane_inverse(
        load, crane, series, work[ContactWork.FORCE, :], work[ContactWork.STATE, :],
        work[ContactWork.ACCELERATION, :],
    )
    position = work[ContactWork.STATE, State.POSITION + axis]
    velocity = work[ContactWork.STATE, State.VELOCITY + axis]
    return position, velocity


def find_contact(time: float, contacts: 'float[:,:]') -> int:
    """The last row that begins by a time [s], the first one before all."""
    lower = 0
    upper = contacts.shape[0]
    while upper - lower > 1:
        middle = (lower + upper) // 2
        if time >= contacts[middle, Contact.TIME]:
            lower = middle
        else:
            upper = middle
    return lower


def planned_deflection(
    resistance: 'float[:]', time: float, position: float, contacts: 'float[:,:]', row: int
) -> float:
    """Deflection [m] of a contact at a planned position of its axis."""
    deflection = contacts[row, Contact.DEFLECTION]
    released = contacts[row, Contact.RELEASED]
    if released > 0.0:
        share = min((time - contacts[row, Contact.TIME]) / released, 1.0)
        return deflection * (1.0 - share * share * (3.0 - 2.0 * share))
    deflection = deflection + position - contacts[row, Contact.POSITION]
    most = resistance[Resistance.PRESLIDING]
    return min(max(deflection, -most), most)


def release_rate(time: float, contacts: 'float[:,:]', row: int) -> float:
    """Velocity [m/s] with which an axis at rest springs back as its contact is released."""
    released = contacts[row, Contact.RELEASED]
    share = min((time - contacts[row, Contact.TIME]) / released, 1.0)
    return -6.0 * contacts[row, Contact.DEFLECTION] * share * (1.0 - share) / released


def stops(time: float, contacts: 'float[:,:]', row: int) -> bool:
    """Whether an axis comes to rest, or rests, at a time [s] in a row."""
    if contacts[row, Contact.RELEASED] > 0.0:
        return True
    if row + 1 >= contacts.shape[0]:
        return False
    return contacts[row + 1, Contact.RELEASED] > 0.0 and time >= contacts[row + 1, Contact.BEGUN]


def planned_friction(
    resistance: 'float[:]',
    axis: int,
    time: float,
    position: float,
    velocity: float,
    contacts: 'float[:,:]',
) -> float:
    """Friction [N] of an axis at a time [s] of a plan, with its position and velocity.

    Before the plan begins there is none.
    """
    if time < 0.0 or not resists(resistance, axis):
        return 0.0
    row = find_contact(time, contacts)
    deflection = planned_deflection(resistance, time, position, contacts, row)
    rate = velocity
    if contacts[row, Contact.RELEASED] > 0.0:
        rate = release_rate(time, contacts, row)
    level = dry_level(resistance, axis, rate)
    if stops(time, contacts, row):
        level = resistance[Resistance.COULOMB + axis]
    friction = smooth_friction(resistance, axis, rate)
    return friction + dry_friction(resistance, axis, level, rate, deflection)


def contact_history(
    axis: int,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    resistance: 'float[:]',
    work: 'float[:,:]',
    contacts: 'float[:,:]',
) -> int:
    """Write the history of the contact of an axis; work: `ContactWork`.

    contacts: a `Contact` per row; rows that are not needed begin at NEVER s. Returns the number of
    rows, at least 1, or 0 if there are too few.
    """
    for i in range(Resistance.SIZE):
        work[ContactWork.RESISTANCE, i] = resistance[i]
    history = work[ContactWork.HISTORY, :]
    history[History.AXIS] = axis
    history[History.COUNT] = 1.0
    history[History.DIRECTION] = 0.0
    for i in range(contacts.shape[0]):
        for place in range(Contact.SIZE):
            contacts[i, place] = 0.0
        contacts[i, Contact.TIME] = NEVER
    position, velocity = axis_motion(0.0, timing, coefficients, offsets, ends, work)
    contacts[0, Contact.TIME] = 0.0
    contacts[0, Contact.POSITION] = position
    if not rubs(resistance, axis):
        return 1
    contacts[0, Contact.DEFLECTION] = first_deflection(resistance, axis, velocity)
    follow_contact(timing, coefficients, offsets, ends, work, contacts)
    count = int(history[History.COUNT])
    for row in range(count):
        settle_contact(row, timing, coefficients, offsets, ends, work, contacts)
    return count


def follow_contact(
    timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]', ends: 'float[:]',
    work: 'float[:,:]', contacts: 'float[:,:]',
) -> None:
    """Append all rests and turning points to the first row."""
    history = work[ContactWork.HISTORY, :]
    rested = False
    time = 0.0
    following = next_break(time, timing, offsets, ends)
    while following < NEVER and history[History.COUNT] > 0.0:
        rests = at_rest(time, following, timing, coefficients, offsets, ends, work)
        if rests != rested:
            add_contact(time, rests, timing, coefficients, offsets, ends, work, contacts)
            history[History.DIRECTION] = 0.0
            rested = rests
        if not rests:
            add_turns(time, following, timing, coefficients, offsets, ends, work, contacts)
        time = following
        following = next_break(time, timing, offsets, ends)
    if not rested:
        add_contact(time, True, timing, coefficients, offsets, ends, work, contacts)


def stillness(work: 'float[:,:]') -> float:
    """Velocity [m/s] below which nothing moves, in terms of friction."""
    return 1e-6 * work[ContactWork.RESISTANCE, Resistance.FRICTION_WIDTH]


def at_rest(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]',
    offsets: 'int[:]', ends: 'float[:]', work: 'float[:,:]',
) -> bool:
    """Whether the axis rests between two times [s] that no piece begins between."""
    for k in range(1, 12):
        time = begin + k * (end - begin) / 12.0
        position, velocity = axis_motion(time, timing, coefficients, offsets, ends, work)
        if abs(velocity) > stillness(work):
            return False
    return True


def add_contact(
    time: float,
    rests: bool,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    work: 'float[:,:]',
    contacts: 'float[:,:]',
) -> None:
    """Append a row where the axis turns, comes to rest or leaves it, at a time [s]."""
    history = work[ContactWork.HISTORY, :]
    resistance = work[ContactWork.RESISTANCE, :]
    count = int(history[History.COUNT])
    if count == 0 or count >= contacts.shape[0]:
        history[History.COUNT] = 0.0
        return
    before = count - 1
    if contacts[before, Contact.RELEASED] > time - contacts[before, Contact.TIME]:
        # a rest too short for its release
        contacts[before, Contact.RELEASED] = 0.0
    position, velocity = axis_motion(time, timing, coefficients, offsets, ends, work)
    contacts[count, Contact.DEFLECTION] = planned_deflection(
        resistance, time, position, contacts, before
    )
    contacts[count, Contact.TIME] = time
    contacts[count, Contact.POSITION] = position
    if rests:
        contacts[count, Contact.RELEASED] = release_time(
            resistance, int(history[History.AXIS])
        )
    history[History.COUNT] = count + 1.0


def add_turns(
    begin: float,
    end: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    work: 'float[:,:]',
    contacts: 'float[:,:]',
) -> None:
    """Append the turning points between two times [s] that no piece begins between."""
    history = work[ContactWork.HISTORY, :]
    before = begin
    for k in range(1, 13):
        time = begin + k * (end - begin) / 12.0
        position, velocity = axis_motion(time, timing, coefficients, offsets, ends, work)
        if abs(velocity) > stillness(work):
            if history[History.DIRECTION] * velocity < 0.0:
                turn = turning_point(before, time, timing, coefficients, offsets, ends, work)
                add_contact(turn, False, timing, coefficients, offsets, ends, work, contacts)
            history[History.DIRECTION] = velocity / abs(velocity)
            before = time


def turning_point(
    begin: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]',
    offsets: 'int[:]', ends: 'float[:]', work: 'float[:,:]',
) -> float:
    """Time [s] between two others at which the axis leaves its direction, by bisection."""
    lower = begin
    upper = end
    for _ in range(50):
        middle = 0.5 * (lower + upper)
        position, velocity = axis_motion(middle, timing, coefficients, offsets, ends, work)
        if velocity * work[ContactWork.HISTORY, History.DIRECTION] > 0.0:
            lower = middle
        else:
            upper = middle
    return 0.5 * (lower + upper)


def settle_contact(
    row: int, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    ends: 'float[:]', work: 'float[:,:]', contacts: 'float[:,:]',
) -> None:
    """Write when the contact of a row begins to slide, and how long its friction changes much."""
    resistance = work[ContactWork.RESISTANCE, :]
    axis = int(work[ContactWork.HISTORY, History.AXIS])
    time = contacts[row, Contact.TIME]
    end = time
    if row + 1 < int(work[ContactWork.HISTORY, History.COUNT]):
        end = contacts[row + 1, Contact.TIME]
    slides = sliding_time(row, end, timing, coefficients, offsets, ends, work, contacts)
    begun = time
    settled = slides
    if resistance[Resistance.STATIC + axis] > resistance[Resistance.COULOMB + axis]:
        if contacts[row, Contact.RELEASED] == 0.0:
            settled = max(
                settled, fading_time(time, end, timing, coefficients, offsets, ends, work)
            )
        if row > 0:
            begun = fading_time(
                time, contacts[row - 1, Contact.TIME], timing, coefficients, offsets, ends, work
            )
    contacts[row, Contact.BEGUN] = begun
    contacts[row, Contact.SLIDES] = slides
    contacts[row, Contact.SETTLED] = settled


def sliding_time(
    row: int,
    end: float,
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    ends: 'float[:]',
    work: 'float[:,:]',
    contacts: 'float[:,:]',
) -> float:
    """Time [s] at which the contact of a row that ends at `end` slides, or is released."""
    resistance = work[ContactWork.RESISTANCE, :]
    lower = contacts[row, Contact.TIME]
    if contacts[row, Contact.RELEASED] > 0.0:
        return lower + contacts[row, Contact.RELEASED]
    most = resistance[Resistance.PRESLIDING]
    upper = end
    for _ in range(50):
        middle = 0.5 * (lower + upper)
        position, velocity = axis_motion(middle, timing, coefficients, offsets, ends, work)
        deflection = planned_deflection(resistance, middle, position, contacts, row)
        if deflection * velocity >= 0.0 and abs(deflection) >= most:
            upper = middle
        else:
            lower = middle
    return upper


def fading_time(
    time: float, end: float, timing: 'float[:,:]', coefficients: 'float[:,:]',
    offsets: 'int[:]', ends: 'float[:]', work: 'float[:,:]',
) -> float:
    """From a time [s] without velocity towards another one: where static friction has faded first.

    At most 1.5 times as far as needed, and to the middle. It is looked for from near to far: at the
    middle the axis may be slow again, as it passes through rest.
    """
    faded = 3.0 * work[ContactWork.RESISTANCE, Resistance.FRICTION_WIDTH]
    share = 1e-6
    fast = False
    for _ in range(33):
        if not fast:
            position, velocity = axis_motion(
                time + share * (end - time), timing, coefficients, offsets, ends, work
            )
            fast = abs(velocity) > faded
        if not fast:
            share = min(1.5 * share, 0.5)
    return time + share * (end - time)


def contact_node(time: float, begin: float, end: float) -> float:
    """The first of 17 equidistant times from `begin` to `end` after `time` [s], or NEVER."""
    if end > begin:
        for k in range(17):
            node = begin + k * (end - begin) / 16.0
            if node > time:
                return node
    return NEVER


def next_contact_event(time: float, start: float, contacts: 'float[:,:]') -> float:
    """First time after `time` [s] at which a step should end for the friction of an axis.

    start: of the plan. Where friction changes much, steps are short; NEVER: no more such times.
    """
    after = time + same_break(time) - start
    row = find_contact(after, contacts)
    # one of them where the contact begins to slide: there the slope of the friction jumps
    event = min(
        contact_node(after, contacts[row, Contact.TIME], contacts[row, Contact.SLIDES]),
        contact_node(after, contacts[row, Contact.SLIDES], contacts[row, Contact.SETTLED]),
    )
    if after < contacts[row, Contact.TIME]:
        event = contacts[row, Contact.TIME]
    if row + 1 < contacts.shape[0] and contacts[row + 1, Contact.TIME] < NEVER:
        event = min(event, contacts[row + 1, Contact.TIME])
        event = min(event, contact_node(
            after, contacts[row + 1, Contact.BEGUN], contacts[row + 1, Contact.TIME]
        ))
    if event < NEVER:
        # long after the start, the clock may be too coarse
        event = start + event
        if event <= time:
            event = NEVER
    return event
