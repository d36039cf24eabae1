"""The parameters of the two-mass chain, its groups of controls, and the chain of a scene."""

from __future__ import annotations

from components.language.expressions import Name
from components.language.picture import Onward
from components.layout.controls import Group
from components.quantities.parameters import Quantity, displacement, mass, not_negative, stiffness, velocity
from physics.coupled import TwoMassChain

Pair = tuple[float, float]
CHAIN = ("m1", "m2", "k1", "k2")
SHARES = {f"{name} of the chain": name for name in CHAIN}
"""The parameters of the chain, by the meaning that they share in all scenes of the same chain."""
DASHPOTS = ("c1", "c2")
BRAKED = SHARES | {f"{name} of the chain": name for name in DASHPOTS}
"""The parameters of the chain and its dashpots, by meaning."""
START = ("x1_0", "x2_0", "v1_0", "v2_0")


def masses_and_springs(
    m1: float, m2: float, k1: float, k2: float, *, first: str = "next to the wall"
) -> tuple[Quantity, Quantity, Quantity, Quantity]:
    """Return m1, m2, k1, k2 with these defaults. `first` describes mass 1 for visitors."""
    return (
        mass(m1, symbol="m_1", tint="m1", says=f"is the mass {first}. Type any value above 0."),
        mass(m2, symbol="m_2", tint="m2", says="is the mass at the end. Type any value above 0."),
        stiffness(k1, symbol="k_1", says="ties mass 1 to the wall. 0 takes the spring away; type any value from 0 up."),
        stiffness(k2, symbol="k_2", says="couples the masses. 0 takes the spring away; type any value from 0 up."),
    )


def chain_group(m1: Quantity, m2: Quantity, k1: Quantity, k2: Quantity) -> Group:
    return Group("Masses and springs", (m1, m2, k1, k2))


def dashpots_group(c1: Quantity, c2: Quantity, form: Name | None = None) -> Group:
    return Group("", (c1, c2), "Dashpots beside the springs", folded=True, form=form)


def dashpots() -> tuple[Quantity, Quantity]:
    """Return c1 and c2, with the default 0."""
    one, two = (
        not_negative(
            0.0, symbol=f"c_{i}", unit="N s/m", label="damping", tint="T", scale="near0", softbounds=(0.0, 4.0),
            allowed="a dashpot only takes energy: its damping is a finite number, 0 or more",
            says=f"is the dashpot beside spring {i}: its force over the velocity. Any value from 0 up.",
        )
        for i in (1, 2)
    )  # fmt: skip
    return one, two


def start_positions(x1_0: float = 0.0, x2_0: float = 0.0, *, how: str = "") -> tuple[Quantity, Quantity]:
    """Return x1_0 and x2_0. `how` completes the description of the initial conditions."""
    one, two = (
        displacement(
            x,
            symbol=f"x_{i}",
            label=f"displacement of mass {i}",
            tint=f"m{i}",
            says=f"is where mass {i} starts{how}. Type any value.",
        )
        for i, x in enumerate((x1_0, x2_0), start=1)
    )
    return one, two


def start_velocities() -> tuple[Quantity, Quantity]:
    """v1_0 and v2_0."""
    one, two = (
        velocity(0.0, symbol=f"v_{i}", tint=f"m{i}", says=f"is the velocity of mass {i} at the start. Type any value.")
        for i in (1, 2)
    )
    return one, two


def of_scene(scene: object) -> TwoMassChain:
    """The chain with the scene's parameters."""
    return TwoMassChain(**_values(scene, CHAIN))


def damping_of(scene: object) -> Pair:
    """Return c1 and c2 of the dashpots parallel to the springs."""
    c1, c2 = _values(scene, DASHPOTS).values()
    return c1, c2


def start_of(scene: object) -> tuple[Pair, Pair]:
    """Return the initial displacements and velocities of a scene."""
    x1, x2, v1, v2 = _values(scene, START).values()
    return (x1, x2), (v1, v2)


def _values(scene: object, names: tuple[str, ...]) -> dict[str, float]:
    return {name: getattr(scene, name) for name in names}


def measured_by(*drive: str) -> Onward:
    """The link that opens a motion, with its drive if it has one, in the scene accuracy."""
    names = (*CHAIN, *START, *drive)
    return Onward(
        label="Error and time", scene="accuracy", given={"system": "own"}, taken=dict(zip(names, names, strict=True))
    )
