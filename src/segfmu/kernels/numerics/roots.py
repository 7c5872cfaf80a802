"""The steps of a bracketed root search, for searches that evaluate in their own way.

Chandrupatla's method (Advances in Engineering Software 28, 145-149, 1997): inverse quadratic
interpolation if the last three points make it safe, else bisection. The first step is that of the
secant. The caller keeps the newest point, the other end of the bracket, and the point before them.
"""


def root_share(
    newest: float, other: float, before: float, e_newest: float, e_other: float, e_before: float
) -> float:
    """Next point to evaluate, as a share in (0, 1) of the way from the newest to the other point.

    e_newest, e_other and e_before are the errors at the points, 0 where they are not known.
    """
    if e_newest * e_other * e_before == 0.0:
        return 0.5
    if before == other and e_newest * e_other < 0.0:
        return min(max(e_newest / (e_newest - e_other), 0.1), 0.9)
    if e_before == e_newest or e_before == e_other or before == other:
        return 0.5
    place = (newest - other) / (before - other)
    height = (e_newest - e_other) / (e_before - e_other)
    if height * height >= place or (1.0 - height) * (1.0 - height) >= 1.0 - place:
        return 0.5
    share = e_newest / (e_other - e_newest) * e_before / (e_other - e_before)
    rest = (before - newest) / (other - newest)
    share = share + rest * e_newest / (e_before - e_newest) * e_other / (e_before - e_other)
    # the point must differ from both ends
    least = 2e-16 * max(abs(newest), abs(other)) / abs(other - newest)
    return max(min(share, 1.0 - least), least)


def next_point(
    newest: float, other: float, before: float, e_newest: float, e_other: float, e_before: float
) -> float:
    """Next point to evaluate; arguments as of `root_share`."""
    share = root_share(newest, other, before, e_newest, e_other, e_before)
    return newest + share * (other - newest)


def next_bracket(
    crossed: bool, point: float, error: float, newest: float, other: float, e_newest: float,
    e_other: float,
) -> 'tuple[float, float, float, float, float, float]':
    """The newest point, the other and the one before, and their errors, once a point was evaluated.

    `newest` is the point before it; crossed: the root lies between the two.
    """
    if crossed:
        return point, newest, other, error, e_newest, e_other
    return point, other, newest, error, e_other, e_newest
