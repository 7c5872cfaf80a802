"""All members of the canonical family (levels.py) with a value, one after the other.

BY_TIME of a family (Family) selects duration or distance, TARGET is its value.
"""

from segfmu.kernels.numerics.numbers import COARSE
from segfmu.kernels.planner.records import Family
from segfmu.kernels.planner.search import bracketed_root, canonical_value, window_edge


def member_search(family: 'float[:]', axis: 'float[:]') -> float:
    """Parameter of the canonical member number MEMBER of the target value, or -1.

    Neither duration nor distance is monotone along the family. The duration falls and rises again
    as a first level with a long way back gives way to a shorter one; the distance does so while the
    velocity in between is negative. So the search steps through the members: COARSE of them up to
    SCALE, growing as squares, and twice as many up to nine times that. With the highest first level
    it goes on where it found the member before.
    """
    target = family[Family.TARGET]
    passed, begin, lower, f_lower = 0, 0, -1.0, 0.0
    whole = family[Family.HIGHEST] == family[Family.TOP]
    if whole and int(family[Family.MEMBER]) > 0:
        passed = int(family[Family.MEMBER])
        begin = int(family[Family.PASSED])
        lower, f_lower = family[Family.PASSED_INSIDE], family[Family.PASSED_VALUE]
        if begin > COARSE + 1 and lower >= 0.0 and f_lower > target:
            return -1.0
    p = 0.0
    for i in range(begin, 3 * COARSE):
        p = family[Family.SCALE] * i * i / (COARSE * COARSE)
        value, duration = canonical_value(p, family, axis)
        upper = p
        f_upper = value
        inside = duration >= 0.0
        if inside and lower < 0.0 and i > 0:
            outside = family[Family.SCALE] * (i - 1) * (i - 1) / (COARSE * COARSE)
            lower = window_edge(p, outside, family, axis)
            f_lower, duration = canonical_value(lower, family, axis)
        if not inside and lower >= 0.0:
            upper = window_edge(lower, p, family, axis)
            f_upper, duration = canonical_value(upper, family, axis)
        found = lower >= 0.0 and (f_lower - target) * (f_upper - target) <= 0.0
        found = found and f_upper != f_lower
        if found and passed == int(family[Family.MEMBER]):
            if whole:
                family[Family.PASSED] = i + 1
                family[Family.PASSED_INSIDE] = p if inside else -1.0
                family[Family.PASSED_VALUE] = f_upper
            if f_upper > f_lower:
                return bracketed_root(lower, upper, f_lower, f_upper, family, axis)
            return bracketed_root(upper, lower, f_upper, f_lower, family, axis)
        if found:
            passed = passed + 1
        lower = -1.0
        if inside:
            lower = p
            f_lower = value
            if i > COARSE and value > target:
                return -1.0
    return -1.0
