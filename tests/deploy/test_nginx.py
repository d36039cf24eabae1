"""The nginx recipe of docs/deployment.md is well-formed."""

from __future__ import annotations

import re
from textwrap import dedent

from tests.serving.server import ROOT

OWN = {"host", "http_upgrade", "proxy_add_x_forwarded_for", "request_id"}
"""Variables that nginx defines."""


def recipe() -> str:
    """Return the recipe of the document."""
    page = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
    section = page.partition("\n## Behind nginx\n")[2].partition("\n## ")[0]
    (block,) = (part for part in re.split(r"\n(?=\S)", section) if "proxy_pass" in part and "server {" in part)
    return dedent(block[block.index("    map") :])


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
