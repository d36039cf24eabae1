"""Error against run time: what a digit costs, method by method, measured on the server while the visitor looks on."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import param

from components.axes import Axis, log_axis, nice_axis
from components.controls import Group
from components.measuring import Job, measuring
from components.numbers import short, three
from components.parameters import angular_frequency, displacement, force, mass, positive, stiffness, velocity
from components.scene import Picture, Scene
from components.scenes.accuracy.data import (
    FLOOR,
    REACH,
    TOP,
    done,
    growth,
    kept,
    picked_run,
    price_texts,
    prices,
    recorded,
    setting_text,
    stability,
    step_explosion,
    stopped,
    work,
)
from components.scenes.accuracy.plots import (
    STOPPED,
    growth_plot,
    name_places,
    picked_plot,
    price_rows,
    stability_plot,
    steps_plot,
    stopped_rows,
    work_plot,
)
from components.sheet import Block, choice, column, row, when, words
from physics.accuracy import PERIODS, SYSTEMS, Run, System, plan
from physics.coupled import TwoMassChain
from physics.solvers import METHODS

VIEWS = {"time": "Run time", "growth": "Growth", "energy": "Energy", "stability": "Stability"}
OWN = "own"


class Accuracy(Scene):
    slug = "accuracy"
    title = "Accuracy"
    lecture = "Numerics"
    headline = "Stepping pays for every digit; the formula does not"
    runs = True
    start = "System"
    presets = {
        **{system.name: {"system": slug} for slug, system in SYSTEMS.items()},
        "From a link": {"system": OWN},
    }
    groups = (Group("Run", ("wanted", "limit")),)

    system = param.Selector(default="benign", objects=[*SYSTEMS, OWN], label="System")
    wanted = positive(
        1e-6,
        symbol="error",
        unit="",
        label="error",
        softbounds=(1e-15, 1.0),
        scale="log",
        says="is the error that is good enough. The list says what it costs.",
    )
    limit = positive(
        4.0,
        symbol="limit",
        unit="s",
        label="time limit of a run",
        softbounds=(0.5, 20.0),
        bounds=(0.01, 60.0),
        inclusive_bounds=(True, True),
        allowed="the time limit of a run is 0.01 to 60 s",
        says="is how long one run may take. A method that takes longer is a row with its reason.",
    )
    view = param.Selector(default="time", objects=list(VIEWS), label="View")
    picked = param.List(default=["verlet", "2"], item_type=str, doc="The run picked: method and place in its settings.")
    m1 = mass(1.0, symbol="m_1")
    m2 = mass(1.0, symbol="m_2")
    k1 = stiffness(1.0, symbol="k_1")
    k2 = stiffness(1.0, symbol="k_2")
    x1_0 = displacement(1.0, symbol="x_1")
    x2_0 = displacement(0.0, symbol="x_2")
    v1_0 = velocity(0.0, symbol="v_1")
    v2_0 = velocity(0.0, symbol="v_2")
    F_0 = force(0.0)
    omega = angular_frequency(1.0)
    measured = param.Parameter(default=None, doc="The measurement that the page has asked for, as far as it has come.")

    def __init__(self, **values: Any) -> None:
        self._job: Job | None = None
        super().__init__(**values)

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return column(
            choice("view", VIEWS, "View", basis=0, style="views"),
            when(
                "time",
                row(
                    column(
                        words(
                            "{chain}. Fast over slow frequency {ratio}. 50 slow periods, 1000 outputs.",
                            style="plain",
                            phone=9,
                        ),
                        work_plot(),
                    ),
                    column(
                        words("**An error of {wanted} costs** [mute|× closed form]", style="plain", phone=11),
                        price_rows(phone=11),
                        words({"form": "stopped0", "shown": "**Without a result**"}, style="plain", phone=12),
                        stopped_rows(phone=12),
                        words(
                            {
                                "form": "picked",
                                "run": "**Energy kept, phase lost?** {picked}; worst so far. Click any dot to pick it.",
                                "none": "**Energy kept, phase lost?** Click any dot to pick a run.",
                            },
                            style="plain",
                            phone=13,
                        ),
                        picked_plot(),
                        basis=300,
                        grow=0,
                    ),
                ),
            ),
            growth_plot(
                "error_growth", "Worst error so far, against simulated time (finest run of each method)", "growth"
            ),
            growth_plot("energy_growth", "Worst error of the energy so far: it does not certify the phase", "energy"),
            when("stability", column(stability_plot(), steps_plot())),
        )

    @property
    def progress(self) -> dict[str, Any]:
        job = self._job
        if job is None or not self._is_current(job):
            return {"state": "idle", **self._idle()}
        before = measuring().place(job)
        text = (
            f"{before} measurement{'s' if before > 1 else ''} before yours." if job.state == "waiting" else job.reason
        )
        if job.state == "running" and job.method:
            text = f"{METHODS[job.method].name} is running."
        return {"state": job.state, "done": len(job.runs), "total": job.total, "text": text}

    def _idle(self) -> dict[str, Any]:
        """What is shown while nothing runs: counts, and where the numbers come from."""
        system, runs = self._system(), self._runs()
        told = {"done": len(runs), "total": len(runs)}
        if measuring().remembered(system, self.limit):
            return {**told, "text": "Measured before on this server."}
        if runs and self._is_measured(system):
            return {**told, "total": len(plan(system)), "text": "Stopped before its end; these were measured here."}
        return {**told, "text": _recorded_text() if runs else "Press Run to measure."}

    def run(self, order: str) -> None:
        if order == "start":
            self.close()
            self._job = measuring().ask(self._system(), self.limit, self._heard)
            self._heard()
        elif order == "skip" and self._job:
            measuring().skip(self._job)
        elif order == "cancel":
            self.close()

    def close(self) -> None:
        if self._job:
            measuring().leave(self._job, self._heard)
            self._job = None

    def _heard(self) -> None:
        self.later(self._look)

    def _look(self) -> None:
        """Show what has come; a new tuple each time, so that the picture is made anew."""
        if self._job:
            self.set({"measured": (self._job.system, self._job.seconds, self._job.runs, self._job.state)})

    def _is_current(self, job: Job) -> bool:
        return (job.system, job.seconds) == (self._system(), self.limit)

    def _is_measured(self, system: System) -> bool:
        """Whether this visitor has results of the system, all or some."""
        return bool(self.measured) and self.measured[:2] == (system, self.limit)

    def _system(self) -> System:
        if self.system != OWN:
            return SYSTEMS[self.system]
        chain = TwoMassChain(m1=self.m1, m2=self.m2, k1=self.k1, k2=self.k2)
        start = {"x_0": (self.x1_0, self.x2_0), "v_0": (self.v1_0, self.v2_0)}
        system = System(slug=OWN, name="Own", chain=chain, **start, F_0=self.F_0, omega=self.omega)
        system.problem()
        return system

    def _runs(self) -> tuple[Run, ...]:
        system = self._system()
        if self._is_measured(system):
            return tuple(self.measured[2])
        known = measuring().remembered(system, self.limit)
        if known:
            return known.runs
        return recorded().runs.get(system.slug, ()) if self.limit == recorded().seconds and not self._job else ()

    def picture(self) -> Picture:
        system, runs = self._system(), self._runs()
        picked = picked_run(runs, self.picked)
        time, error = log_axis(1e-4, 2 * self.limit, "s"), log_axis(1e-17, 10.0, "")
        curves = work(runs)
        problem = system.problem()
        return Picture(
            columns={
                **curves,
                **growth(runs if self.view == "growth" else (), "error_growth"),
                **growth(runs if self.view == "energy" else (), "energy_growth"),
                "kept": kept(picked),
                "stability": stability() if self.view == "stability" else {},
                "explosion": step_explosion(system.chain) if self.view == "stability" else {},
            },
            axes=_axes(time, error, picked),
            scalars={
                **name_places(curves, time, error),
                "wanted_at": error.place(self.wanted),
                "rounding_at": error.place(2.0**-53),
                "limit_at": time.place(self.limit),
                **_picked_scalars(picked, time, error, problem.spacing * float(system.chain.modes().omega[1])),
            },
            values={
                **_texts(runs, self.wanted),
                **system_texts(system),
                "picked": setting_text(picked) if picked else "",
            },
            forms={**_forms(self.view, runs, self.wanted), "picked": "run" if picked else "none"},
        )


def _recorded_text() -> str:
    """Where the numbers come from that stand before anything is run."""
    date, _, _ = recorded().about["date"].partition(" ")
    return f"Recorded {date} on another machine; Run measures here."


def _axes(time: Axis, error: Axis, picked: Run | None) -> dict[str, Axis]:
    worst = max(kept(picked).get("motion", np.ones(1)).max(), 1e-14)
    return {
        "time": time,
        "error": error,
        "period": nice_axis(0.0, float(PERIODS), "", 5, exact=True),
        "percent": nice_axis(0.0, float(worst), "%", 2),
        "error_growth": error,
        "energy_growth": error,
        "h_omega": nice_axis(0.0, REACH, "", 6, exact=True),
        "growth": nice_axis(0.8, TOP, "", 4, exact=True),
        "ratio": log_axis(1.0, 1e12, ""),
        "steps": log_axis(1.0, 1e8, ""),
    }


def _picked_scalars(picked: Run | None, time: Axis, error: Axis, reach: float) -> dict[str, float]:
    if picked is None or picked.time is None or picked.error is None:
        return {}
    scalars = {
        "picked": 1.0,
        "picked_at": time.place(picked.time),
        "picked_error": error.place(max(picked.error, FLOOR)),
    }
    if picked.family == "fixed":
        scalars["step_at"] = min(reach / picked.setting, 1e30)
    return scalars


def _texts(runs: tuple[Run, ...], wanted: float) -> dict[str, str]:
    closed = done(runs, "closed")
    rows = price_texts(prices(runs, wanted), closed[0].time if closed else None)
    texts = {"wanted": short(wanted)}
    for i, (name, price, ratio) in enumerate(rows):
        texts |= {f"price{i}_name": name, f"price{i}_time": price, f"price{i}_ratio": ratio}
    for i, (name, why) in enumerate(_shortened(stopped(runs))):
        texts |= {f"stopped{i}_name": name, f"stopped{i}_why": why}
    return texts


def _shortened(rows: list[tuple[str, str]]) -> list[tuple[str, str]]:
    return rows if len(rows) <= STOPPED else [*rows[: STOPPED - 1], (f"and {len(rows) - STOPPED + 1} more", "")]


def _forms(view: str, runs: tuple[Run, ...], wanted: float) -> dict[str, str]:
    forms = {view: "shown"}
    forms |= {f"price{i}": "shown" for i in range(len(prices(runs, wanted)))}
    return forms | {f"stopped{i}": "shown" for i in range(len(_shortened(stopped(runs))))}


def system_texts(system: System) -> dict[str, str]:
    """The numbers of the system, for the panel."""
    chain, (slow, fast) = system.chain, system.chain.modes().omega
    texts = {
        "chain": ", ".join(
            f"{name} = {short(value)}" for name, value in vars(chain).items() if name in ("m1", "m2", "k1", "k2")
        )
    }
    return texts | {"ratio": three(fast / slow) if slow else "∞"}
