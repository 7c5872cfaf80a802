"""Evaluation of the gain-scheduled sway feedback."""


def feedback_correction(
    state: 'float[:]',
    reference: 'float[:]',
    lengths: 'float[:]',
    gains: 'float[:,:,:]',
    correction: 'float[:]',
) -> None:
    """-K(l) (x - x*), K interpolated linearly over rope length, constant outside the table.

    state and reference hold 10 numbers, lengths (rows,), gains (rows, 3, 10), correction 3.
    """
    rows = lengths.shape[0]
    row = 0
    while row + 2 < rows and state[2] > lengths[row + 1]:
        row = row + 1
    share = 0.0
    following = row
    if rows > 1:
        following = row + 1
        share = (state[2] - lengths[row]) / (lengths[following] - lengths[row])
        share = min(max(share, 0.0), 1.0)
    for i in range(3):
        total = 0.0
        for j in range(10):
            k = (1.0 - share) * gains[row, i, j] + share * gains[following, i, j]
            total = total + k * (state[j] - reference[j])
        correction[i] = -total
