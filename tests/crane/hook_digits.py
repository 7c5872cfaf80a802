"""The flat inverse of a crane with a hook, evaluated in many digits and by another way.

The path of the load is one of sines and polynomials, differentiated by SymPy. Everything above the
load is a function of time in mpmath, whose derivatives are numerical differentiation in so many
digits that 40 of them stay.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mpmath as mp
import sympy as sp

T = sp.Symbol("t", real=True)
# swings, moves sideways and hoists, all three at once
PATH = (
    sp.Rational(2, 5) * sp.sin(sp.Rational(11, 10) * T + sp.Rational(1, 5)) + T**3 / 50,
    sp.Rational(3, 10) * sp.sin(sp.Rational(17, 10) * T + 1) - T**2 / 20,
    -sp.Rational(17, 10) + sp.sin(sp.Rational(23, 10) * T + 2) / 10 - T / 20,
)
DIGITS, WORKING = 40, 110

Function = Callable[[mp.mpf], mp.mpf]


def path_derivatives(time: sp.Rational, orders: int, scale: int = 1) -> list[list[float]]:
    """Derivatives 0 .. orders - 1 of the load's position as floats; `scale` stretches the path."""
    return [
        [float(sp.N(scale * x.diff(T, d).subs(T, time), 30)) for x in PATH] for d in range(orders)
    ]


class HookDigits:
    """Values of the inverse by name at a time."""

    def __init__(self, masses: Sequence[str], scale: int = 1) -> None:
        with mp.workdps(WORKING):
            values = [mp.mpf(m) for m in masses]
        self.bridge, self.trolley, self.payload, self.gravity, self.hook, self.sling = values
        self._path = [sp.lambdify(T, scale * x, "mpmath") for x in PATH]
        self._pull = [sp.lambdify(T, scale * x.diff(T, 2), "mpmath") for x in PATH]

    def pull(self, t: mp.mpf) -> mp.matrix:
        """p'' + g e_z."""
        w = mp.matrix([f(t) for f in self._pull])
        w[2] += self.gravity
        return w

    def hook_at(self, t: mp.mpf) -> mp.matrix:
        """Position of the hook."""
        w = self.pull(t)
        return mp.matrix([f(t) for f in self._path]) + w * (self.sling / mp.norm(w))

    def rope(self, t: mp.mpf) -> mp.matrix:
        """Force of the rope on hook and load together, upwards."""
        force = self.pull(t) * self.payload
        for i in range(3):
            force[i] += self.hook * mp.diff(lambda s, i=i: self.hook_at(s)[i], t, 2)
        force[2] += self.hook * self.gravity
        return force

    def coordinates(self, t: mp.mpf) -> list[mp.mpf]:
        """x_t, y_t, l, angles of the rope, angles of the sling."""
        h, f, w = self.hook_at(t), self.rope(t), self.pull(t)
        top = h - f * (h[2] / f[2])
        return [top[0], top[1], mp.norm(top - h), *_angles(f), *_angles(w)]

    def inverse(self, time: sp.Rational) -> list[mp.mpf]:
        """Forces, state and accelerations, as the record HookInverse has them."""
        with mp.workdps(WORKING):
            t = mp.mpf(time.p) / mp.mpf(time.q)
            place = [
                mp.taylor(lambda s, i=i: self.coordinates(s)[i], t, 2) for i in range(7)
            ]
            values, rates, accelerations = ([a[k] * (1 + (k > 1)) for a in place] for k in range(3))
            f = self.rope(t)
            forces = [
                (self.bridge + self.trolley) * accelerations[0] + f[0],
                self.trolley * accelerations[1] + f[1],
                -mp.norm(f),
            ]
            return [*forces, *values, *rates, *accelerations]


def _angles(up: mp.matrix) -> list[mp.mpf]:
    """phi_x and phi_y of a rope that leads up in a direction."""
    return [mp.atan2(-up[0], mp.sqrt(up[1] ** 2 + up[2] ** 2)), mp.atan2(up[1], up[2])]
