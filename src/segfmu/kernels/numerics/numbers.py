"""Numbers that kernels share. Their names are replaced by the values before C is made of them."""

# a duration [s], or another value, that nothing reaches: there is none
NEVER = 1e300
# of a place of the load that is given: a start, a target, a waypoint, a measured one [m]
FARTHEST_PLACE = 1e6
# of an interval, the part that golden section keeps
GOLDEN = 0.6180339887498949
# of two values the second one counts as larger by this factor only: rounding decides nothing
TIE = 1.000001
# what rounding leaves, as a share: of a number, of a sum whose terms cancel, and of a distance that
# profiles cover
LAST_DIGIT = 2e-16
ROUNDED = 2e-15
COVERED = 1e-14
# two numbers of a motion differ by rounding alone within this share: states, limits
EQUAL = 1e-12
# the same of sums of a few phases: durations, and what they gain and cover
SAME = 1e-13
# a shorter duration, or a better value, by less than this share is a gain by rounding
GAINED = 1e-10
# beside a solution, and at the end of a motion, a condition is missed by this share by rounding
BESIDE = 1e-11
# a limit is exceeded, or a derivative is another one, by more than this share
EXCEEDED = 1e-10
# as GAINED, of solutions by Newton's method
WORTH = 1e-9
# what is given, a state or a duration, is zero, its limit, or another one, within this share
NEARLY = 1e-9
# steps after which a bracket is a point, and doublings after which nothing is beyond, if a search
# does not end before, as all do
HALVINGS = 100
# steps of golden section that leave a millionth of an interval: the extreme value is known to
# rounding there
SECTIONS = 30
# about the root of what rounding leaves, as a share: the square of such an error is rounding, as
# that of an extreme value or after another step of Newton's method, and where slopes come from such
# a change their errors by rounding and by the bend are alike
HALF_DIGITS = 1e-7
# this near, as a share, to a root or an edge, Newton's method goes straight to it, and what is
# beyond is next to it
CLOSE = 1e-4
# a part of a range, a time or a limit that is too small to matter where its whole is searched
FINE = 1e-3
# a small part of a whole
SMALL = 0.1
# so many times what is usual is beyond what a motion needs
FAR = 1e3
# places of an interval that are looked at for all roots of what bends a few times
SAMPLES = 24
# the same where it hardly bends, or where one of several is enough
COARSE = 12
# steps of a search that has failed if it does not end before
TRIES = 24
# the same where more steps take longer than they gain
FEW = 12
