"""The proxy of compose.yaml, with one replica and with none; the example for Kubernetes."""

import hmac
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml

from components.serving.assets import assets
from components.serving.headers import SAFE
from components.serving.server import ENDING
from components.serving.settings import KNOWN, misspelt, read_settings
from tests.serving.server import ROOT, Server, free_port, serving
from tests.serving.visitor import ask
from tools.deploy.site import COOKIE_SECRET, DeployedSite, behind_caddy, caddy, deployed

COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text(encoding="utf-8"))
ASSET = f"/assets/{next(iter(assets()))}"


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


NC = """#!{python}
import socket, sys
with socket.create_connection((sys.argv[3], int(sys.argv[4])), float(sys.argv[2])) as peer:
    peer.sendall(sys.stdin.buffer.read())
    while got := peer.recv(4096):
        sys.stdout.buffer.write(got)
"""
"""The part of nc that the checks use: nc -w SECONDS HOST PORT."""


def health_check(folder: Path, service: str, instead: Mapping[str, str] | None = None) -> Callable[[int, int], int]:
    """Return a function that runs a service's health check at another port, with other paths, for its exit code."""
    kind, command = COMPOSE["services"][service]["healthcheck"]["test"]
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


@pytest.mark.skipif(sys.platform == "win32", reason="no sh here")
def test_a_proxy_without_replicas_is_healthy_and_says_that_the_lecture_does_not_answer(
    site: DeployedSite, tmp_path: Path
) -> None:
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


PAGE = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
OBJECTS: list[dict[str, Any]] = list(yaml.safe_load_all((ROOT / "docs" / "kubernetes.yaml").read_text("utf-8")))


SPECS: dict[tuple[str, str], Any] = {(one["kind"], one["metadata"]["name"]): one.get("spec") for one in OBJECTS}
PODS: dict[str, Any] = {name: SPECS["Deployment", name]["template"]["spec"] for name in ("lecture", "store")}
LECTURE, STORE = (pod["containers"][0] for pod in PODS.values())
RULE = SPECS["Ingress", "lecture"]["rules"][0]


def test_the_pods_agree_with_their_services_the_image_and_compose() -> None:
    for name, pod in PODS.items():
        service, labels = SPECS["Service", name], SPECS["Deployment", name]["template"]["metadata"]["labels"]
        assert service["selector"].items() <= labels.items()
        assert {port["targetPort"] for port in service["ports"]} <= {
            port["name"] for port in pod["containers"][0]["ports"]
        }
        (secret,) = (volume["secret"] for volume in pod["volumes"] if "secret" in volume)
        assert f"kubectl create secret generic {secret['secretName']} " in PAGE and secret["defaultMode"] == 0o440
    assert str(PODS["lecture"]["securityContext"]["runAsUser"]) == re.findall(r"--uid (\d+)", DOCKERFILE)[0]
    (port,) = LECTURE["ports"]
    assert f"EXPOSE {port['containerPort']}\n" in DOCKERFILE and f"PORT={port['containerPort']} " in DOCKERFILE
    store = COMPOSE["services"]["store"]
    assert store["image"].startswith(f"{STORE['image']}@")
    assert [STORE[part] for part in ("command", "args")] == [store["entrypoint"], store["command"]]


def test_the_settings_of_the_manifest_are_settings_and_their_values_are_allowed(tmp_path: Path) -> None:
    given = {one["name"]: one["value"] for one in LECTURE["env"]}
    assert set(given) <= KNOWN and misspelt(given) == []
    keys = set(re.findall(r"--from-literal=([a-z-]+)=", PAGE))
    for name in (name for name in given if name.endswith("_FILE")):
        (mount,) = (one["mountPath"] for one in LECTURE["volumeMounts"] if one["name"] == "secrets")
        folder, _, key = given[name].rpartition("/")
        assert folder == mount and key in keys
        (path := tmp_path / key).write_text("kD8sWq2LzX5vBn7Rt1YpGf\n")
        given[name] = str(path)
    settings = read_settings([], given)
    assert settings.allowed_origin == (RULE["host"],) and settings.public_url == f"https://{RULE['host']}/"
    assert settings.redis_url.split("/")[2] == f"store:{STORE['ports'][0]['containerPort']}"
    assert settings.notice_seconds < ENDING < PODS["lecture"]["terminationGracePeriodSeconds"]


def test_probes_are_answered_at_the_address_of_a_pod(server: Server) -> None:
    for kind, path in (("startup", "/liveness"), ("liveness", "/liveness"), ("readiness", "/readiness")):
        assert LECTURE[f"{kind}Probe"]["httpGet"] == {"path": path, "port": "http"}
        assert ask(server.url, path, Host="10.244.1.7:5006", User_Agent="kube-probe/1.34").status == 200
