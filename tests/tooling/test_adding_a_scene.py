"""docs/adding-a-scene.md is correct: its code makes a scene that is typed, tested, served and drawn.

The same holds for the second scene, a mass between two walls, which follows that page: one package, one line, its
tests.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.serving.server import ROOT, serving

TUTORIAL = ROOT / "docs" / "adding-a-scene.md"
COPIED = (
    "app.py",
    "reading.py",
    "components",
    "physics",
    "static",
    "tests",
    "pyproject.toml",
    "README.md",
    "docs",
    "tools",
)
TYPES = ".mypy_cache"
"""Cache of the linters; mypy then checks only the new files."""
REGISTRY = "components/scenes/__init__.py"
WALLS = {
    "components/scenes/walls/__init__.py": "scene.py",
    "tests/scenes/test_walls.py": "scene_tests.py",
}
WALLS_IMPORT = "from components.scenes.walls import Walls"
SCREENS = {
    "friction": ("A dashpot takes the energy: the swinging dies out, or never begins", "Heavy", "It creeps back."),
    "walls": ("Between two walls the stiffnesses of both springs add", "Soft", "With a quarter of the stiffness"),
}


def code() -> dict[str, str]:
    """Return the code of the page by file. A block belongs to the file of its last `# name` line."""
    found: dict[str, str] = {}
    name = ""
    for block in re.findall(r"```python\n(.*?)```", TUTORIAL.read_text(encoding="utf-8"), re.S):
        first, _, rest = block.partition("\n")
        if first.startswith("# ") and first.endswith(".py"):
            name, block = first.removeprefix("# "), rest
            found[name] = block
        else:
            found[name] += "\n\n" + block
    return found


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project, extended as the page says."""
    folder = tmp_path_factory.mktemp("project")
    for name in (*COPIED, *(name for name in (TYPES,) if (ROOT / name).exists())):
        here, there = ROOT / name, folder / name
        if here.is_dir():
            shutil.copytree(here, there, ignore=shutil.ignore_patterns("__pycache__", "bench"))
        else:
            shutil.copy(here, there)
    second = {name: (ROOT / "tests/tooling/two_walls" / file).read_text("utf-8") for name, file in WALLS.items()}
    for name, text in (code() | second).items():
        file = folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(registered(text.strip()) if name == REGISTRY else text, encoding="utf-8")
    return folder


def registered(friction: str) -> str:
    """Return the registry with both scenes."""
    text = (ROOT / REGISTRY).read_text(encoding="utf-8")
    text = text.replace("\nSCENES: dict", f"{friction}\n{WALLS_IMPORT}\n\nSCENES: dict")
    assert text.count("        Accuracy,\n") == 1, "the list of scenes ends as it did when this was written"
    return text.replace("        Accuracy,\n", "        Accuracy,\n        Friction,\n        Walls,\n")


def run(project: Path, *command: str) -> str:
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=project, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.timeout(300)  # mypy without a cache
def test_the_code_is_clean_and_typed(project: Path) -> None:
    added = ("components/scenes/friction", "components/scenes/walls")
    run(project, "ruff", "check", *added)
    run(project, "ruff", "format", "--check", *added)
    run(project, "mypy", *added)


def test_the_scenes_pass_their_own_tests_and_those_of_every_scene(project: Path) -> None:
    own = ("tests/scenes/test_friction.py", "tests/scenes/test_walls.py")
    every = ("tests/page/test_names.py", "tests/page/test_session.py", "tests/components/test_frames.py")
    every += (
        "tests/scenes/test_every_scene.py",
        "tests/scenes/test_presets.py",
        "tests/scenes/test_watch.py",
        "tests/scenes/test_grabs.py",
    )
    every += (
        "tests/page/test_opening.py",
        "tests/page/test_predict.py",
        "tests/scenes/test_traces.py",
        "tests/tooling/test_measures.py",
    )
    chosen = "friction or walls or house_rules"
    told = run(project, "pytest", "-q", "-p", "no:cacheprovider", "-k", chosen, *own, *every)
    passed = re.search(r"(\d+) passed", told)
    assert passed and int(passed[1]) >= 20, told


@pytest.mark.browser
@pytest.mark.slow
def test_a_phones_first_screen_shows_everything_their_tasks_name(project: Path, browser: Browser) -> None:
    told = run(
        project, "pytest", "-q", "-p", "no:cacheprovider", "-k", "friction or walls", "tests/browser/test_views.py"
    )
    assert "10 passed" in told, told


@pytest.mark.browser
@pytest.mark.slow
@pytest.mark.parametrize("slug", SCREENS)
def test_the_scene_is_served_and_drawn(slug: str, project: Path, browser: Browser, tmp_path: Path) -> None:
    headline, preset, sentence = SCREENS[slug]
    with serving(tmp_path / "log", folder=project) as server:
        page = browser.new_page(bypass_csp=True)
        faults: list[str] = []
        page.on("console", lambda message: faults.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.goto(f"{server.url}?scene={slug}")
        page.wait_for_function("document.documentElement.dataset.ready === 'true'")
        expect(page.get_by_role("heading", level=1)).to_have_text(headline)
        page.get_by_role("button", name=preset).click()
        expect(page.get_by_text(sentence).first).to_be_visible()
        assert page.evaluate("oscillations.shown.view.columns.time.x.length") > 300
        page.evaluate("oscillations.clock.playing = false, oscillations.clock.seek(oscillations.clock.end)")
        assert not faults, faults
        page.close()
