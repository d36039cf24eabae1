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
"""Media types by suffix, because the machine's own table may differ."""
VENDOR = Path(__file__).parent / "vendor"
YEAR = 365 * 86400
UNIT = re.compile(r"(?<![\w-])(?:stroke[\w-]*|--u|--least): [^;]*;|(?<![\w#.])(?<!\w-)(?P<px>\d*\.?\d+)px\b")


class Asset(NamedTuple):
    """A file with its headers and encodings."""

    type: str
    plain: bytes
    packed: dict[str, bytes]
    """Contents by the name of the encoding, the best first."""


def folder_of(files: Mapping[str, bytes]) -> str:
    """Return a short hash of files, which names the folder that they are served from."""
    return sha256(b"".join(name.encode() + b"\0" + content for name, content in sorted(files.items()))).hexdigest()[:12]


@cache
def written_files() -> dict[str, bytes]:
    """Return our own files by their path, unchanged except for the style sheet."""
    paths = sorted(path for path in STATIC.rglob("*") if path.is_file() and path.parent != STYLES)
    return {path.relative_to(STATIC).as_posix(): path.read_bytes() for path in paths}


def written_scripts() -> dict[str, str]:
    """Return our own scripts, unchanged."""
    return {name: content.decode() for name, content in written_files().items() if name.endswith(".js")}


@cache
def static_files() -> dict[str, bytes]:
    """Return our own files as they are sent: one style sheet, and the scripts that every page needs in one file."""
    scripts = written_scripts()
    others = {name: content for name, content in written_files().items() if name not in scripts}
    linked = {name: text.encode() for name, text in sent(scripts).items()}
    return {**others, **linked, "style.css": style_sheet()}


def style_sheet() -> bytes:
    """Return the style sheet with its parts in place of their imports, and the additions of single scenes."""
    order = (STYLES / "style.css").read_text("utf-8")
    ours = PART.sub(lambda found: _layer(found[2], STYLES / found[1]), order)
    scenes = (_layer("scenes", path) for path in sorted(SCENES.glob("*/*.css")))
    return in_text_sizes("\n".join([ours, *scenes])).encode()


def _layer(name: str, path: Path) -> str:
    return f"@layer {name} {{\n{path.read_text('utf-8')}}}"


def in_text_sizes(sheet: str) -> str:
    """Return the sheet with each px replaced by 1/16 of the text size, so that everything grows with the text. Lines
    use the units of their SVG.
    """
    return UNIT.sub(lambda found: f"{float(found['px']) / 16:.6g}rem" if found["px"] else found[0], sheet)


@cache
def library_files() -> dict[str, bytes]:
    """Return the scripts of libraries."""
    return {path.name: path.read_bytes() for path in (BOKEH, *sorted(VENDOR.iterdir()))}


@cache
def assets() -> dict[str, Asset]:
    """Return every file that is served, by its address below assets/."""
    kept = {
        f"{folder_of(files)}/{name}": content
        for files in (static_files(), library_files())
        for name, content in files.items()
    }
    return packed_files(kept)


def packed_files(files: Mapping[str, bytes]) -> dict[str, Asset]:
    """Return files as they are sent, by the same addresses."""
    return {name: Asset(TYPES[Path(name).suffix], content, _packed(content)) for name, content in files.items()}


class AssetFiles(LectureHandler):
    """The handler of the static files, and of the extra files `more`."""

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
        """Disable Tornado's ETag, because the address already contains a hash of the content."""


def takes(accepted: str, coding: str) -> bool:
    """Return True if an Accept-Encoding header accepts a coding."""
    for part in accepted.lower().split(","):
        name, _, quality = part.replace(" ", "").partition(";q=")
        if name == coding:
            return not quality or quality.strip("0.") != ""
    return False


def _packed(content: bytes) -> dict[str, bytes]:
    # Level 11 of Brotli would save 8 % more and take 8 s at each start.
    return {"br": brotli.compress(content, quality=9), "gzip": gzip.compress(content, 6, mtime=0)}
