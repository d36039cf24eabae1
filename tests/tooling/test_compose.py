"""The containers together: what compose.yaml says of them agrees with the proxy's recipe and with the settings."""

from __future__ import annotations

import os
import re
import subprocess
from ipaddress import ip_address, ip_network
from pathlib import Path
from typing import Any

import pytest
import yaml

from components.serving.settings import HINTS, SECRET_FILE
from tests.serving.server import ROOT

COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text())


def test_compose_confines_every_container_and_names_settings_that_there_are() -> None:
    for service in COMPOSE["services"].values():
        assert service["read_only"] and service["cap_drop"] == ["ALL"] and service["tmpfs"]
        assert {"cpus", "memory", "pids"} == set(service["deploy"]["resources"]["limits"])
        assert service["security_opt"] == ["no-new-privileges:true"]
    lecture, relief, proxy = (COMPOSE["services"][name] for name in ("lecture", "relief", "proxy"))
    assert relief == {**lecture, "profiles": ["relief"]} and COMPOSE["name"] == "oscillations"
    script = proxy["command"][-1].replace("$$", "$").replace("exec caddy", "echo $UPSTREAMS #")
    named = subprocess.run(["sh", "-c", script], env={"REPLICAS": "2"}, capture_output=True, text=True)
    assert named.stdout.split() == [f"oscillations-{of}-{i}:5006" for i in (1, 2) for of in ("lecture", "relief")]
    assert set(lecture["environment"]) <= {name.upper() for name in HINTS} | {SECRET_FILE}
    assert (lecture["volumes"], "walks" in COMPOSE["volumes"]) == (["${WALKS:-walks}:/walks:ro"], True)
    assert lecture["deploy"]["replicas"] == proxy["environment"]["REPLICAS"] == "${REPLICAS:-2}"
    used = set(re.findall(r"\{\$([A-Z_]+)", (ROOT / "Caddyfile").read_text()))
    assert used <= {*proxy["environment"], "UPSTREAMS", "COOKIE_SECRET"}


def test_no_container_is_given_the_address_of_the_proxy() -> None:
    lecture, proxy = (COMPOSE["services"][name] for name in ("lecture", "proxy"))
    address = proxy["networks"]["inner"]["ipv4_address"]
    assert address == lecture["environment"]["TRUSTED_PROXIES"]
    (pool,) = COMPOSE["networks"]["inner"]["ipam"]["config"]
    assert ip_address(address) in ip_network(pool["subnet"]) and address != pool["gateway"]
    assert not any(ip_address(of) in ip_network(pool["ip_range"]) for of in (address, pool["gateway"]))


def test_the_proxy_stays_where_replicas_are_replaced() -> None:
    assert "depends_on" not in COMPOSE["services"]["proxy"]


def test_the_store_needs_no_capability_to_start() -> None:
    store = COMPOSE["services"]["store"]
    assert re.fullmatch(r"[1-9]\d*:[1-9]\d*", store["user"]) and store["entrypoint"][0] == "valkey-server"


@pytest.mark.parametrize("fails", ["", "relief", "lecture"])
def test_an_upgrade_that_does_not_come_up_leaves_who_serves(tmp_path: Path, fails: str) -> None:
    (tmp_path / "secret").touch()
    engine = tmp_path / "docker"
    engine.write_text(f'#!/bin/sh\necho "$@"\ntest -z "{fails}" || case "$*" in *"--wait {fails}") exit 1;; esac\n')
    engine.chmod(0o755)
    command = ["make", "--silent", "--file", str(ROOT / "Makefile"), "upgrade"]
    environment = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    result = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    done = [line.split()[-1] for line in result.stdout.splitlines() if "--wait" in line or " rm " in line]
    assert (result.returncode == 0) == (not fails)
    assert (
        done == {"": ["relief", "lecture", "relief"], "relief": ["relief"] * 2, "lecture": ["relief", "lecture"]}[fails]
    )
