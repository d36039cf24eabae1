"""What the absorber's scene says: formulas, explanations, verdicts."""

from __future__ import annotations

from components.sheet import Paragraph, either

TASK = "Meet all three goals, then meet them with less mass."

HELPED = {
    "band": "helped from {help_low} to {help_high}",
    "above": "helped above {help_low}",
    "never": "helped nowhere",
}

VERDICTS = {
    "still": "Tuned, it stands still",
    "less": "With it, it shakes less",
    "more": "With it, it shakes more",
    "grow": "At a resonance, it grows",
    "beat": "By a resonance, it beats",
    "detached": "Detached, it shakes",
    "rest": "With it, within {rest1} {x_unit}",
}

_FIRST = either(
    "first",
    undamped=(
        r"$\tint{m1}{X_{\mathrm{p}1} = \dfrac{(k_2 - m_2 \omega^2) F_0}{D} = \val{Xp1}}$"
        " [m1|{x_unit}]"
    ),
    damped=(r"$\tint{m1}{|X_1| = \dfrac{|\kappa - m_2 \omega^2| F_0}{|D|} = \val{swing}}$ [m1|{x_unit}]"),
    none=r"$D = m_1 m_2 (\omega^2 - \omega_-^2)(\omega^2 - \omega_+^2) = 0$",
)
_SECOND = either(
    "second",
    still=(r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = -\dfrac{F_0}{k_2} = \val{Xp2}}$ [m2|{x_unit}]"),
    undamped=r"$\tint{m2}{X_{\mathrm{p}2} = \dfrac{k_2 F_0}{D} = \val{Xp2}}$ [m2|{x_unit}]",
    damped="",
)
_WHY = either(
    "why",
    still=(
        r"$k_2 = m_2 \omega^2$: spring 2 pulls exactly as hard as the drive pushes, and nothing is left to move the "
        "machine. From rest it swings all the same, within {rest1} {x_unit}: that part never dies."
    ),
    less=(
        r"$k_2 \ne m_2 \omega^2$: spring 2 pulls with {pull} {F_unit} at the most, the drive pushes with "
        "{push}. What is left moves the machine."
    ),
    more=(
        "Here the absorber does harm: alone the machine swings {alone} {x_unit}, with it {swing} {x_unit}. "
        "A resonance is too near."
    ),
    grow=(
        "The drive meets a natural frequency: no particular solution exists. From rest the swing grows like the time."
    ),
    beat=(
        "The drive is next to a natural frequency, and the particular solution is huge. From rest the swing grows "
        "like the time for long, then it beats."
    ),
    detached="Nothing pulls back: the machine takes the whole drive.",
    damped=(r"$\kappa = k_2 + i c \omega$ takes the place of $k_2$. $P$ and $Q$ are the same for every $c$."),
)
_OPTIMUM = either(
    "optimum",
    shown=(
        r"Den Hartog makes them equal, {height} {x_unit}, and nearly the peaks, which are {over_height} higher: "
        r"$\omega_2 = \dfrac{\omega_1}{1 + \mu}$, "
        r"$\dfrac{c}{2 m_2 \omega_1} = \sqrt{\dfrac{3 \mu}{8 (1 + \mu)^3}}$"
    ),
)


def sentences() -> list[Paragraph]:
    """Both amplitudes and why they are what they are; beyond the lecture, the best damping."""
    return [_FIRST, _SECOND, _WHY, _OPTIMUM]
