"""The notebooks run as they are, with the outputs that they show; a scene displays itself in one."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from tests.serving.server import ROOT

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
STEPPED = "against-scipy"
"""Its errors are those of SciPy's on this machine: the last digits of roundings may be others elsewhere."""
# What a kernel's client leaves open at its end, and says of the event loop.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")
SHOWN = """import panel
panel.extension()
from components.scenes import SCENES
SCENES["oscillator"]()"""


def run(notebook: nbformat.NotebookNode, folder: Path) -> str:
    """The text of its outputs."""
    NotebookClient(notebook, timeout=60, resources={"metadata": {"path": str(folder)}}).execute()
    return shown(notebook)


def shown(notebook: nbformat.NotebookNode) -> str:
    """All texts as one: a kernel cuts what is printed where it likes."""
    found = (output for cell in notebook.cells for output in cell.get("outputs", ()))
    return "".join(output.get("text", "") or output.get("data", {}).get("text/plain", "") for output in found)


def test_there_are_three() -> None:
    assert [path.stem for path in NOTEBOOKS] == ["a-scene", "against-scipy", "your-own-system"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_shows_what_it_gives(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    stored = shown(notebook)
    assert stored
    given = run(notebook, path.parent)
    digits = re.compile(r"\d+" if path.stem == STEPPED else "$^")
    assert digits.sub("#", given) == digits.sub("#", stored)


def test_a_scene_displays_itself() -> None:
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(SHOWN)])
    run(notebook, ROOT)
    bundles = [output.get("data", {}) for output in notebook.cells[0].outputs]
    assert any("Slider" in bundle.get("text/html", "") for bundle in bundles)
