"""The static files: in memory, compressed once at start, under names that change with their content.

A browser keeps such a file for good and never asks whether it has changed; a page and its scripts are of one version.
"""

from __future__ import annotations

import gzip
import re
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import bokeh.server
import brotli

from components.serving.handlers import LectureHandler, RefusedError
from components.serving.scripts import sent

STATIC = Path(__file__).parents[2] / "static"
STYLES = STATIC / "styles"
SCENES = Path(__file__).parents[1] / "scenes"
PART = re.compile(r'@import url\("([\w-]+\.css)"\) layer\((\w+)\);')
BOKEH = Path(bokeh.server.__file__).parent / "static/js/bokeh.min.js"
TYPES = {
    ".css": "text/css; charset=utf-8",
    ".csv": "text/csv; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
    ".woff": "font/woff",
    ".woff2": "font/woff2",
}
"""Media types by suffix; the machine's own table may differ."""
VENDOR = Path(__file__).parent / "vendor"
YEAR = 365 * 86400
UNIT = re.compile(r"(?<![\w-])(?:stroke[\w-]*|--u|--least): [^;]*;|(?<![\w#.])(?<!\w-)(?P<px>\d*\.?\d+)px\b")


class Asset(NamedTuple):
    """A file ready to send."""

    type: str
    plain: bytes
    packed: dict[str, bytes]
    """Contents by the name of the coding, the best first."""


def folder_of(files: Mapping[str, bytes]) -> str:
    """A short hash of files, as the name of the folder they are served from."""
    return sha256(b"".join(name.encode() + b"\0" + content for name, content in sorted(files.items()))).hexdigest()[:12]


@cache
def written_files() -> dict[str, bytes]:
    """Our own files by their path, as they were written, but for the style sheet."""
    paths = sorted(path for path in STATIC.rglob("*") if path.is_file() and path.parent != STYLES)
    return {path.relative_to(STATIC).as_posix(): path.read_bytes() for path in paths}


def written_scripts() -> dict[str, str]:
    """Our own scripts as they were written."""
    return {name: content.decode() for name, content in written_files().items() if name.endswith(".js")}


@cache
def static_files() -> dict[str, bytes]:
    """Our own files as they are sent: the style sheet in one, and the scripts that every page needs."""
    scripts = written_scripts()
    others = {name: content for name, content in written_files().items() if name not in scripts}
    linked = {name: text.encode() for name, text in sent(scripts).items()}
    return {**others, **linked, "style.css": style_sheet()}


def style_sheet() -> bytes:
    """The style sheet with its parts in the places of their imports, and what single scenes add to it."""
    order = (STYLES / "style.css").read_text("utf-8")
    ours = PART.sub(lambda found: _layer(found[2], STYLES / found[1]), order)
    scenes = (_layer("scenes", path) for path in sorted(SCENES.glob("*/*.css")))
    return in_text_sizes("\n".join([ours, *scenes])).encode()


def _layer(name: str, path: Path) -> str:
    return f"@layer {name} {{\n{path.read_text('utf-8')}}}"


def in_text_sizes(sheet: str) -> str:
    """A px of the sheets is a sixteenth of the size of text, so that all grows with it; lines are drawn in the units of
    their SVG."""
    return UNIT.sub(lambda found: f"{float(found['px']) / 16:.6g}rem" if found["px"] else found[0], sheet)


@cache
def library_files() -> dict[str, bytes]:
    """The scripts of others."""
    return {path.name: path.read_bytes() for path in (BOKEH, *sorted(VENDOR.iterdir()))}


@cache
def assets() -> dict[str, Asset]:
    """Every file that is served, by its address below assets/."""
    kept = {
        f"{folder_of(files)}/{name}": content
        for files in (static_files(), library_files())
        for name, content in files.items()
    }
    return packed_files(kept)


def packed_files(files: Mapping[str, bytes]) -> dict[str, Asset]:
    """Files as they are sent, by the same addresses."""
    return {name: Asset(TYPES[Path(name).suffix], content, _packed(content)) for name, content in files.items()}


class AssetFiles(LectureHandler):
    """The handler of the static files, and of `more` that the page brings along."""

    def initialize(self, more: Mapping[str, Asset]) -> None:
        self._more = more

    def get(self, name: str) -> None:
        asset = assets().get(name) or self._more.get(name)
        if asset is None:
            raise RefusedError(
                404, "This file belongs to another version of the page; reload the page to get the right one."
            )
        self.set_header("Content-Type", asset.type)
        self.set_header("Cache-Control", f"public, max-age={YEAR}, immutable")
        self.set_header("Vary", "Accept-Encoding")
        accepted = self.request.headers.get("Accept-Encoding", "")
        coding = next((name for name in asset.packed if takes(accepted, name)), "")
        if coding:
            self.set_header("Content-Encoding", coding)
        self.write(asset.packed[coding] if coding else asset.plain)

    head = get

    def compute_etag(self) -> None:
        """Disable Tornado's ETag: the address has the hash of the content already."""


def takes(accepted: str, coding: str) -> bool:
    """Return True if an Accept-Encoding header accepts a coding."""
    for part in accepted.lower().split(","):
        name, _, quality = part.replace(" ", "").partition(";q=")
        if name == coding:
            return not quality or quality.strip("0.") != ""
    return False


def _packed(content: bytes) -> dict[str, bytes]:
    # Brotli's 11 would save 8 % more and take 8 s at each start.
    return {"br": brotli.compress(content, quality=9), "gzip": gzip.compress(content, 6, mtime=0)}
