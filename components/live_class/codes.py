"""The code of a room, which is read aloud, and the keys of those who come in."""

from __future__ import annotations

import hmac
from base64 import urlsafe_b64encode
from hashlib import sha256
from secrets import choice, token_urlsafe
from time import time

SIGNS = "23456789ABCDEFGHJKMNPRSTUVWXYZ"
"""Letters and digits of which none is taken for another: no 0 O Q, no 1 I L."""
LENGTH = 4


def new_code() -> str:
    return "".join(choice(SIGNS) for _ in range(LENGTH))


def as_code(text: str) -> str:
    """The code that somebody has typed; "" for what can be none."""
    code = "".join(text.upper().split()).replace("-", "")
    return code if len(code) == LENGTH and set(code) <= set(SIGNS) else ""


def new_key() -> str:
    return token_urlsafe(24)


def join_key(key: str) -> str:
    """The word that a room's QR code carries beside the code: known to who has its key, and guessed by nobody."""
    return sha256(f"join {key}".encode()).hexdigest()[:12]


def digest(key: str) -> bytes:
    """The hash by which a key is kept."""
    return sha256(key.encode()).hexdigest().encode()


def is_key(key: str, kept: bytes) -> bool:
    return bool(kept) and hmac.compare_digest(digest(key), kept)


class Tokens:
    """Followers' tokens for one secret: each is good for one room, and says nothing of who has it."""

    def __init__(self, secret: str) -> None:
        self._secret = secret.encode()

    def new(self, code: str) -> str:
        """Its name begins with the time, so that the newest of some is the greatest."""
        return self._signed(code, f"{int(1000 * time()):011x}{token_urlsafe(6)}")

    def voter(self, code: str, token: str) -> str:
        """The name under which an answer of theirs is kept; "" for a token that is not of this room."""
        name, _, _ = token.partition(".")
        return name if name and hmac.compare_digest(token.encode(), self._signed(code, name).encode()) else ""

    def _signed(self, code: str, name: str) -> str:
        signature = hmac.digest(self._secret, f"follower {code} {name}".encode(), "sha256")[:12]
        return f"{name}.{urlsafe_b64encode(signature).decode()}"
