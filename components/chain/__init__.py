"""Code that the scenes about two coupled masses share."""

from components.chain.modes import BOTH, MODES, PARTS, direction_lines, directions, lines_of
from components.chain.parameters import (
    BRAKED,
    CHAIN,
    DASHPOTS,
    SHARES,
    START,
    chain_group,
    damping_of,
    dashpots,
    dashpots_group,
    masses_and_springs,
    measured_by,
    of_scene,
    start_of,
    start_positions,
    start_velocities,
)
from components.chain.signals import Axes, FreeSignals, Signals, both, components, free_signals, positions
from components.chain.stage import (
    BODY,
    EQUILIBRIUM,
    WALL,
    DrawnChain,
    Extremes,
    Has,
    Places,
    cups,
    displacement_arrow,
    extremes,
    ground,
    masses,
    place,
    rest,
    scale,
    side,
    sides,
    sizes,
    standing_wall,
    to_scale,
)

FREE = ("m1 x1'' = -k1 x1 - k2 (x1 - x2)", "m2 x2'' = k2 (x1 - x2)")
"""The equations of motion, as components.scene says."""

DRIVEN = (FREE[0] + " + F_0 sin(omega t)", FREE[1])

BRAKED_DRIVEN = (FREE[0] + " - c1 x1' - c2 (x1' - x2') + F_0 sin(omega t)", FREE[1] + " + c2 (x1' - x2')")
