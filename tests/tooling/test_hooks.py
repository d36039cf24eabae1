"""The pre-commit hooks are those of make lint. They run tools of this environment and download nothing."""

from __future__ import annotations

import re
import subprocess
import sys

import yaml

from tests.serving.server import ROOT

CONFIG = ROOT / ".pre-commit-config.yaml"
HOOKS = [hook for repo in yaml.safe_load(CONFIG.read_text(encoding="utf-8"))["repos"] for hook in repo["hooks"]]
IN_PYTHON = "python -m tools"


def test_the_configuration_is_valid() -> None:
    done = subprocess.run([sys.executable, "-m", "pre_commit", "validate-config", str(CONFIG)], check=False)
    assert done.returncode == 0


def test_no_hook_is_downloaded() -> None:
    repos = yaml.safe_load(CONFIG.read_text(encoding="utf-8"))["repos"]
    assert [repo["repo"] for repo in repos] == ["local"]
    assert {hook["language"] for hook in HOOKS} == {"system"}
    assert all(hook["entry"].startswith(".venv/bin/") for hook in HOOKS)


def test_every_linter_of_make_lint_is_a_hook() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    lint = re.findall(r"^lint:.*\n((?:\t.*\n)+)", makefile, re.M)[0]
    asked = {command.split()[0] for command in re.findall(r"\$\(BIN\)/(.*)", lint) if not command.startswith(IN_PYTHON)}
    assert len(asked) >= 4
    assert asked <= {hook["entry"].removeprefix(".venv/bin/").split()[0] for hook in HOOKS}
