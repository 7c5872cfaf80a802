"""When times of steps are the same, for both backends: `native.tables` writes them for C."""

# of times that differ by less, relative to their size: importers add up steps
SAME = 1e-9
# of a step: late in a simulation such times may be a whole step apart, which is one step twice
REPEATED = 0.5
# of a time to which a step was added, relative to it
ROUNDING = 1e-14
# s; times beyond it have no microseconds
LATEST = 1e9
