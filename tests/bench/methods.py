"""The methods of the benchmark with their properties: computed for fixed steps, from the literature for solvers."""

from __future__ import annotations

from math import inf

from physics.integrators.fixed_steps import STEPPING, Stepping
from physics.integrators.solvers import METHODS
from physics.integrators.stability import amplification, decay_factor, form_change, stability_limit

AT, FAR = 0.5, 1e12
"""|λ| h at which damping and symplecticity are told, and that at which L-stability is."""
SAME, NOTHING = 1e-12, 1e-11
HLW = "Hairer, Lubich, Wanner, Geometric Numerical Integration"
HNW = "Hairer, Nørsett, Wanner, Solving ODEs I"
HW = "Hairer, Wanner, Solving ODEs II"
SOURCES = {
    "euler": f"{HNW}, I.7",
    "semi": f"{HLW}, I.1",
    "verlet": f"{HLW}, I.1",
    "yoshida4": "Yoshida, Phys. Lett. A 150 (1990) 262",
    "yoshida6": "Yoshida, Phys. Lett. A 150 (1990) 262",
    "rk4": f"{HNW}, II.1",
    "nystrom4": f"{HNW}, II.14",
    "nystrom6": f"{HNW}, II.14",
    "midpoint": f"{HLW}, II.1",
    "newmark": "Newmark, J. Eng. Mech. Div. 85 (1959) 67",
    "gauss4": f"{HW}, IV.5",
    "ieuler": f"{HW}, IV.3",
    "sdirk2": "Alexander, SIAM J. Numer. Anal. 14 (1977) 1006",
    "radau5": f"{HW}, IV.5",
    "alpha": "Chung, Hulbert, J. Appl. Mech. 60 (1993) 371",
    "gautschi": f"Gautschi, Numer. Math. 3 (1961) 381; {HLW}, XIII.1",
    "mollified": "García-Archilla, Sanz-Serna, Skeel, SIAM J. Sci. Comput. 20 (1999) 930",
}
SOLVERS = {
    "rk23": ("3(2)", "explicit", "Bogacki, Shampine, Appl. Math. Lett. 2 (1989) 321"),
    "rk45": ("5(4)", "explicit", "Dormand, Prince, J. Comput. Appl. Math. 6 (1980) 19"),
    "dop853": ("8(5, 3)", "explicit", f"{HNW}, II.5 and II.10"),
    "radau": ("5", "A- and L-stable", f"{HW}, IV.8"),
    "bdf": ("1 to 5", "A(α)-stable, A-stable to order 2", "Shampine, Reichelt, SIAM J. Sci. Comput. 18 (1997) 1"),
    "lsoda": ("1 to 12, or 1 to 5", "Adams, or BDF as above", "Petzold, SIAM J. Sci. Stat. Comput. 4 (1983) 136"),
    "fortran": ("8(5, 3)", "explicit", f"{HNW}, II.5 and II.10"),
    "adams": (
        "1 to 12", "as explicit methods: it iterates to a fixed point",
        "Brown, Byrne, Hindmarsh, SIAM J. Sci. Stat. Comput. 10 (1989) 1038",
    ),
}  # fmt: skip
"""Order, stability and source of the solvers that choose their steps."""
TOLD = """
## The methods

Properties of methods with fixed steps are computed from their steps. An oscillation is stable up to the given |λ| h. A
symplectic method keeps the areas of x and p, so it does not damp; the others take the given share of an amplitude away
in a step of |λ| h = 0.5, or add it. R(−∞) is what a step of |λ| h = 1e12 leaves of a decay: 0 if the method is
L-stable. An A-stable method is stable at every step of both. The implicit midpoint, Newmark and Gauss 4 are A-stable
and not L-stable: they keep a fast decay alive, as the findings on the dashpot show. Generalized-α leaves the share ρ∞
of it in a step, and HHT-α is of its family. The exponential integrators solve the coupling spring exactly, so an
oscillation on that spring alone has no limit; the rest of the forces bounds their step as Verlet's. The orders are
those of measured slopes (tests/physics/test_integrators.py).

Orders and sources of solvers that choose their steps are those that SciPy's source names. Its BDF is modified (NDF):
A-stable up to order 2, and from order 3 on A(α)-stable with α of 80, 66 and 51 degrees (Shampine, Reichelt). Beyond
that angle, as with an oscillation that nothing damps, it grows at some steps. BDF without that, as in LSODA, has 86, 73
and 51 degrees.
"""


def methods_table() -> list[str]:
    """The section of the document on the methods."""
    rows = [["method", "order", "evaluations a step", "an oscillation", "damping at 0.5", "R(−∞)", "source"]]
    rows += [["---"] * 7]
    rows += [_fixed(slug, STEPPING[slug]) for slug in METHODS if slug in STEPPING]
    rows += [
        [METHODS[slug].name, order, "", stable, "", "", source] for slug, (order, stable, source) in SOLVERS.items()
    ]
    return [TOLD, *("| " + " | ".join(row) + " |" for row in rows), ""]


def _fixed(slug: str, step: Stepping) -> list[str]:
    limit = stability_limit(slug)
    stable = "never stable" if not limit else "always stable" if limit == inf else f"stable to {limit:.4g}"
    stable = "exact on spring 2" if step.splits else stable
    name, counts = METHODS[slug].name, (str(step.order), str(step.evaluations))
    return [name, *counts, stable, _damping(slug), _far(slug, step), SOURCES[slug]]


def _damping(slug: str) -> str:
    if form_change(slug, AT) < SAME:
        return "none, symplectic"
    lost = 1 - float(amplification(slug, AT)[0])
    if abs(lost) < SAME:
        return "none"
    return f"{lost:.1e}" if lost > 0 else f"adds {-lost:.1e}"


def _far(slug: str, step: Stepping) -> str:
    if not step.friction:
        return "without friction only"
    left = abs(decay_factor(slug, FAR))
    return "infinite" if left > 1 + SAME else "0" if left < NOTHING else f"{left:.2g}"
