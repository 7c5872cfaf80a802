"""Numbers that kernels share. Their names are replaced by the values before C is made of them."""

# a duration [s], or another value, that nothing reaches: there is none
NEVER = 1e300
# of an interval, the part that golden section keeps
GOLDEN = 0.6180339887498949
# of two values the second one counts as larger by this factor only: rounding decides nothing
TIE = 1.000001
