"""One Panel component shows a scene: the browser draws the sheet, plays the motion and sends what the visitor does.

All that changes goes in one message each way, so a slider costs one round trip, one message and one repaint.
"""

from __future__ import annotations

import csv
import io
import json
from functools import cache
from itertools import zip_longest
from typing import Any, ClassVar

import numpy as np
import param
from panel.custom import JSComponent
from panel.widgets.base import WidgetBase

from components.about import about_wire
from components.axes import Axis
from components.controls import apply_message, params_state
from components.scene import Picture, Scene, static_description
from components.sheet import Block
from components.url import write_query
from components.wire import packed

LOADER = """
export async function render({model}) {
  const {mount} = await import(new URL("assets/main.js", document.baseURI).href)
  return mount(model)
}
"""


class SceneView(WidgetBase, JSComponent):
    """A scene as a Panel widget: its `value` is the parameters that differ from their defaults."""

    _esm = LOADER
    _rename: ClassVar[dict[str, str | None]] = {"value": None}
    value = param.Dict(default={})
    description = param.String(constant=True, doc="The scene's static description, JSON.")
    state = param.Dict(doc="The picture at page open, packed; later ones come as messages.")

    _linked_properties = ()  # the browser sets none of these properties: what it has to say comes as messages

    def __init__(self, scene: Scene, problems: tuple[str, ...] = (), **params: Any) -> None:
        self.scene = scene
        self._errors: dict[str, str] = {}
        self._answering = False
        super().__init__(
            description=description_json(type(scene)),
            state=packed(self.message(problems=list(problems))),
            sizing_mode="stretch_both",
            **params,
        )
        scene.on_picture(self._tell)

    def _process_param_change(self, params: dict[str, Any]) -> dict[str, Any]:
        """Panel's style sheets are left out: nothing is drawn in the component's own shadow root."""
        return super()._process_param_change({name: v for name, v in params.items() if name != "stylesheets"})

    def message(self, **more: Any) -> dict[str, Any]:
        """All that the browser needs to show the scene as it now is."""
        scene = self.scene
        return {
            **picture_wire(type(scene), scene.shown),
            "params": params_state(scene),
            "preset": scene.preset(),
            "here": scene.here(),
            "hidden": list(scene.hidden),
            "errors": self._errors,
            "query": write_query(scene),
            "progress": scene.progress,
            **more,
        }

    def _handle_msg(self, data: object) -> None:
        """Apply what the visitor did and answer, whatever it was: the browser waits for the answer.

        What comes need not be what our page sends; its number goes back only where it is one.
        """
        message = data if isinstance(data, dict) and isinstance(data.get("type"), str) else {}
        number = message.get("number")
        answer = number if isinstance(number, int) else None
        match message:
            case {"type": "csv"}:
                self._send_msg({"file": f"{self.scene.slug}.csv", "text": as_csv(self.scene)})
            case {"type": "about"}:
                self._send_msg({"about": about_wire(self.scene), "answer": answer})
            case _:
                self._take(message)
                self._send_msg(packed(self.message(answer=answer)))

    def _take(self, message: dict[str, Any]) -> None:
        """Do what a message asks, and keep the errors for the answer."""
        self._answering = True
        try:
            self._errors = self._run(message) if message.get("type") == "run" else apply_message(self.scene, message)
        finally:
            self._answering = False
        self.value = {name: v for name, v in self.scene.param.values().items() if v != self.scene.param[name].default}

    def _run(self, message: dict[str, Any]) -> dict[str, str]:
        try:
            self.scene.run(str(message.get("order")))
        except ValueError as error:
            return {"run": str(error)}
        return {}

    def _tell(self, _: Picture) -> None:
        """A change that no message of this page has asked for is sent at once; the others are with the answer."""
        if not self._answering:
            self._send_msg(packed(self.message()))


def as_csv(scene: Scene) -> str:
    """The numbers of all plots, unrounded and in SI units, as columns side by side; the first line is the link."""
    columns = {
        f"{source}.{name}": column for source, data in scene.shown.columns.items() for name, column in data.items()
    }
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow([f"?{write_query(scene)}"])
    writer.writerow(columns)
    writer.writerows(zip_longest(*(column.tolist() for column in columns.values()), fillvalue=""))
    return text.getvalue()


@cache
def description_json(scene: type[Scene]) -> str:
    return json.dumps(static_description(scene))


@cache
def column_axes(scene: type[Scene]) -> dict[tuple[str, str], str]:
    """The axis that each column of each source is drawn on: {(source, column): axis}."""
    axes: dict[tuple[str, str], str] = {}

    def visit(block: Block) -> None:
        for child in block.get("blocks", []):
            visit(child)
        if block["kind"] != "plot":
            return
        for curve in block["curves"]:
            axes[curve["source"], curve["x"]] = block["x"]
            axes[curve["source"], curve["name"]] = block["y"]
        for band in block["bands"]:
            axes[band["source"], block["x_column"]] = block["x"]
            axes[band["source"], band["low"]] = axes[band["source"], band["high"]] = block["y"]

    visit(scene.sheet())
    return axes


def picture_wire(scene: type[Scene], picture: Picture) -> dict[str, Any]:
    """A picture as it is sent: columns as float32 in the unit of the axis they are drawn on."""
    axes = column_axes(scene)
    columns: dict[str, dict[str, np.ndarray]] = {}
    for (source, column), name in axes.items():
        if source in picture.columns and column in picture.columns[source]:
            axis: Axis = picture.axes[name]
            columns.setdefault(source, {})[column] = axis.scaled(picture.columns[source][column])
    return {
        "columns": columns,
        "axes": {name: axis.wire() for name, axis in picture.axes.items()},
        "signals": picture.signals,
        "scalars": picture.scalars,
        "values": picture.values,
        "live": picture.live,
        "forms": picture.forms,
        "notes": list(picture.notes),
    }
