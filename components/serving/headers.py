"""Security headers: limits for our pages, and for other sites that use them."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable
from functools import lru_cache
from hashlib import sha256

from jinja2 import Template

SAFE = {
    "Permissions-Policy": "camera=(), geolocation=(), microphone=(), payment=(), usb=()",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",  # a link contains the values of its visitor
}
SCRIPT = re.compile(r"<script>(.*?)</script>", re.S)


def policy(ancestors: str, scripts: Iterable[str] = ()) -> str:
    """Return the Content-Security-Policy of a page with these inline scripts, or of a page without scripts.

    It has one exception: BokehJS adds `<style>` elements whose text changes (StyleSheet in bokeh.js), hence
    'unsafe-inline' for styles.
    """
    hashes = " ".join(f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in scripts)
    parts = ["default-src 'none'", "style-src 'self' 'unsafe-inline'", "img-src 'self' data: blob:"]
    if hashes:
        parts += [f"script-src 'self' {hashes}", "connect-src 'self'", "font-src 'self'", "frame-src 'self'"]
    return "; ".join([*parts, "base-uri 'none'", "form-action 'none'", f"frame-ancestors {_with_self(ancestors)}"])


def _with_self(ancestors: str) -> str:
    """Return the sites that may frame a page. The page itself may, because it prepares a handout in a hidden frame."""
    others = [one for one in ancestors.split() if one not in ("'self'", "'none'")]
    return " ".join([*others, "'self'"])


@lru_cache(maxsize=4)
def scripts_of(template: Template) -> tuple[str, ...]:
    """Hashes of the scripts in a template. They are computed before the template has any data of a visitor, so that
    nobody can add a script."""
    return tuple(SCRIPT.findall(template.render()))
