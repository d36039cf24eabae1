"""The token of a page, which opens its session. Bokeh makes it; it is valid only with our signature."""

from __future__ import annotations

import hmac
import time
from base64 import urlsafe_b64encode
from typing import Any

from bokeh.util.token import check_token_signature, get_token_payload


def opens_session(token: str, secret: bytes) -> bool:
    """Return True if the token is signed with the secret, for one of our sessions, and not expired."""
    expiry = _payload(token, secret).get("session_expiry")
    return isinstance(expiry, int | float) and time.time() < expiry


def page_name(token: str, secret: bytes) -> str:
    """Return the name of the page that has this token, expired or not, or ""."""
    return str(_payload(token, secret).get("page", ""))


def _payload(token: str, secret: bytes) -> dict[str, Any]:
    """Return the content of a token that is signed with the secret.

    The signature is checked before anything is decoded, because an unsigned token can contain anything.
    """
    text, _, signature = token.partition(".")
    expected = urlsafe_b64encode(hmac.digest(secret, text.encode(), "sha256")).rstrip(b"=")
    if not hmac.compare_digest(expected, signature.encode()):
        return {}
    try:
        payload: dict[str, Any] = get_token_payload(token)
        return payload if check_token_signature(token, secret_key=secret, signed=True) else {}
    except (ValueError, KeyError, TypeError):  # the id of a session has a signature of the same form
        return {}
