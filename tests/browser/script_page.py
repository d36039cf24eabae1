"""A page that imports our scripts and nothing else, for tests of what they export."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, Route

from components.serving.assets import TYPES, written_files

HOME = "http://scripts.test/"


def serve(route: Route, html: str) -> None:
    """Our static files by their path, and the page itself."""
    name = route.request.url.removeprefix(HOME)
    if name:
        route.fulfill(body=written_files()[name], content_type=TYPES[Path(name).suffix])
    else:
        route.fulfill(body=html, content_type="text/html")


class Scripts:
    """The exports of modules by path in a browser, to be called with JSON: `ruler.toSI` of "core/ruler"."""

    def __init__(self, browser: Browser, modules: Iterable[str]) -> None:
        self.context = browser.new_context()
        self.page: Page = self.context.new_page()
        self.faults: list[str] = []
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.on("console", lambda said: self.faults.extend([said.text] if said.type == "error" else []))
        imports = "".join(f'import * as {Path(path).name} from "./{path}.js"\n' for path in modules)
        body = f"{imports}Object.assign(globalThis, {{{', '.join(Path(path).name for path in modules)}}})\n"
        html = f"""<!DOCTYPE html><link rel="icon" href="data:,"><script type="module">
        {body}document.documentElement.dataset.ready = "true"</script>"""
        self.page.route("**/*", lambda route: serve(route, html))
        self.page.goto(HOME)
        self.page.wait_for_selector("html[data-ready=true]", state="attached")

    def call(self, function: str, *arguments: object) -> Any:
        return self.page.evaluate(f"given => {function}(...given)", list(arguments))

    def each(self, function: str, cases: Iterable[Iterable[object]]) -> list[Any]:
        """The results for many cases, in one go."""
        return self.page.evaluate(f"cases => cases.map(given => {function}(...given))", [list(one) for one in cases])
