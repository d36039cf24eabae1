"""Chains for tests of claims, and their equations and squared natural frequencies with 40 digits."""

from __future__ import annotations

from typing import Any

import mpmath as mp

from tests.scenes.visible_sentences import Draw

mp.mp.dps = 40


def chain(draw: Draw, none: float = 0.0) -> dict[str, float]:
    """A chain over decades; with `none`, a spring is missing in that share of all draws."""
    values = {name: draw.size() for name in ("m1", "m2")}
    return values | {name: draw.some(draw.size(-4, 4), none) for name in ("k1", "k2")}


def matrix(scene: Any, square: Any) -> mp.matrix:
    m1, m2, k1, k2 = (mp.mpf(getattr(scene, name)) for name in ("m1", "m2", "k1", "k2"))
    return mp.matrix([[m1 * square - k1 - k2, k2], [k2, m2 * square - k2]])


def squares(scene: Any) -> list[Any]:
    """Both omega^2 by the eigenvalues of M^(-1/2) K M^(-1/2)."""
    m1, m2, k1, k2 = (mp.mpf(getattr(scene, name)) for name in ("m1", "m2", "k1", "k2"))
    K = mp.matrix([[(k1 + k2) / m1, -k2 / mp.sqrt(m1 * m2)], [-k2 / mp.sqrt(m1 * m2), k2 / m2]])
    if not k1 * k2:
        return [mp.mpf(0), K[0, 0] + K[1, 1]]
    return sorted(mp.eigsy(K, eigvals_only=True))


def number(text: str) -> float:
    """Return a number as the page writes it: −1.23·10⁻⁷."""
    plain = text.replace("−", "-").replace("·10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    return float(plain.replace("+", ""))


def starts(scene: Any) -> tuple[list[float], list[float]]:
    x_0, v_0 = ([getattr(scene, f"{q}{n}_0", 0.0) for n in (1, 2)] for q in "xv")
    return x_0, v_0
