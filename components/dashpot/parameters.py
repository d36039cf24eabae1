"""The parameters of a mass, a spring and a dashpot. The damping can be set as c or as ζ."""

from __future__ import annotations

from typing import Self

import param

from components.quantities.parameters import Quantity, Values, mass, not_negative, one_of, positive, stiffness
from components.scene import Scene
from physics.damped import DampedOscillator
from physics.precision.exact import exact, precise, rounded

DAMPED_ONLY = "a dashpot only takes energy: c is a finite number, 0 or more"


def parts(m: float, k: float, c: float, *, k_may_be_0: bool = True) -> tuple[Quantity, Quantity, Quantity, Quantity]:
    """m, k, c and zeta with these defaults; with `k_may_be_0` k may be 0."""
    says = "is the stiffness of the spring."
    spring = (
        stiffness(k, symbol="k", says=f"{says} At 0 the mass glides. Any value from 0 up.", softbounds=(0.0, 200.0))
        if k_may_be_0
        else positive(
            k, symbol="k", unit="N/m", label="stiffness", tint="k", scale="log", softbounds=(1.0, 200.0),
            says=f"{says} Any value above 0.",
        )
    )  # fmt: skip
    return (
        mass(m, symbol="m", tint="m1", says="is the mass. A heavier one is damped less. Any value above 0."),
        spring,
        not_negative(
            c, symbol="c", unit="N s/m", label="damping", tint="T", scale="near0", softbounds=(0.0, 40.0),
            allowed=DAMPED_ONLY, says="is the force of the dashpot over the velocity. Any value from 0 up.",
        ),
        not_negative(
            DampedOscillator(m=m, c=c, k=k).zeta, symbol="ζ", unit="", label="damping ratio", tint="T", scale="near0",
            softbounds=(0.0, 3.0), allowed=DAMPED_ONLY.replace("c is", "ζ is"),
            says="sets c: it is c over 2√(k m). From 1 on nothing swings by itself. Any value from 0 up.",
        ),
    )  # fmt: skip


def keeping() -> param.Selector[str]:
    """Return the choice which of c and ζ stays when the mass or the spring changes."""
    return one_of("c", {"c": "keep c", "zeta": "keep ζ"}, "What stays when m or k changes")


class DashpotScene(Scene):
    """A scene with these parameters."""

    m: Quantity
    k: Quantity
    c: Quantity
    zeta: Quantity
    keep: param.Selector[str]
    shares = {"mass": "m", "stiffness": "k", "damping": "c"}

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """Return the damping that follows from a change: zeta from c, or c from zeta.

        Raises ValueError where there is none. Without a spring there is no zeta, so c stays.
        """
        by_zeta = "zeta" in changed and ("c" not in changed or self.keep == "zeta")
        keeps_c = self.keep == "c" or (before is None and not self.k)
        if not by_zeta and ("c" in changed or keeps_c):
            if not self.k or not changed & {"m", "k", "c", "zeta"}:
                return {}
            with precise():
                ratio = exact(self.c) / (2 * (exact(self.k) * exact(self.m)).sqrt())
            return {"zeta": rounded("the damping ratio ζ = c/(2√(k m))", ratio)}
        if by_zeta and before and not self.k:
            raise ValueError("Without a spring (k = 0) there is no ζ: set c instead.")
        with precise():
            damping = 2 * exact(self.zeta) * (exact(self.k) * exact(self.m)).sqrt()
        return {"c": rounded("the damping c = 2ζ√(k m)", damping)} if changed & {"m", "k", "zeta"} else {}

    def derived(self) -> frozenset[str]:
        """Return the one of c and zeta that follows from the other; without a spring there is no zeta."""
        return frozenset({"zeta"} if self.keep == "c" or not self.k else {"c"})
