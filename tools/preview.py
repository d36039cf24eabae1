"""Pictures of the steps of a walk, and one page with the pictures and the problems of each step.

`make walk FILE=my-walk.toml ARGS=--pictures` writes them to build/walk/my-walk. With `ARGS=--serve` the walk is also
served until Ctrl-C, and the page is opened.
"""

from __future__ import annotations

import re
import webbrowser
from collections.abc import Sequence
from html import escape
from pathlib import Path

from playwright.sync_api import Browser, ViewportSize

from components.walks.walk import Walk
from tools.look import served, shown

BUILD = Path("build") / "walk"
SIZES = {"hall": (1280, 720), "phone": (390, 844)}
PAGE = """<!doctype html><meta charset="utf-8"><title>{title}</title>
<style>
body {{ font: 16px/1.4 sans-serif; margin: 24px }}
section {{ display: flex; gap: 16px; margin: 0 0 32px }}
section > div {{ flex: 0 0 360px }}
img {{ height: 360px; border: 1px solid #ccc }}
</style>
<h1>{title}</h1>
{steps}
"""
STEP = "<section><div><h2>{name}</h2><ul>{problems}</ul></div>{pictures}</section>"


def preview(walk: Walk | None, path: Path, found: Sequence[str], is_served: bool) -> None:
    """Write the page of a walk with its pictures, or without them if the walk cannot be served. Then serve it until
    Ctrl-C."""
    folder = BUILD / path.stem
    folder.mkdir(parents=True, exist_ok=True)
    page = folder / "index.html"
    if walk is None:
        page.write_text(written(path.stem, [], found, ""), encoding="utf-8")
        print(f"Its problems are in {page}. A walk is served once every step can be read.")
        return
    with served(walk, path) as (browser, url):
        photograph(walk, browser, url, folder)
        page.write_text(
            written(walk.title, [step.id for step in walk.steps], found, f"{url}?walk={walk.name}"), encoding="utf-8"
        )
        print(f"{page} has its pictures and problems.")
        if is_served:
            webbrowser.open(page.resolve().as_uri())
            print(f"The walk is at {url}?walk={walk.name} until Ctrl-C.")
            wait()


def wait() -> None:
    """Return when Ctrl-C is pressed."""
    try:
        while input() is not None:
            pass
    except (KeyboardInterrupt, EOFError):
        return


def photograph(walk: Walk, browser: Browser, url: str, folder: Path) -> None:
    """Take pictures of each step, asked and answered, in the hall and on a phone."""
    for size, (width, height) in SIZES.items():
        # Playwright's waiting for an expression is an eval, which the page forbids.
        viewport = ViewportSize(width=width, height=height)
        context = browser.new_context(viewport=viewport, bypass_csp=True, reduced_motion="reduce")
        page = context.new_page()
        page.goto(f"{url}?walk={walk.name}{'&projector' if size == 'hall' else ''}")
        for place, step in enumerate(walk.steps):
            for when in shown(page, place):
                page.screenshot(path=folder / f"{place + 1:02}-{step.id}-{when}-{size}.png")
        context.close()


def written(title: str, ids: Sequence[str], found: Sequence[str], url: str) -> str:
    """Return the page: each step with its problems and pictures, then the problems of no step that is shown."""
    sections, left = [], list(found)
    for place, name in enumerate(ids, 1):
        own = [one for one in left if re.search(rf", step {place}\b", one)]
        left = [one for one in left if one not in own]
        files = [f"{place:02}-{name}-{when}-{size}.png" for when in ("question", "answer") for size in SIZES]
        pictures = "".join(f'<a href="{file}"><img src="{file}" alt=""></a>' for file in files)
        link = f'<a href="{escape(url)}&step={place}">{place}. {escape(name)}</a>'
        sections.append(STEP.format(name=link, problems=_items(own), pictures=pictures))
    if left:
        sections.append(STEP.format(name="All problems" if not ids else "Others", problems=_items(left), pictures=""))
    return PAGE.format(title=escape(title), steps="\n".join(sections))


def _items(sentences: Sequence[str]) -> str:
    return "".join(f"<li>{escape(sentence)}</li>" for sentence in sentences) or "<li>No problem found.</li>"
