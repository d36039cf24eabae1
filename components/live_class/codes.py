"""The code of a room, which can be read aloud, and the keys of its members."""

from __future__ import annotations

import hmac
from base64 import urlsafe_b64encode
from hashlib import scrypt, sha256
from secrets import choice, token_urlsafe
from time import time

SIGNS = "23456789ABCDEFGHJKMNPRSTUVWXYZ"
"""Letters and digits that cannot be confused: no 0 O Q, no 1 I L."""
LENGTH = 4
DEAR = {"n": 2**13, "r": 8, "p": 1}
"""Work for one code: about 20 ms, so trying all 30^4 codes takes hours."""

MARK = 5
"""Number of characters of the signature in a follower's name. Guessing one takes a day of requests."""


def code_of(key: str, secret: str = "") -> str:
    """Return the code of the room of a key. Finding a key for a given code takes hours; without the server's secret it
    cannot be done in advance either."""
    number = int.from_bytes(scrypt(key.encode(), salt=f"the code of a class{secret}".encode(), dklen=8, **DEAR))
    return "".join(SIGNS[number // len(SIGNS) ** i % len(SIGNS)] for i in range(LENGTH))


def as_code(text: str) -> str:
    """Return a typed text as a code, or "" if it cannot be one."""
    code = "".join(text.upper().split()).replace("-", "")
    return code if len(code) == LENGTH and set(code) <= set(SIGNS) else ""


def new_key() -> str:
    return token_urlsafe(24)


class Keys:
    """Keys of rooms and their codes.

    A server accepts only keys made by servers with the same passphrase; without a passphrase anybody can make a key.
    `secret` must be the one of the settings, not one made at the start, because a restarted server must find the same
    code for a key.
    """

    def __init__(self, passphrase: str = "", secret: str = "") -> None:
        self._secret = passphrase.encode()
        self._salt = secret

    def code_of(self, key: str) -> str:
        return code_of(key, self._salt)

    def new_token(self, room: bytes) -> str:
        return new_token(room, self._salt)

    def is_given(self, name: str, room: bytes) -> bool:
        return is_given(name, room, self._salt)

    def new(self) -> str:
        word = new_key()
        return word + self._signature(word)

    def is_own(self, key: str) -> bool:
        word, signature = key[:32], key[32:]
        return hmac.compare_digest(signature.encode(), self._signature(word).encode())

    def _signature(self, word: str) -> str:
        return urlsafe_b64encode(hmac.digest(self._secret, f"key {word}".encode(), "sha256")[:12]).decode()


def new_word() -> str:
    """Return a random word to be read from one screen and typed on another. Its users make it valid once, for a short
    time."""
    return "".join(choice(SIGNS) for _ in range(2 * LENGTH))


def join_key(key: str) -> str:
    """Return the secret in a room's QR code. It is derived from the room's key and cannot be guessed."""
    return sha256(f"join {key}".encode()).hexdigest()[:12]


def digest(key: str) -> bytes:
    """Return the stored hash of a key."""
    return sha256(key.encode()).hexdigest().encode()


def is_key(key: str, kept: bytes) -> bool:
    return bool(kept) and hmac.compare_digest(digest(key), kept)


def new_token(room: bytes, secret: str = "") -> str:
    """Return an anonymous token for a new follower. `room` is the stored hash of the room's key.

    It begins with the follower's name: the time in ms, so that names sort by age, random characters, and a signature
    that shows that a server with this secret made it.
    """
    name = f"{int(1000 * time()):011x}{token_urlsafe(3)[:3]}"
    return _signed(room, name + (_mark(name, room, secret) if secret else token_urlsafe(6)[:MARK]))


def is_given(name: str, room: bytes, secret: str) -> bool:
    """Return True if a server with this secret made the name of a follower; without a secret always True."""
    return not secret or hmac.compare_digest(name[-MARK:].encode(), _mark(name[:-MARK], room, secret).encode())


def _mark(name: str, room: bytes, secret: str) -> str:
    signed = hmac.digest(secret.encode(), b"phone " + room + name.encode(), "sha256")
    return urlsafe_b64encode(signed).decode()[:MARK]


def voter_of(token: str, room: bytes) -> str:
    """Return the name under which a follower's answer is stored, or "" for a token of another room."""
    name, _, _ = token.partition(".")
    return name if name and room and hmac.compare_digest(token.encode(), _signed(room, name).encode()) else ""


def _signed(room: bytes, name: str) -> str:
    return f"{name}.{urlsafe_b64encode(hmac.digest(room, f'follower {name}'.encode(), 'sha256')[:12]).decode()}"
