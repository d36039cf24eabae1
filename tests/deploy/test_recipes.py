"""The examples for Kubernetes and nginx: their parts fit together; their settings and probes exist in the server."""

from __future__ import annotations

import re
from pathlib import Path
from textwrap import dedent
from typing import Any

import yaml

from components.serving.server import ENDING
from components.serving.settings import KNOWN, misspelt, read_settings
from tests.attack.caller import ask
from tests.serving.server import ROOT, Server

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
