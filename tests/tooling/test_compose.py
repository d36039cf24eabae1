"""compose.yaml agrees with the Caddyfile and with the settings of the server."""

from __future__ import annotations

import os
import re
import shutil
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
from tests.deploy.health import health_check
from tests.live_class.stores import valkey_binary
from tests.serving.server import ROOT, free_port, serving
from tools.digests import pin

DEPLOYMENT = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text())


def test_compose_confines_every_container_and_names_existing_settings() -> None:
    for service in COMPOSE["services"].values():
        assert service["read_only"] and service["cap_drop"] == ["ALL"] and service["tmpfs"]
        assert {"cpus", "memory", "pids"} == set(service["deploy"]["resources"]["limits"])
        assert service["security_opt"] == ["no-new-privileges:true"]
    lecture, relief, proxy = (COMPOSE["services"][name] for name in ("lecture", "relief", "proxy"))
    assert relief == {**lecture, "profiles": ["relief"]} and COMPOSE["name"] == "oscillations"
    script = proxy["command"][-1].replace("$$", "$").replace("exec caddy", "echo $COOKIE_SECRET $UPSTREAMS #")
    started = [
        subprocess.run(["sh", "-c", script], env={"REPLICAS": "2"}, capture_output=True, text=True) for _ in "ab"
    ]
    (secret, *named), (another, *_) = (one.stdout.split() for one in started)
    assert len(secret) == len(another) == 44 and secret != another
    assert named == [f"oscillations-{of}-{i}:5006" for i in (1, 2) for of in ("lecture", "relief")]
    assert set(lecture["environment"]) <= KNOWN
    assert (lecture["volumes"], "walks" in COMPOSE["volumes"]) == (["${WALKS:-walks}:/walks:ro"], True)
    assert lecture["deploy"]["replicas"] == proxy["environment"]["REPLICAS"] == "${REPLICAS:-2}"
    used = set(re.findall(r"\{\$([A-Z_]+)", (ROOT / "Caddyfile").read_text()))
    assert used <= {*proxy["environment"], "UPSTREAMS", "COOKIE_SECRET"}


def test_every_setting_reaches_the_replicas_or_is_documented_as_fixed() -> None:
    passed = COMPOSE["services"]["lecture"]["environment"]
    assert {name.upper() for name in HINTS} - set(passed) == {"BOKEH_SECRET_KEY", "REDIS_PASSWORD", "SHOW"}
    fixed = {name: text for name, text in passed.items() if "$" not in text and name != "WALKS"}  # it is mounted
    sentence = re.findall(r"compose\.yaml sets (.*?) itself", DEPLOYMENT.replace("\n", " "))[0]
    assert set(re.findall(r"`(\w+)`", sentence)) == set(fixed)
    read_settings([], {name: text for name, text in fixed.items() if not name.endswith("_FILE")})


def test_replicas_report_only_misspelt_lines_of_dot_env() -> None:
    lecture = COMPOSE["services"]["lecture"]
    assert lecture["env_file"] == [{"path": ".env", "required": False}]
    read = {name: "5" for name in re.findall(r"\$\{([A-Z_]+)", (ROOT / "compose.yaml").read_text())}
    assert {"SITE", "REPLICAS", "PROXY_MEMORY", "SESSIONS"} <= set(read)
    assert misspelt({**read, "COMPOSE_PROFILES": "class", "COMPOSE_PROJECT_NAME": "x"}) == []


def test_every_container_has_a_health_check_and_readiness_admits_visitors() -> None:
    built = {name for name, service in COMPOSE["services"].items() if "build" in service}
    checked = {name: service["healthcheck"] for name, service in COMPOSE["services"].items() if name not in built}
    assert built == {"lecture", "relief"} and set(checked) == {"proxy", "store"}
    assert all(check["test"][0] == "CMD-SHELL" and check["interval"] for check in checked.values())
    assert re.findall(r"health_uri (\S+)", (ROOT / "Caddyfile").read_text()) == ["/readiness"]
    assert re.findall(r"^HEALTHCHECK .*?GET (\S+) HTTP", (ROOT / "Dockerfile").read_text(), re.M) == ["/readiness"]


@pytest.mark.skipif(sys.platform == "win32", reason="no sh here")
@pytest.mark.parametrize("given", ["", "CLASS_PASSPHRASE", "CLASS_PASSPHRASE_FILE"])
def test_the_instructors_passphrase_reaches_the_replicas(tmp_path: Path, given: str) -> None:
    """Compose substitutes variables like sh."""
    (tmp_path / "phrase").write_text("a phrase of the class\n")
    outside = {"": {}, "CLASS_PASSPHRASE": {given: "a phrase of the class"}}.get(given, {given: f"{tmp_path}/phrase"})

    def with_variables(text: str) -> str:
        return subprocess.run(["sh", "-c", f'printf %s "{text}"'], env=outside, capture_output=True, text=True).stdout

    lecture, mounted = COMPOSE["services"]["lecture"], COMPOSE["secrets"]["class_passphrase"]["file"]
    assert "class_passphrase" in lecture["secrets"] and Path(with_variables(mounted)).exists()
    environment = {name: with_variables(text) for name, text in lecture["environment"].items() if "PASSPHRASE" in name}
    if path := environment["CLASS_PASSPHRASE_FILE"]:
        assert path == "/run/secrets/class_passphrase"
        environment["CLASS_PASSPHRASE_FILE"] = with_variables(mounted)
    assert read_settings([], environment).class_passphrase == ("a phrase of the class" if given else "")


def test_no_other_container_has_the_address_of_the_proxy() -> None:
    lecture, proxy = (COMPOSE["services"][name] for name in ("lecture", "proxy"))
    address = proxy["networks"]["inner"]["ipv4_address"]
    assert address == lecture["environment"]["TRUSTED_PROXIES"]
    (pool,) = COMPOSE["networks"]["inner"]["ipam"]["config"]
    assert ip_address(address) in ip_network(pool["subnet"]) and address != pool["gateway"]
    assert not any(ip_address(of) in ip_network(pool["ip_range"]) for of in (address, pool["gateway"]))


def test_the_proxy_keeps_running_when_replicas_are_replaced() -> None:
    assert "depends_on" not in COMPOSE["services"]["proxy"]


def test_the_store_needs_no_capability_to_start() -> None:
    store = COMPOSE["services"]["store"]
    assert re.fullmatch(r"[1-9]\d*:[1-9]\d*", store["user"])
    assert re.search(r"^exec valkey-server - ", store["command"][-1], re.M)


@pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")
def test_the_store_requires_its_password_hides_it_and_refuses_writes_when_full(tmp_path: Path) -> None:
    (tmp_path / "password").write_text("one/of+these=\n")
    port, store = free_port(), COMPOSE["services"]["store"]
    script = store["command"][-1].replace("$$", "$").replace("/run/secrets/store_password", str(tmp_path / "password"))
    script = script.replace("valkey-server -", f"{valkey_binary()} - --port {port}", 1)
    with serving(tmp_path / "log", port=port, command=(*store["entrypoint"], script)) as running:
        with redis.Redis(port=port, password="one/of+these=") as client:
            assert client.config_get("maxmemory-policy") == {"maxmemory-policy": "noeviction"}
        healthy = health_check(tmp_path, "store", {"/run/secrets/store_password": f"{tmp_path}/password"})
        assert healthy(6379, port) == 0 and healthy(6379, free_port()) != 0
        (tmp_path / "password").write_text("another\n")
        assert healthy(6379, port) != 0
        with redis.Redis(port=port) as stranger, pytest.raises(redis.exceptions.AuthenticationError):
            stranger.ping()
        assert "one/of+these=" not in " ".join(psutil.Process(running.process.pid).cmdline())


def test_only_replicas_reach_the_store_and_only_the_proxy_is_public() -> None:
    within = {name: set(service["networks"]) for name, service in COMPOSE["services"].items()}
    assert {name for name, of in within.items() if "shared" in of} == {"lecture", "relief", "store"}
    assert {name for name, of in within.items() if "outer" in of} == {"proxy"} and within["store"] == {"shared"}
    assert [COMPOSE["networks"][name].get("internal", False) for name in ("outer", "inner", "shared")] == [0, 1, 1]
    assert [name for name, service in COMPOSE["services"].items() if "ports" in service] == ["proxy"]


def test_visitors_over_ipv6_keep_their_addresses() -> None:
    """The engine keeps IPv6 addresses only if the network of the published ports has such addresses."""
    assert [name for name, network in COMPOSE["networks"].items() if network.get("enable_ipv6")] == ["outer"]


def test_networks_do_not_overlap() -> None:
    pools = [pool for network in COMPOSE["networks"].values() for pool in network.get("ipam", {}).get("config", ())]
    subnets = [ip_network(pool["subnet"]) for pool in pools]
    assert len(subnets) == 2 and not subnets[0].overlaps(subnets[1])


def test_every_third_party_image_is_pinned_by_digest() -> None:
    images = [service["image"] for service in COMPOSE["services"].values() if "build" not in service]
    assert len(images) == 2 and all(re.fullmatch(r"[\w./-]+:[\w.-]+@sha256:[0-9a-f]{64}", name) for name in images)


@pytest.mark.parametrize("reached", [True, False])
def test_digests_are_written_all_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reached: bool) -> None:
    for name in ("compose.yaml", "Dockerfile"):
        shutil.copy(ROOT / name, tmp_path)
    before = {path: path.read_text() for path in tmp_path.iterdir()}
    digest = "sha256:" + 64 * "0"
    engine = tmp_path / "bin" / "docker"
    engine.parent.mkdir()
    engine.write_text(
        f'#!/bin/sh\ncase "$*" in *{"nothing" if reached else "valkey"}*) echo away >&2; exit 1;; esac\necho {digest}\n'
    )
    engine.chmod(0o755)
    monkeypatch.setenv("PATH", f"{engine.parent}{os.pathsep}{os.environ['PATH']}")
    if reached:
        pin(tmp_path)
    else:
        with pytest.raises(RuntimeError, match="valkey/valkey:8-alpine: away"):
            pin(tmp_path)
    pinned = re.compile("sha256:[0-9a-f]{64}")
    assert {path: path.read_text() for path in before} == {
        path: pinned.sub(digest, text) if reached else text for path, text in before.items()
    }


@pytest.mark.parametrize("name", ["secret", "store-password"])
def test_secrets_are_never_readable_by_everybody(tmp_path: Path, name: str) -> None:
    for refused in ("chown", "setfacl"):
        command = tmp_path / refused
        command.write_text("#!/bin/sh\nexit 1\n")
        command.chmod(0o755)
    command = ["make", "--silent", "--file", str(ROOT / "Makefile"), name]
    environment = {**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"}
    refused = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert refused.returncode and f"may read the file {name}" in refused.stdout and not (tmp_path / name).exists()
    (tmp_path / "chown").write_text("#!/bin/sh\nexit 0\n")
    subprocess.run(command, cwd=tmp_path, env=environment, check=True)
    assert (tmp_path / name).stat().st_mode & 0o077 == 0
    assert len((tmp_path / name).read_text().strip()) == 44


@pytest.mark.parametrize("fails", ["", "relief", "lecture"])
def test_a_failed_upgrade_keeps_the_running_replicas(tmp_path: Path, fails: str) -> None:
    for name in ("secret", "store-password"):
        (tmp_path / name).touch()
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
