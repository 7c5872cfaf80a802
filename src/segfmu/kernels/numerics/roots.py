"""One step of a bracketed root search, for searches that evaluate in their own way.

Chandrupatla's method (Advances in Engineering Software 28, 145-149, 1997): inverse quadratic
interpolation where the last three points make it safe, bisection elsewhere. The caller keeps the
newest point a, the point b on the other side of the root, and c, the point before them. An error
of 0 stands for one that is not known.
"""


def root_share(
    a: float, b: float, c: float, f_a: float, f_b: float, f_c: float
) -> float:
    """Share of the way from a to b at which to evaluate next, inside (0, 1)."""
    if f_a * f_b * f_c == 0.0 or f_c == f_a or f_c == f_b or c == b:
        return 0.5
    place = (a - b) / (c - b)
    height = (f_a - f_b) / (f_c - f_b)
    if height * height >= place or (1.0 - height) * (1.0 - height) >= 1.0 - place:
        return 0.5
    share = f_a / (f_b - f_a) * f_c / (f_b - f_c)
    share = share + (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b)
    # the point must differ from both ends
    least = 2e-16 * max(abs(a), abs(b)) / abs(b - a)
    return max(min(share, 1.0 - least), least)
