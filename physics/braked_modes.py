"""The free motions exp(s t) of the chain with dashpots, and the complex shape of each.

    wall --k1, c1-- [m1] --k2, c2-- [m2]        P(s) = 0, see physics.transient

    X2/X1 = (k2 + c2 s)/(m2 s^2 + c2 s + k2) = (m1 s^2 + (c1 + c2) s + k1 + k2)/(k2 + c2 s)

The shapes are real, and those without dashpots, exactly where c1 k2 = c2 k1, whatever the masses (T. K. Caughey and M.
E. J. O'Kelly, J. Appl. Mech. 32 (1965) 583). Exponents and shapes come from 120 digits, or
more, and are rounded once.
"""

from fractions import Fraction
from typing import Any, NamedTuple

from physics.coupled import TwoMassChain
from physics.laplace import Driven, resolved
from physics.roots import taxicab

DIGITS = 120


class BrakedMode(NamedTuple):
    """A free motion: x_i = Re(shape[i] exp(s t)) for each of the `exponents` s in 1/s, one of a conjugate pair with
    Im(s) > 0, or two that are real. The larger part of the shape has modulus 1; X1 is real and not below 0."""

    exponents: tuple[complex, ...]
    shape: tuple[complex, complex]

    @property
    def swings(self) -> bool:
        return self.exponents[0].imag > 0


def braked_modes(chain: TwoMassChain, c1: float, c2: float) -> tuple[BrakedMode, BrakedMode]:
    """The slow mode and the fast one; of a mode that does not swing the shape is that of the slower exponent."""
    driven = Driven(chain, c2, 0.0, 0.0, (1.0, 0.0), (0.0, 1.0), c1)
    found = resolved(driven, DIGITS)
    pairs = [(p,) for p in found.exponents if p.imag > 0]
    rest = 4 - len(found.exponents)
    real = sorted([p for p in found.exponents if not p.imag] + [found.ctx.mpc(0)] * rest, key=abs)
    groups = [*pairs, *((real[i], real[i + 1]) for i in range(0, len(real), 2))]
    groups.sort(key=lambda group: abs(group[0]) * abs(group[-1]))
    slow, fast = (BrakedMode(tuple(map(complex, group)), _shape(driven, found.ctx, group[0])) for group in groups)
    return slow, fast


def in_line(chain: TwoMassChain, c1: float, c2: float) -> bool:
    """Whether c1 k2 = c2 k1, without error."""
    return Fraction(c1) * Fraction(chain.k2) == Fraction(c2) * Fraction(chain.k1)


def _shape(driven: Driven, ctx: Any, s: Any) -> tuple[complex, complex]:
    """From the equation whose parts are larger."""
    chain = driven.chain
    m1, m2, k1, k2, c1, c2 = map(ctx.mpf, (chain.m1, chain.m2, chain.k1, chain.k2, driven.c1, driven.c))
    link, own = k2 + c2 * s, k1 + c1 * s + m1 * s * s
    first, second = (m2 * s * s + link, link), (link, own + link)
    one, two = max(first, second, key=lambda shape: taxicab(shape[0]) + taxicab(shape[1]))
    size = max(abs(one), abs(two))
    if not size:
        return 0j, 1 + 0j
    turn = abs(one) / one / size if one else 1 / two
    two *= turn
    return complex(abs(one) / size), complex(two if s.imag and not in_line(chain, driven.c1, driven.c) else two.real)
