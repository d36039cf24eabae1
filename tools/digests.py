"""`make digests` pins the images of compose.yaml and of the Dockerfile again: each name gets the digest that its
registry has for it today."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

IMAGE = re.compile(r"^((?: +image: |ARG BASE=))([\w./-]+:[\w.-]+)(?:@sha256:[0-9a-f]{64})?$", re.M)
"""A line of a recipe with an image that has a tag: the text before it, its name, its digest."""
ASK = ("docker", "buildx", "imagetools", "inspect", "--format", "{{.Manifest.Digest}}")


def digest(image: str) -> str:
    """Return the digest of an image from its registry. Raises RuntimeError with Docker's message if that fails."""
    asked = subprocess.run([*ASK, image], capture_output=True, text=True)
    found = asked.stdout.strip()
    if not re.fullmatch("sha256:[0-9a-f]{64}", found):
        raise RuntimeError(f"{image}: {asked.stderr.strip() or 'there is no digest'}")
    return found


def pin(folder: Path) -> None:
    """Write the digests into the recipes of a folder; if one cannot be found, write none."""
    texts = {path: path.read_text(encoding="utf-8") for path in (folder / "compose.yaml", folder / "Dockerfile")}
    for path, text in texts.items():
        texts[path] = IMAGE.sub(lambda line: f"{line[1]}{line[2]}@{digest(line[2])}", text)
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    try:
        pin(Path())
    except (OSError, RuntimeError) as refusal:
        sys.exit(f"The digests stay as they are: {refusal}")
