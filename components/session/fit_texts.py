"""The numbers of a fit to a measured record, the parameters of a scene that follow from it, and sentences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from components.language.messages import FittedMotion, FittedNumber, FittedParameters
from components.quantities.formatting import three, with_error
from physics.chain_fit import ChainFit, chain_of_fit
from physics.fit import Caution, DampedFit
from physics.residuals import Cause, cause_of

FEW_IN_A_CYCLE = 4.0
"""With more rows per cycle, a wrong frequency due to sampling (an alias) is unlikely."""
SIGNIFICANT = 4.0
"""A difference of so many standard errors is significant."""
UNITS = ("m", "m/s", "m/s²")
"""The units of a displacement and of its derivatives."""
RANDOM = "The residuals of the fit are random: the model agrees with your points within their scatter."
NOT_RANDOM = "The residuals of the fit are not random: {}. The standard errors allow for this."
MANY = "the friction is not viscous, or something else moves too"
CAUSES = {
    Cause.AIR: "large swings lose more than their share, as with the drag of air",
    Cause.DRY: "small swings lose more than their share, as with dry friction",
    Cause.SPRING: "the frequency changes with the amplitude, as with a spring that is not linear",
    Cause.DRIFT: "the equilibrium moves during the record",
    Cause.OTHER: "something else moves too, most at {} rad/s",
}
SENTENCES = {
    Caution.DRIFT: "The points drift: the fit includes a straight line.",
    Caution.CLIPPED: "Some points are at a limit of the sensor: the fit leaves them out.",
    Caution.FEW_ROWS: "The file has fewer than 30 points: the standard errors are rough.",
    Caution.WEAK: "The scatter is nearly as large as the motion: the frequency may be wrong.",
}
ONE_MASS = "A motion determines only k/m and c/m: “Fit to data” keeps the mass m."
TWO_MASSES = "A motion determines only ratios of masses and stiffnesses: “Fit to data” keeps the mass m₁."
NO_CHAIN = (
    "No chain of two masses and two springs has these modes, so “Fit to data” is not possible: check the order of the "
    "columns, their signs and their units."
)
DECAYS = "Your points decay, and the masses of this scene have no dashpots: its curves leave the points with time."
TWO_VALUES = "The two modes give different values of k₂/m₂: this chain describes your system only roughly."


class Described(NamedTuple):
    numbers: tuple[FittedNumber, ...]
    parameters: FittedParameters | None
    sentences: tuple[str, ...]


def on_residuals(t: Sequence[float], fit: DampedFit) -> tuple[str, ...]:
    """Return sentences for the reader of a fit: first on the residuals, then cautions."""
    first = NOT_RANDOM.format(_cause(t, fit)) if Caution.CORRELATED in fit.cautions else RANDOM
    cautions = (text for caution, text in SENTENCES.items() if caution in fit.cautions)
    pairs = zip(fit.aliases, fit.omega.tolist(), strict=False)
    aliases = [alias for alias, omega in pairs if alias + omega < FEW_IN_A_CYCLE * omega]
    return (first, *cautions, *(f"Rows so far apart fit {three(alias)} rad/s equally well." for alias in aliases))


def _cause(t: Sequence[float], fit: DampedFit) -> str:
    """The cause of the residuals in words; with two frequencies it is not known."""
    if len(fit.omega) > 1:
        return MANY
    cause, strongest = cause_of(np.asarray(t), fit)
    return CAUSES[cause].format(three(strongest))


def one_mass(fit: DampedFit, motion: FittedMotion, derivative: int) -> Described:
    """The numbers of a damped mass on a spring."""
    (column,), (omega,), (decay,) = motion.columns, motion.omega, motion.decay
    size, natural = math.hypot(column.C[0], column.S[0]), math.hypot(omega, decay)
    se_natural = math.hypot(omega * fit.se_omega[0], decay * fit.se_decay[0]) / natural
    se_size = size * math.hypot(fit.se_amplitude[0, 0] / fit.amplitude[0, 0], derivative * se_natural / natural)
    phase = math.atan2(column.C[0], column.S[0])
    numbers = (
        _number("<i>ω</i><sub>n</sub>", "natural frequency", natural, se_natural, "rad/s"),
        _number("<i>ζ</i>", "damping ratio", fit.zeta[0], fit.se_zeta[0]),
        _number("<i>C</i>", "amplitude at the start", size, se_size, "m"),
        _number("<i>φ</i>", "phase at the start", phase, fit.se_phase[0, 0], "rad"),
        _number("offset", "offset", column.offset, fit.se_offset[0], UNITS[derivative]),
        _scatter("<i>σ</i>", "standard deviation of the residuals", column.scatter, UNITS[derivative]),
    )
    a = max(decay, 0.0)  # a dashpot cannot add energy
    values: dict[str, float | str] = {"keep": "c", **_start(motion, "")}
    parameters = FittedParameters(mass="m", values=values, per_mass={"k": omega**2 + a**2, "c": 2 * a})
    return Described(numbers, parameters, (ONE_MASS,))


def two_masses(fit: DampedFit, motion: FittedMotion, derivative: int) -> Described:
    """The numbers of two coupled masses."""
    chain, unit = chain_of_fit(fit), UNITS[derivative]
    numbers = []
    for j, (sign, mode) in enumerate((("−", "slow mode"), ("+", "fast mode"))):
        of = f"<sub>{sign}</sub>"
        numbers += [
            _number(f"<i>ω</i>{of}", f"natural frequency, {mode}", chain.omega[j], chain.se_omega[j], "rad/s"),
            _number(f"<i>a</i>{of}", f"decay, {mode}", fit.decay[j], fit.se_decay[j], "1/s"),
            _number(f"(<i>X</i>₂/<i>X</i>₁){of}", f"X2/X1, {mode}", chain.ratio[j], chain.se_ratio[j]),
        ]
    if chain.parts is not None:
        names = (("k₁", "k1/m1", "1/s²"), ("k₂", "k2/m1", "1/s²"), ("m₂", "m2/m1", ""))
        rows = zip(names, chain.parts.tolist(), chain.se_parts.tolist(), strict=True)
        numbers += [
            _number(f"<i>{symbol[0]}</i>{symbol[1]}/<i>m</i>₁", name, value, se, si)
            for (symbol, name, si), value, se in rows
        ]
    for i, column in enumerate(motion.columns):
        name = f"{'₁₂'[i]}"
        numbers.append(_number(f"offset{name}", f"offset {i + 1}", column.offset, fit.se_offset[i], unit))
        numbers.append(_scatter(f"<i>σ</i>{name}", f"standard deviation of residuals {i + 1}", column.scatter, unit))
    return Described(tuple(numbers), _chain_parameters(chain, motion), _on_chain(fit, chain))


def _chain_parameters(chain: ChainFit, motion: FittedMotion) -> FittedParameters | None:
    if chain.parts is None:
        return None
    k1, k2, m2 = chain.parts.tolist()
    values: dict[str, float | str] = {"given_by": "values", **_start(motion, "1", "2")}
    return FittedParameters(mass="m1", values=values, per_mass={"m2": m2, "k1": k1, "k2": k2})


def _on_chain(fit: DampedFit, chain: ChainFit) -> tuple[str, ...]:
    if chain.parts is None:
        return (NO_CHAIN,)
    decays = bool((fit.decay > SIGNIFICANT * fit.se_decay).any())
    two_values = abs(chain.difference) > SIGNIFICANT
    return (*((DECAYS,) if decays else ()), *((TWO_VALUES,) if two_values else ()), TWO_MASSES)


def _start(motion: FittedMotion, *masses: str) -> dict[str, float]:
    """The displacement and the velocity of each mass at the first row."""
    found = {}
    for mass, column in zip(masses, motion.columns, strict=True):
        parts = list(zip(motion.omega, motion.decay, column.C, column.S, strict=True))
        found[f"x{mass}_0"] = sum(column.C)
        found[f"v{mass}_0"] = sum(omega * S - decay * C for omega, decay, C, S in parts)
    return found


def _number(symbol: str, name: str, value: float, se: float, unit: str = "") -> FittedNumber:
    text, error = with_error(float(value), float(se))
    return FittedNumber(symbol=symbol, name=name, value=text, error=error, unit=unit)


def _scatter(symbol: str, name: str, value: float, unit: str) -> FittedNumber:
    return FittedNumber(symbol=symbol, name=name, value=three(value), error="", unit=unit)
