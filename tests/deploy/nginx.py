"""The nginx recipe of docs/deployment.md, run in a real nginx if one is installed."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from textwrap import dedent

from tests.serving.server import ROOT
from tools.deploy.site import DeployedSite

NGINX = shutil.which("nginx", path="/usr/sbin:/usr/local/sbin:/usr/bin:/usr/local/bin:/opt/homebrew/bin")
WITH_HTTP2 = (1, 25, 1)
"""The first version that accepts `http2 on`."""
MAIN = """
daemon off;
master_process off;
pid {folder}/nginx.pid;
error_log stderr warn;
events {{ worker_connections 1024; }}
http {{
    access_log off;
    client_body_temp_path {folder}/body; proxy_temp_path {folder}/proxy; fastcgi_temp_path {folder}/fastcgi;
    uwsgi_temp_path {folder}/uwsgi; scgi_temp_path {folder}/scgi;
{recipe}
}}
"""


def recipe() -> str:
    """Return the recipe of the document."""
    page = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
    section = page.partition("\n## Behind nginx\n")[2].partition("\n## ")[0]
    (block,) = (part for part in re.split(r"\n(?=\S)", section) if "proxy_pass" in part and "server {" in part)
    return dedent(block[block.index("    map") :])


def version() -> tuple[int, ...]:
    printed = subprocess.run([str(NGINX), "-v"], capture_output=True, text=True, check=True).stderr
    return tuple(map(int, re.findall(r"/(\d+)\.(\d+)\.(\d+)", printed)[0]))


def for_version(text: str) -> str:
    """Return the recipe as its comment says for an older nginx."""
    return text if version() >= WITH_HTTP2 else re.sub(r"^ *http2 on;.*\n", "", text, flags=re.M)


def written(folder: Path, text: str) -> Path:
    """Write a configuration that includes a recipe."""
    path = folder / "nginx.conf"
    path.write_text(MAIN.format(folder=folder, recipe=text), encoding="utf-8")
    return path


def behind_nginx(site: DeployedSite) -> tuple[Sequence[str], Mapping[str, str]]:
    """Return the recipe with the addresses of a site, without encryption."""
    text = re.sub(r"^ *(ssl_certificate|http2).*\n", "", recipe(), flags=re.M)
    text = text.replace("listen 443 ssl;", f"listen 127.0.0.1:{site.port};")
    for host, port in zip(("10.0.0.11", "10.0.0.12"), site.ports, strict=True):
        text = text.replace(f"{host}:5006", f"127.0.0.1:{port}")
    return (str(NGINX), "-c", str(written(site.folder, text)), "-p", str(site.folder)), {}
