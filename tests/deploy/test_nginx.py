"""The nginx recipe of docs/deployment.md is well-formed, and page and socket reach the same replica."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from textwrap import dedent

import pytest

from tests.serving.server import ROOT

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
with_nginx = pytest.mark.skipif(not NGINX, reason="nginx is not installed: apt-get install nginx-light")
OWN = {"host", "http_upgrade", "proxy_add_x_forwarded_for", "request_id"}
"""Variables that nginx defines."""


def recipe() -> str:
    """Return the recipe of the document."""
    page = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
    section = page.partition("\n## Behind nginx\n")[2].partition("\n## ")[0]
    (block,) = (part for part in re.split(r"\n(?=\S)", section) if "proxy_pass" in part and "server {" in part)
    return dedent(block[block.index("    map") :])


def for_version(text: str) -> str:
    """Return the recipe as its comment says for an older nginx."""
    printed = subprocess.run([str(NGINX), "-v"], capture_output=True, text=True, check=True).stderr
    version = tuple(map(int, re.findall(r"/(\d+)\.(\d+)\.(\d+)", printed)[0]))
    return text if version >= WITH_HTTP2 else re.sub(r"^ *http2 on;.*\n", "", text, flags=re.M)


def written(folder: Path, text: str) -> Path:
    """Write a configuration that includes a recipe."""
    path = folder / "nginx.conf"
    path.write_text(MAIN.format(folder=folder, recipe=text), encoding="utf-8")
    return path


def test_the_recipe_defines_its_variables_and_sets_the_cookies_it_reads() -> None:
    text = re.sub(r"#.*", "", recipe())
    defined = set(re.findall(r"^map \S+ \$(\w+) \{", text, re.M))
    used = set(re.findall(r"\$([a-z]\w+)", text))
    cookies = {name.removeprefix("cookie_") for name in used if name.startswith("cookie_")}
    assert used - defined - OWN == {f"cookie_{name}" for name in cookies} and len(defined) == 3
    assert cookies == set(re.findall(r'default "(\w+)=', text)) == {"replica"}
    assert text.count("{") == text.count("}") > 5
    for line in filter(None, map(str.strip, text.splitlines())):
        assert line[-1] in ";{}", line
    # no deprecated directive
    assert not re.search(r"listen [^;]*\b(http2|spdy)\b|^\s*ssl on;", recipe(), re.M)


@with_nginx
def test_nginx_accepts_the_recipe(tmp_path: Path) -> None:
    if not shutil.which("openssl"):
        pytest.skip("openssl, which makes the certificate, is not installed")
    for name in ("key", "pem"):
        assert f"/etc/ssl/lecture.example.{name};" in recipe()
    key, certificate = tmp_path / "key", tmp_path / "pem"
    made = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=lecture.example"]
    subprocess.run([*made, "-keyout", str(key), "-out", str(certificate)], check=True, capture_output=True)
    text = for_version(recipe()).replace("/etc/ssl/lecture.example.", f"{tmp_path}/")
    path = written(tmp_path, text.replace("listen 443", "listen 8443"))
    checked = subprocess.run([str(NGINX), "-t", "-c", path, "-p", tmp_path], capture_output=True, text=True)
    assert checked.returncode == 0 and "[warn]" not in checked.stderr, checked.stderr
