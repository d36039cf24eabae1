"""The nginx recipe of docs/deployment.md is well-formed, and page and socket reach the same replica."""

from __future__ import annotations

import asyncio
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from textwrap import dedent

import pytest
from prometheus_client.parser import text_string_to_metric_families

from tests.attack.caller import ask, token_of
from tests.serving.server import ROOT
from tests.serving.visitor import Visitor
from tools.deploy.site import DeployedSite, deployed
from tools.deploy.trials import trial

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


def behind_nginx(site: DeployedSite) -> tuple[Sequence[str], Mapping[str, str]]:
    """Return the recipe with the addresses of a site, without encryption."""
    text = re.sub(r"^ *(ssl_certificate|http2).*\n", "", recipe(), flags=re.M)
    text = text.replace("listen 443 ssl;", f"listen 127.0.0.1:{site.port};")
    for host, port in zip(("10.0.0.11", "10.0.0.12"), site.ports, strict=True):
        text = text.replace(f"{host}:5006", f"127.0.0.1:{port}")
    return (str(NGINX), "-c", str(written(site.folder, text)), "-p", str(site.folder)), {}


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


def opened(site: DeployedSite) -> list[tuple[float, float]]:
    """Return the sessions and the sockets that were opened on each replica."""
    names = ("oscillations_sessions", "oscillations_sockets")
    texts = [ask(f"http://127.0.0.1:{port}/", "/metrics").text for port in site.ports]
    samples = [
        {one.name: one.value for of in text_string_to_metric_families(text) for one in of.samples} for text in texts
    ]
    return [(found[names[0]], found[names[1]]) for found in samples]


async def arrive(site: DeployedSite, link: str, cookies: bool) -> tuple[Visitor, str]:
    """Open a page as a visitor whose browser keeps cookies or not; return the visitor and the cookie."""
    page = await asyncio.to_thread(ask, site.url, f"/?{link}")
    assert page.status == 200
    cookie = page.headers["Set-Cookie"].partition(";")[0]
    headers = {"Cookie": cookie} if cookies else {}
    return await Visitor.connect(site.url, token_of(page.text), headers), cookie


@with_nginx
@pytest.mark.slow
@pytest.mark.timeout(300)
def test_page_and_socket_reach_the_same_replica_and_one_network_uses_both(tmp_path: Path) -> None:
    async def go(site: DeployedSite) -> None:
        # The longest link with text that does not compress: its token is a header of more than 8 kB.
        long = "scene=coupled&x=" + "".join(f"{i * i * i:x}" for i in range(1500))[:7900]
        came = [await arrive(site, long if i % 4 == 0 else "scene=coupled", cookies=True) for i in range(16)]
        assert len({cookie for _, cookie in came}) == 16
        first, second = opened(site)
        assert first[0] + second[0] == 16 and min(first[0], second[0]) > 0
        assert all(sessions == sockets for sessions, sockets in (first, second))
        for visitor, _ in came:
            await visitor.depart()
        cookie = came[0][1]
        again = ask(site.url, "/?scene=coupled", Cookie=cookie)
        assert "Set-Cookie" not in again.headers
        forged = ask(site.url, "/?scene=coupled", Cookie="replica=x; Path=/")
        assert re.match(r"replica=[0-9a-f]{32}; Path=/;", forged.headers["Set-Cookie"])
        guests = [await arrive(site, "scene=coupled", cookies=False) for _ in range(4)]  # any replica opens the page
        for visitor, _ in guests:
            await visitor.move("k2", 2.0)
            await visitor.depart()
        assert [ask(site.url, path).status for path in ("/metrics", "/liveness", "/readiness")] == [404] * 3
        asset = re.search(r'(?:href|src)="(assets/[^"]+)"', ask(site.url).text)[1]
        assert "Set-Cookie" not in ask(site.url, f"/{asset}").headers
        result = await asyncio.to_thread(asyncio.run, trial(site, 4, lambda: site.kill(0)))
        assert result.lost == [] and site.complaints() == []

    with deployed(tmp_path, front=behind_nginx) as site:
        asyncio.run(go(site))
