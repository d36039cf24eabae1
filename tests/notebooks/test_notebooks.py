"""The notebooks run and show the stored outputs, with their figures; a scene displays itself in a notebook."""

import re
from pathlib import Path
from typing import Any

import pytest

from tests.grids import sample
from tests.serving.server import ROOT

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
STEPPED = "against-scipy"
"""Its digits are not compared: the rounding errors of SciPy differ between machines."""
# Warnings about what a kernel's client leaves open when it ends.
pytestmark = pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::DeprecationWarning")
FIGURES = {"a-scene": "panel.models.widgets.Player", "a-sweep": "Figure"}
"""The model that is stored with a notebook, so that its figures are readable without running anything."""


def shown(notebook: Any, kind: str = "text/plain") -> str:
    """Join all outputs of a kind: a kernel splits printed text arbitrarily."""
    found = (output for cell in notebook.cells for output in cell.get("outputs", ()))
    return "".join(output.get("text", "") or output.get("data", {}).get(kind, "") for output in found)


@pytest.mark.parametrize("path", sample(NOTEBOOKS, 6), ids=lambda path: path.stem)
def test_a_notebooks_stored_outputs_are_current(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))  # as if the lecture were installed, which the notebooks expect
    # Importing this compiles grammars for two seconds, so it happens only when the test runs.
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(path, as_version=4)
    stored = shown(notebook)
    assert stored and rf"\"name\":\"{FIGURES.get(path.stem, '')}" in path.read_text("utf-8")
    NotebookClient(notebook, timeout=60, resources={"metadata": {"path": str(path.parent)}}).execute()
    assert path.stem != "a-scene" or "Slider" in shown(notebook, "text/html")
    digits = re.compile(r"\d+" if path.stem == STEPPED else "$^")
    assert digits.sub("#", shown(notebook)) == digits.sub("#", stored)
