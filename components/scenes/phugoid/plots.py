"""The plots of the phugoid: its path, its swing over time, its period, its energies and its velocities."""

from __future__ import annotations

from typing import Any

from components.equations import rich
from components.plots import Band, Curve, plot
from components.sheet import Block, term, words
from components.stage import Shape, circle, line, on_x, on_y, var
from components.swing import FAMILY
from components.traces import traced


def path_plot() -> Block:
    """Height over distance, at one scale; the stage draws the rest over it."""
    block = plot(
        "path",
        x="along",
        y="up",
        title="Height of the flight against distance: the exact path, and dashed that of the linear theory",
        source="path",
        x_column="x",
        curves=(
            Curve(name="y_lin", source="path", x="x_lin", tint="m1", width="dash", group="path_lin"),
            Curve(name="y", source="path", tint="m1", width="sum", group="path"),
        ),
        bands=(Band(low="y_lo", high="y_hi", source="path_band", tint="m1", alpha=0.4, group="path"),),
        margin=(138, 4),
        square=True,
        phone=0,
        height=150,
    )
    return {**block, "style": "path"}


def swing_plot(name: str, tint: str, low: bool) -> Block:
    """h'(t) or v'(t), exact and linear, under the formula; the lower plot carries the time."""
    wave = rf"\val{{{name}_size}}\, \cos(\val{{omega}}\,t)\;\text{{linear}}"
    word = {"h": "Height", "v": "Speed"}[name]
    dashed, dashed_band = traced(f"{name}_lin", tint=tint, width="dash", label="linear", signal=f"{name}_lin")
    solid, solid_band = traced(name, tint=tint, width="sum", label="exact", signal=name)
    return plot(
        f"{name}_t",
        x="t",
        y=name,
        title=f"{word} against time, from that of steady flight: exact, and dashed by the linear theory",
        curves=(dashed, solid),
        bands=(dashed_band, solid_band),
        heading=(
            term(name, "sum", tint, formula=rf"{name}' = \val{{{name}}}\;\val{{{name}_unit}}"),
            term(f"{name}_lin", "dash", tint, formula=wave),
        ),
        x_labels=low,
        margin=(62, 52),
        cursor="time",
        phone=10 + low,
        height=150,
    )


def period_plot(names: dict[str, str]) -> Block:
    """Period against speed: one straight line for every aircraft; examples are buttons."""
    return plot(
        "period",
        x="v_0",
        y="tau",
        title="Period against the speed of steady flight: a straight line, the same for every aircraft",
        source="periods",
        x_column="v_0",
        curves=(Curve(name="tau", source="periods", tint="ink", width="sum", read="*τ*"),),
        heading=(
            term("", "sum", "ink", formula=r"\tau = \sqrt{2}\,\pi\,v_0 / g = \val{tau}\;\text{s}"),
            term("", "none", "mute", formula=r"\text{for any aircraft of this speed}"),
        ),
        margin=(44, 26),
        top=8,
        handles=({"parameter": "v_0", "symbol": "v₀", "label": "Speed of steady flight", "tint": "T", "least": 1.0},),
        marks=tuple(_example(name, label, i, i == len(names) - 1) for i, (name, label) in enumerate(names.items())),
        phone=14,
        height=270,
    )


def _example(name: str, label: str, i: int, last: bool) -> dict[str, Any]:
    """The flag of an example; that of the fastest stands left of its point."""
    return {
        "at": f"at_{name}",
        "tint": "ink",
        "style": "bare",
        "html": rich(f"{label}{{tau_{name}}}"),
        "label": f"Speed of: {label}",
        "act": name,
        "flag": "one end" if last else "one start",
        "shift": -10 if last else -1,
        "lift": -2 if last else -34 - 32 * i,
    }


def period_shapes(names: dict[str, str], show: str) -> list[Shape]:
    """Poles of the examples, and the lines from the point of this aircraft to both axes."""
    own: dict[str, Any] = {"show": show}
    x, y = on_x("period", var("v_here")), on_y("period", var("tau_here"))
    shapes = [
        line(var("period.left"), y, x, y, tint="mute", style="eq", **own),
        line(x, y, x, var("period.bottom"), tint="T", **own),
    ]
    for i, name in enumerate(names):
        at, tau = on_x("period", var(f"at_{name}")), on_y("period", var(f"tau_{name}_at"))
        if i < len(names) - 1:
            shapes.append(line(at, tau, at, var("period.top") + 34 + 32 * i, tint="rule", style="hair", **own))
        shapes.append(circle(at, tau, 5, **own))
    return [*shapes, circle(x, y, 6, tint="T", **own)]


def exchange_plots() -> tuple[Block, ...]:
    """Height against speed beside stretch against motion, as shares of their sum, and why they differ."""
    return (
        words("**Aircraft:** height and speed trade once a swing (first order)", phone=12),
        _shares("flight_energy", "share", "*m g h*", "½ *m v*²", "Energy of the aircraft: height and speed", False),
        words("**Spring:** stretch and motion trade twice a swing (second order)", phone=14),
        _shares(
            "spring_energy",
            "twin",
            "½ *k x*²",
            "½ *m x*′²",
            "Energy of the spring it mimics: stretch and motion",
            True,
        ),
        words(
            r"$\tfrac{1}{2} m\,v^2 = \tfrac{1}{2} m\,v_0^2 + m\,v_0 v' + \tfrac{1}{2} m\,v'^2$: what is traded for "
            r"$m\,g\,h'$ is the middle term, of first order, at $\omega$. A spring trades squares, "
            r"$\tfrac{1}{2} k\,x^2 \propto 1 + \cos 2 \omega t$, at $2 \omega$.",
            style="small",
            phone=16,
        ),
    )


def _shares(name: str, edge: str, upper: str, lower: str, title: str, low: bool) -> Block:
    return plot(
        name,
        x="t",
        y="share",
        title=title,
        bands=(
            Band(low="nothing", high=edge, tint="T", label=lower),
            Band(low=edge, high="all", tint="V", label=upper),
        ),
        x_labels=low,
        margin=(52, 8),
        cursor="time",
        phone=13 + 2 * low,
        height=110,
    )


def velocity_plot() -> Block:
    """The tip of every flight's velocity runs on a line of constant C; the arrow points as the aircraft does."""
    family = (
        Curve(
            name=f"w_{name}",
            source="family",
            x=f"u_{name}",
            tint="ink" if name == "cusp" else "mute",
            width="line" if name == "cusp" else "thin",
        )
        for name in FAMILY
    )
    return plot(
        "velocity",
        x="forward",
        y="upward",
        title="Velocity upward against forward: this flight, the linear theory, and others up to a loop",
        source="velocity",
        x_column="u",
        curves=(
            *family,
            Curve(name="w_lin", source="velocity", x="u_lin", tint="m1", width="dash"),
            Curve(name="w", source="velocity", tint="m1", width="sum"),
        ),
        heading=(
            term("w", "sum", "m1", formula=r"C = u - V^3/3 = \val{C}"),
            term("w_lin", "dash", "m1", formula=r"\text{linear; exact }\val{late}"),
        ),
        margin=(8, 8),
        square=True,
        handles=(
            {
                "parameter": "excess",
                "symbol": "v′",
                "label": "Excess of speed",
                "tint": "T",
                "least": -1,
                "text": "gain",
            },
        ),
        phone=14,
        height=280,
    )
