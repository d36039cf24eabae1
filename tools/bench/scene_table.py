"""A table with a row for each scene, measured in Chromium on a server that is started for it."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from components.scenes import SCENES
from tests.serving.server import Server
from tools.bench.load import REPORT, machine
from tools.browsers.chromium import find


def report(
    name: str,
    title: str,
    columns: tuple[str, ...],
    row: Callable[[Browser, Server, str], str],
    serve: Callable[[Path], AbstractContextManager[Server]],
) -> None:
    """Print the table and write it to build/load/NAME.md. The option `--scene` chooses one scene."""
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--scene", choices=SCENES, help="only this scene")
    slugs = [only] if (only := parser.parse_args().scene) else list(SCENES)
    file = REPORT.with_name(f"{name}.md")
    file.parent.mkdir(parents=True, exist_ok=True)
    with serve(file.with_suffix(".log")) as server, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find())
        rows = [row(browser, server, slug) for slug in slugs]
        browser.close()
    head = [f"| scene | {' | '.join(columns)} |", "|---" * (1 + len(columns)) + "|"]
    text = "\n".join([machine(), "", *head, *rows, ""])
    file.write_text(text, encoding="utf-8")
    print(text)
