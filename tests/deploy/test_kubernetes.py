"""The example manifest for Kubernetes: its objects fit together, and its settings and probes exist in the server."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from components.serving.server import ENDING
from components.serving.settings import KNOWN, misspelt, read_settings
from tests.attack.caller import ask
from tests.serving.server import ROOT, Server

TEXT = (ROOT / "docs" / "kubernetes.yaml").read_text(encoding="utf-8")
PAGE = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
DOCKERFILE = (ROOT / "Dockerfile").read_text(encoding="utf-8")
COMPOSE: dict[str, Any] = yaml.safe_load((ROOT / "compose.yaml").read_text(encoding="utf-8"))
OBJECTS: list[dict[str, Any]] = list(yaml.safe_load_all(TEXT))


def named(kind: str) -> dict[str, dict[str, Any]]:
    return {one["metadata"]["name"]: one["spec"] for one in OBJECTS if one["kind"] == kind}


PODS: dict[str, dict[str, Any]] = {name: spec["template"]["spec"] for name, spec in named("Deployment").items()}
CONTAINERS: dict[str, dict[str, Any]] = {name: pod["containers"][0] for name, pod in PODS.items()}
LECTURE = CONTAINERS["lecture"]
PROBES = {name: probe["httpGet"] for name, probe in LECTURE.items() if name.endswith("Probe")}


def test_services_and_ingress_use_existing_ports() -> None:
    for spec in named("Deployment").values():
        assert spec["selector"]["matchLabels"].items() <= spec["template"]["metadata"]["labels"].items()
    for name, service in named("Service").items():
        assert named("Deployment")[name]["selector"]["matchLabels"] == service["selector"]
        offered = {port["name"] for port in CONTAINERS[name]["ports"]}
        assert {port["targetPort"] for port in service["ports"]} <= offered
    (rule,) = named("Ingress")["lecture"]["rules"]
    (path,) = rule["http"]["paths"]
    backend = path["backend"]["service"]
    assert backend["port"]["name"] in {port["name"] for port in named("Service")[backend["name"]]["ports"]}
    assert (path["path"], path["pathType"]) == ("/", "Prefix")


@pytest.mark.parametrize("name", PODS)
def test_each_pod_is_confined_and_mounts_its_volumes(name: str) -> None:
    pod, container = PODS[name], CONTAINERS[name]
    assert pod["securityContext"]["runAsNonRoot"] and not pod["automountServiceAccountToken"]
    assert container["securityContext"]["readOnlyRootFilesystem"]
    assert container["securityContext"]["capabilities"] == {"drop": ["ALL"]}
    assert {one["name"] for one in container["volumeMounts"]} == {one["name"] for one in pod["volumes"]}
    (secret,) = (volume["secret"] for volume in pod["volumes"] if "secret" in volume)
    assert f"kubectl create secret generic {secret['secretName']} " in PAGE and secret["defaultMode"] == 0o440


def test_the_pod_agrees_with_the_image_and_the_store_with_compose() -> None:
    user = re.findall(r"--uid (\d+)", DOCKERFILE)[0]
    assert str(PODS["lecture"]["securityContext"]["runAsUser"]) == user
    (port,) = LECTURE["ports"]
    assert f"EXPOSE {port['containerPort']}\n" in DOCKERFILE and f"PORT={port['containerPort']} " in DOCKERFILE
    store = COMPOSE["services"]["store"]
    assert store["image"].startswith(f"{CONTAINERS['store']['image']}@")
    assert [CONTAINERS["store"][part] for part in ("command", "args")] == [store["entrypoint"], store["command"]]
    assert LECTURE["resources"]["limits"]["memory"] == "1Gi"


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
    (rule,) = named("Ingress")["lecture"]["rules"]
    assert settings.allowed_origin == (rule["host"],) and settings.public_url == f"https://{rule['host']}/"
    assert settings.redis_url.split("/")[2] == f"store:{CONTAINERS['store']['ports'][0]['containerPort']}"
    assert settings.notice_seconds < ENDING < PODS["lecture"]["terminationGracePeriodSeconds"]


@pytest.mark.parametrize("name", PROBES)
def test_probes_are_answered_at_the_address_of_a_pod(server: Server, name: str) -> None:
    assert set(PROBES) == {"startupProbe", "livenessProbe", "readinessProbe"}
    reply = ask(server.url, PROBES[name]["path"], Host="10.244.1.7:5006", User_Agent="kube-probe/1.34")
    assert reply.status == 200 and PROBES[name]["port"] == "http"
    assert PROBES[name]["path"] == ("/readiness" if name == "readinessProbe" else "/liveness")
