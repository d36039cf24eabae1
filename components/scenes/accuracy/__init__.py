"""Accuracy: the scene of error against run time, method by method, measured on the server as the visitor looks on."""

from __future__ import annotations

from functools import cache

import param

from components import chain
from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.quantities.axes import Axis, log_axis, nice_axis
from components.quantities.parameters import angular_frequency, force, one_of, positive
from components.scene import Picture, Scene
from components.scene.frames import FITTED, framed
from components.scene.traces import Columns
from components.scenes.accuracy.data import (
    ALONE,
    MORE,
    Known,
    chosen,
    compiled_only,
    done,
    growth,
    kept,
    picked_run,
    reached_text,
    shown_methods,
    work,
)
from components.scenes.accuracy.measurement import SCALE, Measurement, known
from components.scenes.accuracy.plots import line_ends
from components.scenes.accuracy.prices import PriceRow, power, price_forms, price_list, price_texts, time_text
from components.scenes.accuracy.recorded import recorded, records
from components.scenes.accuracy.sheet import VIEWS, compared_text, paper, system_texts
from components.scenes.accuracy.studies import (
    digits_columns,
    digits_texts,
    length_columns,
    stability,
    step_explosion,
    study_axes,
)
from components.scenes.accuracy.watch import WATCH
from physics.accuracy import SYSTEMS, Run, System, entered
from physics.price import LEAST
from physics.solvers import METHODS

OWN = "own"
ERROR = log_axis(LEAST, 10.0, "", 3)
"""The axis of errors, whatever of."""
_ORIGINS = {(True, True): "both", (True, False): "here", (False, True): "before", (False, False): "none"}


class Accuracy(Scene):
    slug = "accuracy"
    title = "Accuracy"
    lecture = "Numerics"
    points = "beyond the slides"
    headline = "Stepping pays for digits; the formula does not"
    equations = chain.DRIVEN
    work = Measurement
    physical = ("system",)
    shares = chain.SHARES
    sharing = {"system": OWN}
    start = "System"
    watch = WATCH
    presets = {
        **{system.name: {"system": slug} for slug, system in SYSTEMS.items()},
        "From a link": {"system": OWN},
    }
    groups = (
        Group("Run", ("wanted", "limit")),
        Group("Time of the steps", ("clock",), form="time"),
        Group("× closed form", ("unit",), form="time"),
        Group("Compared at", ("equal",), form="growth"),
        Group("", ("cost",), form="cost"),
    )

    system = one_of(default="benign", objects=[*SYSTEMS, OWN], label="System")
    wanted = positive(
        1e-6,
        symbol="error",
        unit="",
        label="error",
        softbounds=(1e-15, 1.0),
        scale="log",
        says="is the accepted error. The list says what it costs.",
    )
    limit = positive(
        1.0,
        symbol="limit",
        unit="s",
        label="time limit of a run",
        softbounds=(0.2, 5.0),
        bounds=(0.01, 60.0),
        inclusive_bounds=(True, True),
        allowed="the time limit of a run is 0.01 to 60 s",
        says="is the time limit per run. Slower methods are listed with the reason why they stopped.",
    )
    cost = positive(
        0.1,
        symbol="cost",
        unit="s",
        label="run time",
        softbounds=(1e-3, 1.0),
        scale="log",
        says="is the run time that every method may spend where they are compared at equal cost.",
    )
    equal = one_of(default="error", objects={"Equal error": "error", "Equal cost": "cost"}, label="Compared at")
    clock = one_of(default="python", objects={"In Python": "python", "Compiled": "compiled"}, label="Time of the steps")
    unit = one_of(
        default="app", objects={"As the app runs it": "app", "In doubles": "doubles"}, label="Closed form compared with"
    )
    view = one_of(default="time", objects=list(VIEWS), label="View")
    picked = param.List(
        default=["rec_verlet", "5"], item_type=str, doc="The run picked: source and place among its points."
    )
    hidden = param.List(default=[MORE], item_type=str, doc="The curves switched off, by group.")
    m1, m2, k1, k2 = chain.masses_and_springs(1.0, 1.0, 1.0, 1.0)
    x1_0, x2_0 = chain.start_positions(1.0)
    v1_0, v2_0 = chain.start_velocities()
    F_0 = force(0.0)
    omega = angular_frequency(1.0)
    measured = param.Parameter(default=None, doc="The measurement that the page has asked for, as far as it has come.")

    @classmethod
    @cache
    def sheet(cls) -> Block:
        return paper()

    def shown_system(self) -> System:
        if self.system != OWN:
            return SYSTEMS[self.system]
        x_0, v_0 = chain.start_of(self)
        own = {"chain": chain.of_scene(self), "x_0": x_0, "v_0": v_0, "F_0": self.F_0, "omega": self.omega}
        system = System(slug=OWN, name="Own", **own)
        system.problem()
        return system

    def picture(self, frame: Frame = FITTED) -> Picture:
        system, measured = self.shown_system(), known(self)
        drawn = compiled_only(measured) if self.clock == "compiled" else measured
        methods, picked = shown_methods(self.hidden), picked_run(drawn, self.picked)
        axes = framed(frame, {**study_axes(system.unit), **_axes(self.limit, picked)})
        time, error = axes["time"], axes["error"]
        curves, rows = work(drawn), price_list(measured, methods, self.wanted, self.unit)
        racing = entered(system, methods)
        compared = chosen(measured, racing, self.equal, self.wanted, self.cost)
        return Picture(
            columns={**curves, "kept": kept(picked), **self._view_columns(system, compared)},
            axes=axes,
            scalars={
                **line_ends(_named(curves, methods), time, error),
                "wanted_at": error.place(self.wanted),
                "rounding_at": error.place(2.0**-53),
                "limit_at": time.place(self.limit),
                "empty": float(not measured.here.every and not measured.before.every),
                **_picked_scalars(picked, time, error, system),
                **_stiff_scalars(drawn, methods, time, error),
            },
            values={
                **price_texts(rows),
                **self._texts(system, [METHODS[slug].mark for slug in racing if slug not in compared]),
                "picked": reached_text(picked) if picked else "",
            },
            forms={
                self.view: "shown",
                **price_forms(rows, measured),
                **{name: "shown" for name, there in self._there(rows, picked) if there},
                "origin": _ORIGINS[bool(measured.here.every), bool(measured.before.every)],
            },
        )

    def _there(self, rows: list[PriceRow], picked: Run | None) -> tuple[tuple[str, bool], ...]:
        """The parts of the sheet that stand on a condition, and whether they do."""
        unsteady = any("±" in cell for _, cells in rows for cell in cells)
        cost = (self.view, self.equal) == ("growth", "cost")
        return (
            ("compiled", self.clock == "compiled"),
            ("costs", bool(rows)),
            ("unsteady", unsteady),
            ("kept", picked is not None and bool(picked.error_growth)),
            ("cost", cost),
        )

    def _view_columns(self, system: System, compared: dict[str, Run]) -> dict[str, Columns]:
        """The columns of the other views, while they are seen."""
        return {
            **(growth(compared) if self.view == "growth" else {}),
            **(length_columns() if self.view == "length" else {}),
            **(digits_columns() if self.view == "digits" else {}),
            "stability": stability() if self.view == "stability" else {},
            "explosion": step_explosion(system.chain) if self.view == "stability" else {},
        }

    def _texts(self, system: System, missing: list[str]) -> dict[str, str]:
        texts = {"wanted": power(self.wanted), "limit": time_text(self.limit), **system_texts(system)}
        record = records(system.slug) or recorded(SCALE)
        texts["origin"], texts["recorded_limit"] = record.origin, time_text(record.seconds)
        texts["length_origin"] = recorded("length").origin
        texts["compared"] = compared_text(self.equal, self.wanted, self.cost)
        texts["missing"] = f"Not so far: {', '.join(missing)}." if missing else ""
        return {**texts, **(digits_texts(self.wanted) if self.view == "digits" else {})}


def _named(curves: dict[str, Columns], methods: tuple[str, ...]) -> dict[str, Columns]:
    """The line of each method that is seen, if it has one, at the end of which its name stands."""
    return {slug: line for slug in methods if (line := curves[slug] or curves[ALONE + slug])}


def _axes(limit: float, picked: Run | None) -> dict[str, Axis]:
    levels = picked.error_growth if picked else ()
    worst = 100 * max(levels) if levels else 1.0
    return {
        "time": log_axis(3e-5, max(2 * limit, 3.0), "s", 3),
        "error": ERROR,
        "percent": nice_axis(0.0, max(worst, 1e-14), "%", 2),
        "error_growth": ERROR,
        "energy_growth": ERROR,
    }


def _stiff_scalars(drawn: Known, methods: tuple[str, ...], time: Axis, error: Axis) -> dict[str, float]:
    """The first run of LSODA that takes most of its steps by the formulas for stiff equations."""
    runs = done(drawn.of("lsoda")) if "lsoda" in methods else []
    run = next((run for run in runs if run.stiff_share > 0.5), None)
    if run is None:
        return {}
    reached = error.place(max(run.error or 0.0, LEAST))
    return {"stiff": 1.0, "stiff_at": time.place(run.time or 0.0), "stiff_error": reached}


def _picked_scalars(picked: Run | None, time: Axis, error: Axis, system: System) -> dict[str, float]:
    if picked is None or picked.time is None or picked.error is None:
        return {}
    scalars = {
        "picked": 1.0,
        "picked_at": time.place(picked.time),
        "picked_error": error.place(max(picked.error, LEAST)),
    }
    if picked.family == "fixed":
        problem = system.problem()
        scalars["step_at"] = min(problem.spacing * problem.rates[1] / picked.setting, 1e30)
    return scalars
