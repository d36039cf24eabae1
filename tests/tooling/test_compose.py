"""compose.yaml agrees with the Caddyfile and with the settings of the server."""

import os
import re
import subprocess
import sys
from ipaddress import ip_address, ip_network
from pathlib import Path
from typing import Any

import psutil
import pytest
import redis
import yaml

from components.serving.settings import HINTS, KNOWN, misspelt, read_settings
from tests.deploy.test_proxy import health_check
from tests.live_class.served import valkey_binary
from tests.serving.server import ROOT, free_port, serving

DEPLOYMENT = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text())
SERVICES, NETWORKS = COMPOSE["services"], COMPOSE["networks"]
LECTURE, RELIEF, PROXY, STORE = (SERVICES[name] for name in ("lecture", "relief", "proxy", "store"))


def test_compose_confines_every_container_and_names_existing_settings() -> None:
    for service in SERVICES.values():
        assert service["read_only"] and service["cap_drop"] == ["ALL"] and service["tmpfs"]
        assert {"cpus", "memory", "pids"} == set(service["deploy"]["resources"]["limits"])
        assert service["security_opt"] == ["no-new-privileges:true"]
    assert RELIEF == {**LECTURE, "profiles": ["relief"]} and COMPOSE["name"] == "oscillations"
    assert set(LECTURE["environment"]) <= KNOWN
    assert (LECTURE["volumes"], "walks" in COMPOSE["volumes"]) == (["${WALKS:-walks}:/walks:ro"], True)
    assert LECTURE["deploy"]["replicas"] == PROXY["environment"]["REPLICAS"] == "${REPLICAS:-2}"
    assert "depends_on" not in PROXY, "it keeps running when replicas are replaced"
    assert re.fullmatch(r"[1-9]\d*:[1-9]\d*", STORE["user"]), "the store needs no capability to start"
    assert re.search(r"^exec valkey-server - ", STORE["command"][-1], re.M)
    assert re.findall(r"health_uri (\S+)", (ROOT / "Caddyfile").read_text()) == ["/readiness"]
    images = [service["image"] for service in SERVICES.values() if "build" not in service]
    assert len(images) == 2 and all(re.fullmatch(r"[\w./-]+:[\w.-]+@sha256:[0-9a-f]{64}", name) for name in images)


def test_the_proxy_starts_with_a_secret_and_the_names_of_all_replicas() -> None:
    script = PROXY["command"][-1].replace("$$", "$").replace("exec caddy", "echo $COOKIE_SECRET $UPSTREAMS #")
    started = [
        subprocess.run(["sh", "-c", script], env={"REPLICAS": "2"}, capture_output=True, text=True) for _ in "ab"
    ]
    (secret, *named), (another, *_) = (one.stdout.split() for one in started)
    assert len(secret) == len(another) == 44 and secret != another
    assert named == [f"oscillations-{of}-{i}:5006" for i in (1, 2) for of in ("lecture", "relief")]
    used = set(re.findall(r"\{\$([A-Z_]+)", (ROOT / "Caddyfile").read_text()))
    assert used <= {*PROXY["environment"], "UPSTREAMS", "COOKIE_SECRET"}


def test_every_setting_reaches_the_replicas_or_is_documented_as_fixed() -> None:
    passed = LECTURE["environment"]
    assert {name.upper() for name in HINTS} - set(passed) == {"BOKEH_SECRET_KEY", "REDIS_PASSWORD", "SHOW"}
    fixed = {name: text for name, text in passed.items() if "$" not in text and name != "WALKS"}  # it is mounted
    sentence = re.findall(r"compose\.yaml sets (.*?) itself", DEPLOYMENT.replace("\n", " "))[0]
    assert set(re.findall(r"`(\w+)`", sentence)) == set(fixed)
    read_settings([], {name: text for name, text in fixed.items() if not name.endswith("_FILE")})
    # A misspelt line of .env is reported, a correct one is not.
    assert LECTURE["env_file"] == [{"path": ".env", "required": False}]
    read = {name: "5" for name in re.findall(r"\$\{([A-Z_]+)", (ROOT / "compose.yaml").read_text())}
    assert {"SITE", "REPLICAS", "PROXY_MEMORY", "SESSIONS"} <= set(read)
    assert misspelt({**read, "COMPOSE_PROFILES": "class", "COMPOSE_PROJECT_NAME": "x"}) == []


def test_only_replicas_reach_the_store_and_only_the_proxy_is_public_at_its_own_address() -> None:
    """Visitors over IPv6 keep their addresses if the network of the published ports has IPv6."""
    within = {name: set(service["networks"]) for name, service in SERVICES.items()}
    assert {name for name, of in within.items() if "shared" in of} == {"lecture", "relief", "store"}
    assert {name for name, of in within.items() if "outer" in of} == {"proxy"} and within["store"] == {"shared"}
    assert [NETWORKS[name].get("internal", False) for name in ("outer", "inner", "shared")] == [0, 1, 1]
    assert [name for name, service in SERVICES.items() if "ports" in service] == ["proxy"]
    assert [name for name, network in NETWORKS.items() if network.get("enable_ipv6")] == ["outer"]
    address = PROXY["networks"]["inner"]["ipv4_address"]
    assert address == LECTURE["environment"]["TRUSTED_PROXIES"]
    (pool,) = NETWORKS["inner"]["ipam"]["config"]
    assert ip_address(address) in ip_network(pool["subnet"]) and address != pool["gateway"]
    assert not any(ip_address(of) in ip_network(pool["ip_range"]) for of in (address, pool["gateway"]))


@pytest.mark.skipif(sys.platform == "win32", reason="no sh here")
@pytest.mark.parametrize("given", ["", "CLASS_PASSPHRASE", "CLASS_PASSPHRASE_FILE"])
def test_the_instructors_passphrase_reaches_the_replicas(tmp_path: Path, given: str) -> None:
    """Compose substitutes variables like sh."""
    (tmp_path / "phrase").write_text("a phrase of the class\n")
    outside = {"": {}, "CLASS_PASSPHRASE": {given: "a phrase of the class"}}.get(given, {given: f"{tmp_path}/phrase"})

    def with_variables(text: str) -> str:
        return subprocess.run(["sh", "-c", f'printf %s "{text}"'], env=outside, capture_output=True, text=True).stdout

    mounted = COMPOSE["secrets"]["class_passphrase"]["file"]
    assert "class_passphrase" in LECTURE["secrets"] and Path(with_variables(mounted)).exists()
    environment = {name: with_variables(text) for name, text in LECTURE["environment"].items() if "PASSPHRASE" in name}
    if path := environment["CLASS_PASSPHRASE_FILE"]:
        assert path == "/run/secrets/class_passphrase"
        environment["CLASS_PASSPHRASE_FILE"] = with_variables(mounted)
    assert read_settings([], environment).class_passphrase == ("a phrase of the class" if given else "")


@pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")
def test_the_store_requires_its_password_hides_it_and_refuses_writes_when_full(tmp_path: Path) -> None:
    (tmp_path / "password").write_text("one/of+these=\n")
    port = free_port()
    script = STORE["command"][-1].replace("$$", "$").replace("/run/secrets/store_password", str(tmp_path / "password"))
    script = script.replace("valkey-server -", f"{valkey_binary()} - --port {port}", 1)
    with serving(tmp_path / "log", port=port, command=(*STORE["entrypoint"], script)) as running:
        with redis.Redis(port=port, password="one/of+these=") as client:
            assert client.config_get("maxmemory-policy") == {"maxmemory-policy": "noeviction"}
        healthy = health_check(tmp_path, "store", {"/run/secrets/store_password": f"{tmp_path}/password"})
        assert healthy(6379, port) == 0 and healthy(6379, free_port()) != 0
        (tmp_path / "password").write_text("another\n")
        assert healthy(6379, port) != 0
        with redis.Redis(port=port) as stranger, pytest.raises(redis.exceptions.AuthenticationError):
            stranger.ping()
        assert "one/of+these=" not in " ".join(psutil.Process(running.process.pid).cmdline())


def program(folder: Path, name: str, script: str) -> dict[str, str]:
    """Write a program, and return the environment in which it is the first of this name."""
    (path := folder / name).write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return {**os.environ, "PATH": f"{folder}{os.pathsep}{os.environ['PATH']}"}


def make(folder: Path, target: str, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    command = ["make", "--silent", "--file", str(ROOT / "Makefile"), target]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


@pytest.mark.parametrize("name", ["secret", "store-password"])
def test_secrets_are_never_readable_by_everybody(tmp_path: Path, name: str) -> None:
    program(tmp_path, "setfacl", "exit 1")
    refused = make(tmp_path, name, program(tmp_path, "chown", "exit 1"))
    assert refused.returncode and f"may read the file {name}" in refused.stdout and not (tmp_path / name).exists()
    assert make(tmp_path, name, program(tmp_path, "chown", "exit 0")).returncode == 0
    assert (tmp_path / name).stat().st_mode & 0o077 == 0
    assert len((tmp_path / name).read_text().strip()) == 44


@pytest.mark.parametrize(
    ("fails", "done"),
    [("", ["relief", "lecture", "relief"]), ("relief", ["relief"] * 2), ("lecture", ["relief", "lecture"])],
)
def test_a_failed_upgrade_keeps_the_running_replicas(tmp_path: Path, fails: str, done: list[str]) -> None:
    for name in ("secret", "store-password"):
        (tmp_path / name).touch()
    script = f'echo "$@"\ntest -z "{fails}" || case "$*" in *"--wait {fails}") exit 1;; esac'
    result = make(tmp_path, "upgrade", program(tmp_path, "docker", script))
    assert [line.split()[-1] for line in result.stdout.splitlines() if "--wait" in line or " rm " in line] == done
    assert (result.returncode == 0) == (not fails)
