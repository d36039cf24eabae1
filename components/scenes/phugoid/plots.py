"""The plots of the phugoid: its path, its motion over time, its period, its energies and its velocities."""

from __future__ import annotations

from components.language.blocks import Block
from components.language.plots import Handle, Mark
from components.layout.plots import Room, curve, mark, plot, region
from components.layout.sheet import phrase, term, words
from components.layout.stage import PlotFrame
from components.layout.text import rich
from components.quantities.declared import LiveNumber, Signal
from components.scene.traces import band, traced
from components.scenes.phugoid.axes import Axes
from components.scenes.phugoid.curves import FAMILY, Limits, Periods
from components.scenes.phugoid.curves import Signals as S
from components.scenes.phugoid.flight import PATH, PERIOD, VELOCITY, Places
from components.scenes.phugoid.numbers import Numbers as N
from components.scenes.phugoid.swing import AIRCRAFT, Swing


def path_plot() -> Block:
    """The plot of height against distance with one scale. The stage draws the rest over it."""
    return plot(
        PATH,
        x=Axes.along,
        y=Axes.up,
        title="Height of the flight against distance: the exact path, and dashed that of the linear theory",
        x_column=S.x,
        curves=(
            curve(S.y_lin, source="path", x=S.x_lin, tint="m1", width="dash", group="path_lin"),
            curve(S.y, source="path", tint="m1", width="sum", group="path"),
        ),
        bands=(band(S.y, source="path_band", tint="m1", group="path"),),
        room=Room(138, 4),
        square=True,
        phone=0,
        height=150,
        style="path",
    )


def swing_plot(*, low: bool) -> Block:
    """h'(t) or v'(t), exact and linear."""
    word, on, exact, linear, size, tint = (
        ("Speed", Axes.v, S.v, S.v_lin, N.v_size, "T") if low else ("Height", Axes.h, S.h, S.h_lin, N.h_size, "V")
    )
    dashed, dashed_band = traced(linear, tint=tint, width="dash", read="linear", signal=linear)
    solid, solid_band = traced(exact, tint=tint, width="sum", read="exact", signal=exact)
    return plot(
        PlotFrame(f"{on.name}_t"),
        x=Axes.t,
        y=on,
        title=f"{word} against time, from that of steady flight: exact, and dashed by the linear theory",
        curves=(dashed, solid),
        bands=(dashed_band, solid_band),
        heading=(
            phrase(exact, "sum", tint, formula=f"{word.lower()} *{on.name}*′"),
            phrase(linear, "dash", tint, formula=rf"linear ${size}\, \cos({N.omega}\,t)$"),
        ),
        room=Room(62, 52),
        cursor="time",
        phone=10 + low,
        height=176,
    )


def period_plot() -> Block:
    """The plot of period against speed: one straight line for every aircraft. Examples are buttons."""
    return plot(
        PERIOD,
        x=Axes.v_0,
        y=Axes.tau,
        title="Period against the speed of steady flight: a straight line, the same for every aircraft",
        x_column=Periods.v_0,
        curves=(curve(Periods.tau, tint="ink", width="sum", read="*τ*"),),
        heading=(
            phrase("", "sum", "ink", formula=r"period of small swings $\tau =$"),
            term("", "none", "ink", formula=rf"\sqrt{{2}}\,\pi\,v_0 / g = {N.tau}\;\text{{s}}"),
        ),
        room=Room(44, 26, top=60),
        handles=(Handle(parameter="v_0", symbol="speed v₀", label="Speed of steady flight", tint="T", least=1.0),),
        marks=tuple(map(_example, AIRCRAFT, N.examples, (0, 1, 0, 1))),
        phone=10,
        height=222,
    )


def _example(name: str, tau: LiveNumber[Swing], row: int) -> Mark:
    """The flag of an example, in one of two rows over the frame."""
    label = AIRCRAFT[name][0]
    return mark(
        Places.at[name],
        tint="ink",
        style="bare",
        html=rich(f"{label.split()[0]}{tau}"),
        label=f"Speed of: {label}",
        act=name,
        flag="one",
        lift=54 - 26 * row,
    )


def lift_plot() -> tuple[Block, ...]:
    """The plot of lift divided by weight, exact and to first order, and the conclusion."""
    linear, linear_band = traced(S.lift_linear, tint="F", width="dash", read="linear", signal=S.lift_linear)
    exact, exact_band = traced(S.lift, tint="F", width="sum", read="exact", signal=S.lift, group="lift_exact")
    return (
        plot(
            PlotFrame("lift"),
            x=Axes.t,
            y=Axes.lift,
            title="Lift over weight against time: exact, and dashed to first order",
            curves=(linear, exact),
            bands=(linear_band, exact_band),
            heading=(
                term("lift_exact", "sum", "F", formula=f"L/(m g) = (v/v_0)^2 = {S.lift}"),
                term(S.lift_linear, "dash", "F", formula=rf"\text{{linear }}1 + 2 v'/v_0 = {S.lift_linear}"),
            ),
            room=Room(44, 52),
            cursor="time",
            phone=10,
            height=222,
        ),
        words(
            r"$m \ddot{h} = L \cos \theta - m g$. To first order $\ddot{h} = 2 g\, v'/v_0$,",
            r"and $g\, h' + v_0 v' = 0$ as thrust is drag: together $\ddot{h} + 2 (g/v_0)^2\, h' = 0$.",
            "In a real flight drag changes with speed and damps the motion.",
            style="small",
            phone=15,
        ),
    )


def exchange_plots() -> tuple[Block, ...]:
    """Height and speed compared with stretch and motion, as shares of their sum, and the reason for the difference."""
    return (
        words("**Aircraft:** height and speed exchange energy once a period (first order)", phone=10),
        _shares("flight_energy", S.share, "*m g h*", "½ *m v*²", "Energy of the aircraft: height and speed", low=False),
        words("**Spring:** stretch and motion exchange it twice a period (second order)", phone=12),
        _shares(
            "spring_energy",
            S.twin,
            "½ *k x*²",
            "½ *m x*′²",
            "Energy of the spring it mimics: stretch and motion",
            low=True,
        ),
        words(
            r"$\tfrac{1}{2} m\,v^2 = \tfrac{1}{2} m\,v_0^2 + m\,v_0 v' + \tfrac{1}{2} m\,v'^2$. Of a small $v'$ the "
            r"last term is too small to count: the middle one is traded for $m\,g\,h'$, at $\omega$. A spring "
            r"exchanges squares, $\tfrac{1}{2} k\,x^2 \propto 1 + \cos 2 \omega t$, at $2 \omega$.",
            style="small",
            phone=15,
        ),
    )


def _shares(name: str, edge: Signal[Swing], upper: str, lower: str, title: str, *, low: bool) -> Block:
    return plot(
        PlotFrame(name),
        x=Axes.t,
        y=Axes.share,
        title=title,
        bands=(
            region(S.zero, edge, tint="T", label=lower),
            region(edge, S.all, tint="V", label=upper),
        ),
        room=Room(52, 8),
        cursor="time",
        phone=11 + 2 * low,
        height=126,
    )


def velocity_plot() -> Block:
    """The plot of velocities. The tip of every flight's velocity moves on a line of constant C; the arrow points in the
    direction of flight.
    """
    family = (
        curve(
            Limits.upward[name],
            x=Limits.forward[name],
            tint="ink" if name == "cusp" else "mute",
            width="line" if name == "cusp" else "thin",
        )
        for name in FAMILY
    )
    return plot(
        VELOCITY,
        x=Axes.forward,
        y=Axes.upward,
        title="Velocity upward against forward: this flight, the linear theory, and others up to a loop",
        x_column=Limits.u,
        curves=(
            *family,
            curve(Limits.w_lin, x=Limits.u_lin, tint="m1", width="dash"),
            curve(Limits.w, tint="m1", width="sum"),
        ),
        heading=(
            term(Limits.w, "sum", "m1", formula=f"C = u - V^3/3 = {N.C}"),
            term(Limits.w_lin, "dash", "m1", formula=rf"\text{{linear; exact }}{N.late}"),
        ),
        room=Room(8, 8),
        square=True,
        handles=(
            Handle(parameter="excess", symbol="v′", label="Excess of speed", tint="T", least=-1, text=N.gain.name),
        ),
        phone=10,
        height=280,
    )
