"""The control panel of one scene on its own page, with the scene behind it."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar

from msgspec import to_builtins
from playwright.sync_api import Page, Route

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.controls import Group
from components.layout.controls import panel as described
from components.layout.sheet import column
from components.quantities.parameters import displacement, mass, stiffness
from components.scene import Picture, Scene
from components.scene.frames import FITTED
from components.serving.assets import TYPES, static_files, written_files
from tests.page.headless_page import Page as SessionPage

HOME = "http://controls.test/"
HTML = """<!DOCTYPE html><html lang="en"><title>Controls</title>
<link rel="stylesheet" href="style.css">
<aside class="panel"></aside>
<script type="module">
  import {Controls} from "./controls/controls.js"
  import {sliderPlace, sliderValue, stepped} from "./controls/scales.js"
  Object.assign(globalThis, {sliderPlace, sliderValue, stepped})
  const take = parameters => send({type: "open", state: {scene: "chain", parameters}})
  const controls = new Controls(document.querySelector("aside"), await describe(), send, take)
  const show = state => controls.update(state)
  async function send(message) { show(await tell(message)) }
  Object.assign(globalThis, {show, release: () => controls.release()})
  show(await tell({type: "set", values: {}}))
  document.documentElement.dataset.ready = "true"
</script></html>"""


class Chain(Scene):
    """A scene with its own rule: k2/m1 is at most 1e6."""

    slug = "chain"
    title = headline = "Chain"
    m1 = mass(2.0, symbol="m_1", tint="m1")
    k2 = stiffness(2.0, symbol="k_2", says="couples the masses. Type any value from 0 up.")
    x1_0 = displacement(1.0, symbol="x_1", tint="m1")
    presets: ClassVar = {"Both": {"m1": 2.0}, "Stiff": {"k2": 50.0}}
    groups = (Group("Chain", (m1, k2)), Group("Start", (x1_0,), "or drag a mass"))

    @classmethod
    def sheet(cls) -> Block:
        return column()

    def picture(self, frame: Frame = FITTED) -> Picture:
        if self.k2 > 1e6 * self.m1:
            raise ValueError("the motion is too fast for a double")
        return Picture(columns={}, axes={})


class Panel:
    """The controls of one scene on their own page; `messages` are those that the page has sent."""

    def __init__(self, page: Page) -> None:
        self.page, self.session_page = page, SessionPage(Chain())
        self.messages: list[dict[str, Any]] = []
        page.expose_function(
            "describe",
            lambda: {
                "panel": to_builtins(
                    described(Chain.param.objects("existing"), Chain.groups, presets=Chain.presets),
                ),
                "views": [],
            },
        )
        page.expose_function("tell", self.tell)
        page.route("**/*", self.serve)
        page.goto(HOME)
        page.wait_for_selector("html[data-ready=true]")
        self.messages.clear()

    @property
    def scene(self) -> Chain:
        scene = self.session_page.scene
        assert isinstance(scene, Chain)
        return scene

    def serve(self, route: Route) -> None:
        name = route.request.url.removeprefix(HOME)
        if name:
            suffix = Path(name).suffix
            route.fulfill(body={**static_files(), **written_files()}[name], content_type=TYPES[suffix])
        else:
            route.fulfill(body=HTML, content_type="text/html")

    def tell(self, message: dict[str, Any]) -> dict[str, Any]:
        self.messages.append(message)
        return self.session_page.send(message)

    def field(self, name: str) -> Any:
        return self.page.locator(f'input[name="{name}"]')

    def slider(self, name: str) -> Any:
        return self.page.locator(f'input[name="{name}-slider"]')

    def problem(self, name: str) -> Any:
        return self.page.locator(f"#problem-{name}")

    def type(self, name: str, text: str) -> None:
        self.field(name).fill(text)
        self.field(name).press("Enter")
