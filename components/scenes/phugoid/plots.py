"""The plots of the phugoid: its path, its swing over time, its period, its energies and its velocities."""

from __future__ import annotations

from components.language.blocks import Block
from components.language.numbers import var
from components.language.plots import Handle, Mark
from components.layout.plots import Room, curve, plot, region
from components.layout.sheet import term, words
from components.layout.stage import Looks, Shape, circle, line, on_x, on_y
from components.layout.text import rich
from components.quantities.declared import LiveNumber
from components.scene.traces import traced
from components.scenes.phugoid.numbers import Numbers as N
from components.scenes.phugoid.swing import FAMILY, Swing

EQUATIONS = {"h": r"\ddot{h} + 2 (g/v_0)^2\, h' = 0", "v": r"g\, h' + v_0\, v' = 0"}
"""To first order: the equation of motion, and what the two trade."""


def path_plot() -> Block:
    """Height over distance, at one scale; the stage draws the rest over it."""
    return plot(
        "path",
        x="along",
        y="up",
        title="Height of the flight against distance: the exact path, and dashed that of the linear theory",
        x_column="x",
        curves=(
            curve("y_lin", source="path", x="x_lin", tint="m1", width="dash", group="path_lin"),
            curve("y", source="path", tint="m1", width="sum", group="path"),
        ),
        bands=(region(low="y_lo", high="y_hi", source="path_band", tint="m1", alpha=0.4, group="path"),),
        room=Room(138, 4),
        square=True,
        phone=0,
        height=150,
        style="path",
    )


def swing_plot(name: str, tint: str, low: bool) -> Block:
    """h'(t) or v'(t), exact and linear, under the formula; the lower plot carries the time."""
    wave = rf"{N.h_size if name == 'h' else N.v_size}\, \cos({N.omega}\,t)"
    word = {"h": "Height", "v": "Speed"}[name]
    dashed, dashed_band = traced(f"{name}_lin", tint=tint, width="dash", read="linear", signal=f"{name}_lin")
    solid, solid_band = traced(name, tint=tint, width="sum", read="exact", signal=name)
    return plot(
        f"{name}_t",
        x="t",
        y=name,
        title=f"{word} against time, from that of steady flight: exact, and dashed by the linear theory",
        curves=(dashed, solid),
        bands=(dashed_band, solid_band),
        heading=(
            term(name, "sum", tint, formula=f"{name}'"),
            term(f"{name}_lin", "dash", tint, formula=rf"\text{{linear }}{wave}"),
            term("", "none", "ink", formula=EQUATIONS[name]),
        ),
        x_labels=low,
        room=Room(62, 52),
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
        x_column="v_0",
        curves=(curve("tau", source="periods", tint="ink", width="sum", read="*τ*"),),
        heading=(
            term("", "sum", "ink", formula=r"\tau ="),
            term("", "none", "ink", formula=rf"\sqrt{{2}}\,\pi\,v_0 / g = {N.tau}\;\text{{s}}"),
        ),
        room=Room(44, 26, top=60),
        handles=(Handle(parameter="v_0", symbol="v₀", label="Speed of steady flight", tint="T", least=1.0),),
        marks=tuple(map(_example, names, names.values(), N.examples, (0, 1, 0, 1))),
        phone=14,
        height=270,
    )


def _example(name: str, label: str, tau: LiveNumber[Swing], row: int) -> Mark:
    """The flag of an example, in one of two rows over the frame."""
    return Mark(
        at=f"at_{name}",
        tint="ink",
        style="bare",
        html=rich(f"{label.split()[0]}{tau}"),
        label=f"Speed of: {label}",
        act=name,
        flag="one",
        lift=54 - 26 * row,
    )


def period_shapes(names: dict[str, str], show: str) -> list[Shape]:
    """Poles of the examples, and the lines from the point of this aircraft to both axes."""
    own: Looks = {"show": show}
    x, y = on_x("period", var("v_here")), on_y("period", var("tau_here"))
    shapes = [
        line(var("period.left"), y, x, y, tint="mute", style="eq", **own),
        line(x, y, x, var("period.bottom"), tint="T", **own),
    ]
    for name in names:
        at, tau = on_x("period", var(f"at_{name}")), on_y("period", var(f"tau_{name}_at"))
        shapes.append(line(at, tau, at, var("period.top"), tint="rule", style="hair", **own))
        shapes.append(circle(at, tau, 5, **own))
    return [*shapes, circle(x, y, 6, tint="T", **own)]


def lift_plot() -> tuple[Block, ...]:
    """Lift over weight, exact and to first order, and what follows from it."""
    linear, linear_band = traced("lift_linear", tint="F", width="dash", read="linear", signal="lift_linear")
    exact, exact_band = traced("lift", tint="F", width="sum", read="exact", signal="lift", group="lift_exact")
    return (
        plot(
            "lift",
            x="t",
            y="lift",
            title="Lift over weight against time: exact, and dashed to first order",
            curves=(linear, exact),
            bands=(linear_band, exact_band),
            heading=(
                term("lift_exact", "sum", "F", formula=r"L/(m g) = (v/v_0)^2 = \val{lift}"),
                term("lift_linear", "dash", "F", formula=r"\text{linear }1 + 2 v'/v_0 = \val{lift_linear}"),
            ),
            room=Room(44, 52),
            cursor="time",
            phone=14,
            height=200,
        ),
        words(
            r"$m \ddot{h} = L \cos \theta - m g$, to first order $\ddot{h} = 2 g\, v'/v_0$.",
            r"Thrust is drag, so $g\, h' + v_0 v' = 0$: together $\ddot{h} + 2 (g/v_0)^2\, h' = 0$.",
            style="small",
            phone=15,
        ),
    )


def exchange_plots() -> tuple[Block, ...]:
    """Height against speed beside stretch against motion, as shares of their sum, and why they differ."""
    return (
        words("**Aircraft:** height and speed exchange energy once a swing (first order)", phone=12),
        _shares("flight_energy", "share", "*m g h*", "½ *m v*²", "Energy of the aircraft: height and speed", False),
        words("**Spring:** stretch and motion exchange it twice a swing (second order)", phone=14),
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
            r"$m\,g\,h'$ is the middle term, of first order, at $\omega$. A spring exchanges squares, "
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
            region(low="nothing", high=edge, tint="T", label=lower),
            region(low=edge, high="all", tint="V", label=upper),
        ),
        x_labels=low,
        room=Room(52, 8),
        cursor="time",
        phone=13 + 2 * low,
        height=110,
    )


def velocity_plot() -> Block:
    """The tip of every flight's velocity runs on a line of constant C; the arrow points as the aircraft does."""
    family = (
        curve(
            f"w_{name}",
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
        x_column="u",
        curves=(
            *family,
            curve("w_lin", source="velocity", x="u_lin", tint="m1", width="dash"),
            curve("w", source="velocity", tint="m1", width="sum"),
        ),
        heading=(
            term("w", "sum", "m1", formula=f"C = u - V^3/3 = {N.C}"),
            term("w_lin", "dash", "m1", formula=rf"\text{{linear; exact }}{N.late}"),
        ),
        room=Room(8, 8),
        square=True,
        handles=(Handle(parameter="excess", symbol="v′", label="Excess of speed", tint="T", least=-1, text="gain"),),
        phone=14,
        height=280,
    )
