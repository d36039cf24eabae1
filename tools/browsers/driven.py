"""A browser window that is driven by WebDriver commands, with the methods of Playwright's `Page` that the journey
needs.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from base64 import b64decode
from collections.abc import Mapping
from pathlib import Path
from typing import Any

PATIENCE = 60.0  # seconds
LOOK = 0.1  # seconds
KEYS = {
    "Shift": "\ue008",
    "Control": "\ue009",
    "Enter": "\ue007",
    "Tab": "\ue004",
    "Escape": "\ue00c",
    "Backspace": "\ue003",
    "PageUp": "\ue00e",
    "PageDown": "\ue00f",
    "End": "\ue010",
    "Home": "\ue011",
    "ArrowLeft": "\ue012",
    "ArrowUp": "\ue013",
    "ArrowRight": "\ue014",
    "ArrowDown": "\ue015",
}
"""Names of keys in Playwright and on the page, with their codes in WebDriver."""


class DrivenWindow(ABC):
    """One window; subclasses carry the commands of WebDriver to a browser."""

    def __init__(self) -> None:
        self.mouse = Mouse(self)
        self.keyboard = Keyboard(self)

    @abstractmethod
    def do(self, command: str, **given: object) -> Any:
        """Return the result of a command of WebDriver, by its name in Marionette: `Navigate`."""

    @abstractmethod
    def close(self) -> None:
        """End the browser."""

    def goto(self, address: str) -> None:
        self.do("Navigate", url=address)

    def reload(self) -> None:
        self.do("Refresh")

    def set_viewport_size(self, size: Mapping[str, int]) -> None:
        for _ in range(2):
            frame = self.evaluate("[outerWidth - innerWidth, outerHeight - innerHeight]")
            self.do("SetWindowRect", width=size["width"] + frame[0], height=size["height"] + frame[1])

    def evaluate(self, script: str, arg: object = None) -> Any:
        """Return the value of an expression; a promise is awaited, a function is called with `arg`."""
        body = f"""const [given, done] = arguments
        Promise.resolve().then(() => {{
          const value = ({script})
          return typeof value === "function" ? value(given) : value
        }}).then(value => done([value ?? null]), error => done([null, String(error)]))"""
        # A page that is being left does not answer; the next one is asked.
        while (answer := self.do("ExecuteAsyncScript", script=body, args=[arg])) is None:
            time.sleep(LOOK)
        value, *error = answer
        if error:
            raise RuntimeError(error[0])
        return value

    def wait_for_function(self, script: str, arg: object = None) -> None:
        end = time.monotonic() + PATIENCE
        true = f"""given => {{
          const value = ({script})
          return Promise.resolve(typeof value === "function" ? value(given) : value).then(Boolean)
        }}"""
        while not self.evaluate(true, arg):
            if time.monotonic() > end:
                raise TimeoutError(script)
            time.sleep(LOOK)

    def screenshot(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b64decode(self.do("TakeScreenshot")))

    def act(self, kind: str, *actions: dict[str, object], **source: object) -> None:
        """Perform actions of one input device: "pointer" or "key"."""
        self.do("PerformActions", actions=[{"type": kind, "id": kind, "actions": actions, **source}])


class Mouse:
    """The mouse of a window, in pixels of the page."""

    def __init__(self, window: DrivenWindow) -> None:
        self._window = window

    def move(self, x: float, y: float) -> None:
        self._act({"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0})

    def down(self) -> None:
        self._act({"type": "pointerDown", "button": 0})

    def up(self) -> None:
        self._act({"type": "pointerUp", "button": 0})

    def _act(self, action: dict[str, object]) -> None:
        self._window.act("pointer", action, parameters={"pointerType": "mouse"})


class Keyboard:
    """The keys of a window: characters, or the names in `KEYS`."""

    def __init__(self, window: DrivenWindow) -> None:
        self._window = window

    def press(self, key: str) -> None:
        value = KEYS.get(key, key)
        self._window.act("key", {"type": "keyDown", "value": value}, {"type": "keyUp", "value": value})

    def type(self, text: str) -> None:
        for sign in text:
            self.press(sign)
