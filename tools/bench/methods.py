"""The methods of the benchmark with their properties: computed for fixed steps, from the literature for solvers."""

from __future__ import annotations

from math import inf

from physics.integrators.fixed_steps import STEPPING, Stepping
from physics.integrators.solvers import METHODS
from physics.integrators.stability import amplification, decay_factor, form_change, stability_limit

AT, FAR = 0.5, 1e12
"""|λ| h at which damping and symplecticity are computed, and that for L-stability."""
SAME, NOTHING = 1e-12, 1e-11
HLW = "Hairer, Lubich, Wanner, Geometric Numerical Integration"
HNW = "Hairer, Nørsett, Wanner, Solving ODEs I"
HW = "Hairer, Wanner, Solving ODEs II"
SOURCES = {
    "euler": f"{HNW}, I.7",
    "semi": f"{HLW}, I.1",
    "verlet": f"{HLW}, I.1",
    "yoshida4": "Yoshida 1990",
    "yoshida6": "Yoshida 1990",
    "rk4": f"{HNW}, II.1",
    "nystrom4": f"{HNW}, II.14",
    "nystrom6": f"{HNW}, II.14",
    "midpoint": f"{HLW}, II.1",
    "newmark": "Newmark 1959",
    "gauss4": f"{HW}, IV.5",
    "ieuler": f"{HW}, IV.3",
    "sdirk2": "Alexander 1977",
    "radau5": f"{HW}, IV.5",
    "alpha": "Chung, Hulbert 1993",
    "gautschi": f"Gautschi 1961; {HLW}, XIII.1",
    "mollified": "García-Archilla, Sanz-Serna, Skeel 1999",
}
SOLVERS = {
    "rk23": ("3(2)", "explicit", "Bogacki, Shampine 1989"),
    "rk45": ("5(4)", "explicit", "Dormand, Prince 1980"),
    "dop853": ("8(5, 3)", "explicit", f"{HNW}, II.5 and II.10"),
    "radau": ("5", "A- and L-stable", f"{HW}, IV.8"),
    "bdf": ("1 to 5", "A(α)-stable, A-stable to order 2", "Shampine, Reichelt 1997"),
    "lsoda": ("1 to 12, or 1 to 5", "Adams, or BDF as above", "Petzold 1983"),
    "fortran": ("8(5, 3)", "explicit", f"{HNW}, II.5 and II.10"),
    "adams": ("1 to 12", "as explicit methods: it iterates to a fixed point", "Brown, Byrne, Hindmarsh 1989"),
}
"""Order, stability and source of the solvers that choose their steps."""
PAPERS = {
    "Alexander 1977": "Diagonally implicit Runge–Kutta methods for stiff O.D.E.'s, SIAM J. Numer. Anal. 14, 1006–1021",
    "Bogacki, Shampine 1989": "A 3(2) pair of Runge–Kutta formulas, Appl. Math. Lett. 2, 321–325",
    "Brown, Byrne, Hindmarsh 1989": "VODE: a variable-coefficient ODE solver, SIAM J. Sci. Stat. Comput. 10, 1038–1051",
    "Chung, Hulbert 1993": "A time integration algorithm for structural dynamics with improved numerical dissipation: "
    "the generalized-α method, J. Appl. Mech. 60, 371–375",
    "Dormand, Prince 1980": "A family of embedded Runge–Kutta formulae, J. Comput. Appl. Math. 6, 19–26",
    "García-Archilla, Sanz-Serna, Skeel 1999": "Long-time-step methods for oscillatory differential equations, "
    "SIAM J. Sci. Comput. 20, 930–963",
    "Gautschi 1961": "Numerical integration of ordinary differential equations based on trigonometric polynomials, "
    "Numer. Math. 3, 381–397",
    "Newmark 1959": "A method of computation for structural dynamics, J. Eng. Mech. Div. (ASCE) 85, 67–94",
    "Petzold 1983": "Automatic selection of methods for solving stiff and nonstiff systems of ordinary differential "
    "equations, SIAM J. Sci. Stat. Comput. 4, 136–148",
    "Shampine, Reichelt 1997": "The MATLAB ODE suite, SIAM J. Sci. Comput. 18, 1–22",
    "Yoshida 1990": "Construction of higher order symplectic integrators, Phys. Lett. A 150, 262–268",
}
"""Title, journal, volume and pages of the sources that are papers."""
TOLD = """
## The methods

Properties of methods with fixed steps are computed from their steps. An oscillation is stable up to the given |λ| h. A
symplectic method keeps the areas of x and p, so it does not damp. The other methods take the given share of an
amplitude away in a step of |λ| h = 0.5, or add it. R(−∞) is the part of a decay that is left after a step of
|λ| h = 1e12. A method is A-stable if it is stable at every step, for oscillations and for decays; it is L-stable if
R(−∞) is 0 too. The implicit midpoint, Newmark and Gauss 4 are A-stable but not L-stable: they keep a fast decay alive,
as the findings on the dashpot show. Generalized-α keeps the share ρ∞ of it in each step; HHT-α belongs to the same
family. The exponential integrators solve the coupling spring exactly, so an oscillation on that spring alone has no
limit; the other forces limit their step as they limit that of Verlet. The orders are those of measured slopes
(tests/physics/test_integrators.py).

For solvers that choose their steps, orders and sources are those in the source code of SciPy. Its BDF is modified
(NDF): it is A-stable up to order 2, and from order 3 on A(α)-stable with α of 80, 66 and 51 degrees (Shampine,
Reichelt 1997). Beyond that angle, for example for an oscillation that nothing damps, it grows at some steps. The BDF of
LSODA is not modified: there α is 86, 73 and 51 degrees.
"""


def methods_table() -> list[str]:
    """The section of the document on the methods."""
    rows = [["method", "order", "evaluations a step", "an oscillation", "damping at 0.5", "R(−∞)", "source"]]
    rows += [["---"] * 7]
    rows += [_fixed(slug, STEPPING[slug]) for slug in METHODS if slug in STEPPING]
    rows += [
        [METHODS[slug].name, order, "", stable, "", "", source] for slug, (order, stable, source) in SOLVERS.items()
    ]
    papers = [f"- {name}: {title}." for name, title in PAPERS.items()]
    return [TOLD, *("| " + " | ".join(row) + " |" for row in rows), "", *papers, ""]


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
