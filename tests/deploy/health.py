"""The health checks of compose.yaml, run as a container engine runs them."""

import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import yaml

from tests.serving.server import ROOT

NC = """#!{python}
import socket, sys
with socket.create_connection((sys.argv[3], int(sys.argv[4])), float(sys.argv[2])) as peer:
    peer.sendall(sys.stdin.buffer.read())
    while got := peer.recv(4096):
        sys.stdout.buffer.write(got)
"""
"""The part of nc that the checks use: nc -w SECONDS HOST PORT."""


def health_check(folder: Path, service: str, instead: Mapping[str, str] | None = None) -> Callable[[int, int], int]:
    """Return a function that runs a service's check at another port, with other paths, and returns its exit code."""
    compose = yaml.safe_load((ROOT / "compose.yaml").read_text(encoding="utf-8"))
    kind, command = compose["services"][service]["healthcheck"]["test"]
    assert kind == "CMD-SHELL"
    for name, other in (instead or {}).items():
        assert name in command
        command = command.replace(name, other)
    (nc := folder / "nc").write_text(NC.format(python=sys.executable))
    nc.chmod(0o755)
    environment = {**os.environ, "PATH": f"{folder}{os.pathsep}{os.environ['PATH']}"}

    def run(port: int, other: int) -> int:
        assert f"127.0.0.1 {port} " in command
        there = command.replace("$$", "$").replace(f"127.0.0.1 {port} ", f"127.0.0.1 {other} ")
        return subprocess.run(["sh", "-c", there], env=environment, stderr=subprocess.DEVNULL).returncode

    return run
