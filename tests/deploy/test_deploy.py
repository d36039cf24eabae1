"""compose.yaml with its proxy and store, the example for Kubernetes, and a class at replicas of which one fails."""

import asyncio
import hmac
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, suppress
from http.client import HTTPException
from ipaddress import ip_address, ip_network
from pathlib import Path
from typing import Any

import psutil
import pytest
import redis
import yaml

from components.serving.assets import assets
from components.serving.headers import SAFE
from components.serving.server import ENDING
from components.serving.settings import HINTS, KNOWN, misspelt, read_settings
from tests.live_class.caller import CHOICE, Class, Stream, streams_closed, until
from tests.live_class.served import Valkey, valkey_binary
from tests.serving.server import ROOT, Server, free_port, serving
from tests.serving.visitor import ask
from tools.deploy.site import COOKIE_SECRET, DeployedSite, behind_caddy, caddy, deployed, upgraded
from tools.deploy.trials import trial

DEPLOYMENT = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text())
SERVICES, NETWORKS = COMPOSE["services"], COMPOSE["networks"]
LECTURE, RELIEF, PROXY, STORE = (SERVICES[name] for name in ("lecture", "relief", "proxy", "store"))
ASSET = f"/assets/{next(iter(assets()))}"
NO_SHELL = pytest.mark.skipif(sys.platform == "win32", reason="no sh here")


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


@NO_SHELL
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


def program(folder: Path, name: str, script: str, shell: str = "/bin/sh") -> dict[str, str]:
    """Write a program, and return the environment in which it is the first of this name."""
    (path := folder / name).write_text(f"#!{shell}\n{script}\n")
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


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DeployedSite]:
    with deployed(tmp_path_factory.mktemp("site"), (ROOT,)) as running:
        yield running


def test_pages_of_the_proxy_and_of_the_lecture_have_the_same_safety_headers(site: DeployedSite) -> None:
    page, file = ask(site.url, "/"), ask(site.url, ASSET)
    for path in ("/metrics", "/liveness", "/readiness"):
        own = ask(site.url, path)
        assert own.status == 404 and SAFE.items() <= own.headers.items() and SAFE.items() <= page.headers.items()
        assert own.headers["Content-Security-Policy"].startswith("default-src 'none'")
    assert "frame-ancestors" in page.headers["Content-Security-Policy"]
    # The cookie that names the replica is signed, and not sent with cached files.
    written = hmac.new(COOKIE_SECRET.encode(), f"127.0.0.1:{site.ports[0]}".encode(), "sha256").hexdigest()
    assert page.headers["Set-Cookie"].startswith(f"replica={written};")
    assert (file.status, "Set-Cookie" in file.headers) == (200, False)
    assert "immutable" in file.headers["Cache-Control"]


NC = """import socket, sys
with socket.create_connection((sys.argv[3], int(sys.argv[4])), float(sys.argv[2])) as peer:
    peer.sendall(sys.stdin.buffer.read())
    while got := peer.recv(4096):
        sys.stdout.buffer.write(got)"""
"""The part of nc that the checks use: nc -w SECONDS HOST PORT."""


def health_check(folder: Path, service: str, instead: Mapping[str, str] | None = None) -> Callable[[int, int], int]:
    """Return a function that runs a service's health check at another port, with other paths, for its exit code."""
    kind, command = SERVICES[service]["healthcheck"]["test"]
    assert kind == "CMD-SHELL"
    for name, other in (instead or {}).items():
        assert name in command
        command = command.replace(name, other)
    environment = program(folder, "nc", NC, sys.executable)

    def run(port: int, other: int) -> int:
        assert f"127.0.0.1 {port} " in command
        there = command.replace("$$", "$").replace(f"127.0.0.1 {port} ", f"127.0.0.1 {other} ")
        return subprocess.run(["sh", "-c", there], env=environment, stderr=subprocess.DEVNULL).returncode

    return run


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


@NO_SHELL
def test_a_proxy_without_replicas_is_healthy_and_says_what_is_away(site: DeployedSite, tmp_path: Path) -> None:
    healthy = health_check(tmp_path, "proxy")
    assert healthy(80, site.port) == 0 and healthy(80, free_port()) != 0
    alone = {**behind_caddy(site)[1], "SITE": f"http://127.0.0.1:{(port := free_port())}", "UPSTREAMS": "127.0.0.1:1"}
    with serving(tmp_path / "log", port=port, command=behind_caddy(site)[0], environment=alone) as proxy:
        assert healthy(80, port) == 0
        unavailable = ask(proxy.url, "/?scene=coupled&k2=3")
    assert unavailable.status in (502, 503) and not {"Server", "Via"} & set(unavailable.headers)
    assert "The lecture does not answer now" in unavailable.text and 'http-equiv="refresh"' in unavailable.text
    assert "http.log.error" in (log := proxy.log.read_text()) and not re.search("k2=3|remote_ip", log)


def test_hsts_is_sent_except_on_localhost_where_it_would_cover_all_ports() -> None:
    command = [caddy(), "adapt", "--config", str(ROOT / "Caddyfile"), "--adapter", "caddyfile"]
    adapted = subprocess.run(command, capture_output=True, text=True, check=True, env={"SITE": "lecture.example"})
    held = list[Any]()

    def note(part: dict[str, Any]) -> dict[str, Any]:
        if "Strict-Transport-Security" in str(part.get("handle", [{}])[0].get("response")):
            held.append(part["match"])
        return part

    json.loads(adapted.stdout, object_hook=note)  # of the lecture's pages, and of the proxy's own
    assert held == [[{"not": [{"host": ["localhost", "127.0.0.1", "::1"]}], "protocol": "https"}]] * 2


DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
OBJECTS: list[dict[str, Any]] = list(yaml.safe_load_all((ROOT / "docs" / "kubernetes.yaml").read_text("utf-8")))
SPECS: dict[tuple[str, str], Any] = {(one["kind"], one["metadata"]["name"]): one.get("spec") for one in OBJECTS}
PODS: dict[str, Any] = {name: SPECS["Deployment", name]["template"]["spec"] for name in ("lecture", "store")}
LECTURE_POD, STORE_POD = (pod["containers"][0] for pod in PODS.values())
RULE = SPECS["Ingress", "lecture"]["rules"][0]


def test_the_pods_agree_with_their_services_the_image_and_compose() -> None:
    for name, pod in PODS.items():
        service, labels = SPECS["Service", name], SPECS["Deployment", name]["template"]["metadata"]["labels"]
        assert service["selector"].items() <= labels.items()
        assert {port["targetPort"] for port in service["ports"]} <= {
            port["name"] for port in pod["containers"][0]["ports"]
        }
        (secret,) = (volume["secret"] for volume in pod["volumes"] if "secret" in volume)
        assert f"kubectl create secret generic {secret['secretName']} " in DEPLOYMENT and secret["defaultMode"] == 0o440
    assert str(PODS["lecture"]["securityContext"]["runAsUser"]) == re.findall(r"--uid (\d+)", DOCKERFILE)[0]
    (port,) = LECTURE_POD["ports"]
    assert f"EXPOSE {port['containerPort']}\n" in DOCKERFILE and f"PORT={port['containerPort']} " in DOCKERFILE
    assert STORE["image"].startswith(f"{STORE_POD['image']}@")
    assert [STORE_POD[part] for part in ("command", "args")] == [STORE["entrypoint"], STORE["command"]]


def test_the_settings_of_the_manifest_are_settings_and_their_values_are_allowed(tmp_path: Path) -> None:
    given = {one["name"]: one["value"] for one in LECTURE_POD["env"]}
    assert set(given) <= KNOWN and misspelt(given) == []
    keys = set(re.findall(r"--from-literal=([a-z-]+)=", DEPLOYMENT))
    for name in (name for name in given if name.endswith("_FILE")):
        (mount,) = (one["mountPath"] for one in LECTURE_POD["volumeMounts"] if one["name"] == "secrets")
        folder, _, key = given[name].rpartition("/")
        assert folder == mount and key in keys
        (path := tmp_path / key).write_text("kD8sWq2LzX5vBn7Rt1YpGf\n")
        given[name] = str(path)
    settings = read_settings([], given)
    assert settings.allowed_origin == (RULE["host"],) and settings.public_url == f"https://{RULE['host']}/"
    assert settings.redis_url.split("/")[2] == f"store:{STORE_POD['ports'][0]['containerPort']}"
    assert settings.notice_seconds < ENDING < PODS["lecture"]["terminationGracePeriodSeconds"]


def test_probes_are_answered_at_the_address_of_a_pod(server: Server) -> None:
    for kind, path in (("startup", "/liveness"), ("liveness", "/liveness"), ("readiness", "/readiness")):
        assert LECTURE_POD[f"{kind}Probe"]["httpGet"] == {"path": path, "port": "http"}
        assert ask(server.url, path, Host="10.244.1.7:5006", User_Agent="kube-probe/1.34").status == 200


SLOW = (b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: ", b"POST /class HTTP/1.1\r\nHost: x\r\nContent-Length: 999\r\n\r\n")
"""Requests that come byte by byte. The proxy drops them, but not a stream of a class."""


async def dropped(port: int, start: bytes) -> None:
    """Wait until the proxy closes a connection on which a request never ends."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(start)
    with suppress(ConnectionError):
        while not reader.at_eof():
            with suppress(TimeoutError):
                await asyncio.wait_for(reader.read(4096), 0.5)
            writer.write(b"x")
            await writer.drain()
    writer.close()


async def ordered(room: Class, type: str, **order: Any) -> None:
    """Send an order until it is accepted, as the instructor's page does."""
    async with asyncio.timeout(20):
        while True:
            with suppress(OSError, HTTPException):
                if (await room.order(type, **order)).status == 204:
                    return
            await asyncio.sleep(0.1)


@streams_closed()
async def lesson(site: DeployedSite) -> None:
    slow = asyncio.gather(*(dropped(site.port, start) for start in SLOW))
    room = await Class.open(site.url)
    direct = [f"http://127.0.0.1:{port}/" for port in site.ports]
    streams = [await room.follow(url) for url in (*direct[:2], site.url)]
    await ordered(room, "put", **CHOICE)
    for stream in streams:
        await stream.until(lambda event: event.get("question"))
        # The connection may have gone through another replica, which still counts it for some seconds.
        await stream.until(lambda event: event.get("here") == 3)
    assert "X-Accel-Buffering: no" in streams[2].headers
    for i in range(4):
        url = direct[i % 3]
        await room.voted(await room.token(url), url=url, **CHOICE, option=i % 2)

    def happening() -> None:
        site.kill(0)
        site.end(1)

    result = await asyncio.to_thread(asyncio.run, trial(site, 6, happening))
    assert result.lost == [] and result.returned >= 1
    await until(lambda: streams[0].ended and streams[1].ended)
    back = await Stream.open(site.url, room.code, streams[0].word)
    await back.until(lambda event: event.get("question", {}).get("step") == CHOICE["step"])
    await ordered(room, "show")
    await back.until(lambda event: event.get("question", {}).get("lesson"))
    assert (await room.tally())["now"]["options"] == [2, 2, 0]
    await asyncio.wait_for(slow, 40)
    assert not back.ended
    site.front.process.terminate()
    assert await asyncio.to_thread(site.front.process.wait, 9) == 0  # despite the open stream


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform == "win32", reason="no Valkey here")
@pytest.mark.timeout(300)  # three servers start
def test_nothing_is_lost_when_a_replica_fails_another_ends_and_a_later_version_takes_over(tmp_path: Path) -> None:
    codes = (ROOT, ROOT, upgraded(tmp_path / "later"))
    with closing(Valkey()) as valkey, deployed(tmp_path, codes, REDIS_URL=valkey.url) as site:
        page = ask(site.url, "/?scene=oscillator")
        assert page.status == 200 and not {"Server", "Via"} & set(page.headers)
        asyncio.run(lesson(site))
        assert site.complaints() == []
