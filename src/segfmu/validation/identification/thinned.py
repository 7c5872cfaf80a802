"""A log with fewer rows, by which a search finds its way before it looks at all of them."""

from __future__ import annotations

import numpy as np
from scipy.linalg import solveh_banded

from segfmu.validation.identification.log import Log

# rows of a period of the pendulum that show how it swings
ROWS = 100


def thinned(log: Log, period: float) -> Log:
    """At most about `ROWS` rows of a period [s].

    Setpoints from row to row are the lines that are nearest to all setpoints, by least squares: so
    they bring into a crane what these do. Where half of the rows or more would be left, it is the
    log itself.
    """
    times = log.times
    places = np.unique(np.floor((times - times[0]) * (ROWS / period)), return_index=True)[1]
    places = np.append(places[places < times.size - 1], times.size - 1)
    if 2 * places.size > times.size:
        return log
    # shares of the rows that are left before and behind each row
    after = np.clip(np.searchsorted(places, np.arange(times.size), "right"), 1, places.size - 1)
    begin, end = times[places[after - 1]], times[places[after]]
    late = (times - begin) / (end - begin)
    early, lasts = 1.0 - late, np.gradient(times)
    lasts[[0, -1]] *= 0.5
    matrix, right = np.zeros((2, places.size)), np.zeros((places.size, log.setpoints.shape[1]))
    np.add.at(matrix[1], after - 1, lasts * early * late)
    for place, share in ((after - 1, early), (after, late)):
        np.add.at(matrix[0], place, lasts * share**2)
        np.add.at(right, place, (lasts * share)[:, None] * log.setpoints)
    return Log(
        log.name, times[places], solveh_banded(matrix, right, lower=True), log.measured[places]
    )
