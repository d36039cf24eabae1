"""The proxy of compose.yaml, with one replica and with none; the examples for Kubernetes and nginx."""

import hmac
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
import yaml

from components.serving.assets import assets
from components.serving.headers import SAFE
from components.serving.server import ENDING
from components.serving.settings import KNOWN, misspelt, read_settings
from tests.deploy.health import health_check
from tests.serving.server import ROOT, Server, free_port, serving
from tests.serving.visitor import ask
from tools.deploy.site import COOKIE_SECRET, DeployedSite, behind_caddy, caddy, deployed

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

    json.loads(adapted.stdout, object_hook=note)
    assert len(held) == 2  # the lecture's pages, and the proxy's own pages
    assert all(match == [{"not": [{"host": ["localhost", "127.0.0.1", "::1"]}], "protocol": "https"}] for match in held)


PAGE = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text(encoding="utf-8"))
OBJECTS: list[dict[str, Any]] = list(yaml.safe_load_all((ROOT / "docs" / "kubernetes.yaml").read_text("utf-8")))


def named(kind: str) -> dict[str, dict[str, Any]]:
    return {one["metadata"]["name"]: one["spec"] for one in OBJECTS if one["kind"] == kind}


DEPLOYED, SERVICES = named("Deployment"), named("Service")
PODS: dict[str, dict[str, Any]] = {name: spec["template"]["spec"] for name, spec in DEPLOYED.items()}
CONTAINERS: dict[str, dict[str, Any]] = {name: pod["containers"][0] for name, pod in PODS.items()}
LECTURE, STORE = CONTAINERS["lecture"], CONTAINERS["store"]
RULE = named("Ingress")["lecture"]["rules"][0]


def test_the_pods_agree_with_their_services_the_image_and_compose() -> None:
    for name, pod in PODS.items():
        container, selector = CONTAINERS[name], DEPLOYED[name]["selector"]["matchLabels"]
        assert selector.items() <= DEPLOYED[name]["template"]["metadata"]["labels"].items()
        assert SERVICES[name]["selector"] == selector
        assert {port["targetPort"] for port in SERVICES[name]["ports"]} <= {port["name"] for port in container["ports"]}
        assert {one["name"] for one in container["volumeMounts"]} == {one["name"] for one in pod["volumes"]}
        (secret,) = (volume["secret"] for volume in pod["volumes"] if "secret" in volume)
        assert f"kubectl create secret generic {secret['secretName']} " in PAGE and secret["defaultMode"] == 0o440
    backend = RULE["http"]["paths"][0]["backend"]["service"]
    assert backend["port"]["name"] in {port["name"] for port in SERVICES[backend["name"]]["ports"]}
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


OWN = {"host", "http_upgrade", "proxy_add_x_forwarded_for", "request_id"}
"""Variables that nginx defines."""


def test_the_recipe_for_nginx_defines_its_variables_and_sets_the_cookies_it_reads() -> None:
    section = PAGE.partition("\n## Behind nginx\n")[2].partition("\n## ")[0]
    (block,) = (part for part in re.split(r"\n(?=\S)", section) if "proxy_pass" in part and "server {" in part)
    text = re.sub(r"#.*", "", dedent(block[block.index("    map") :]))
    defined = set(re.findall(r"^map \S+ \$(\w+) \{", text, re.M))
    used = set(re.findall(r"\$([a-z]\w+)", text))
    cookies = {name.removeprefix("cookie_") for name in used if name.startswith("cookie_")}
    assert used - defined - OWN == {f"cookie_{name}" for name in cookies} and len(defined) == 3
    assert cookies == set(re.findall(r'default "(\w+)=', text)) == {"replica"}
    assert text.count("{") == text.count("}") > 5
    assert [line for line in map(str.strip, text.splitlines()) if line and line[-1] not in ";{}"] == []
    assert not re.search(r"listen [^;]*\b(http2|spdy)\b|^\s*ssl on;", text, re.M), "deprecated"
