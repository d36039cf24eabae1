"""The settings of a server: environment variables and options of the same names, checked once, before the start."""

from __future__ import annotations

import argparse
import os
import re
import socket
from collections.abc import Callable, Iterable, Mapping, Sequence
from difflib import get_close_matches
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, get_type_hints
from urllib.parse import quote, urlsplit

import msgspec
from bokeh.server.util import create_hosts_allowlist
from msgspec import Meta

from components.quantities.formatting import excerpt
from components.serving.visitors import networks

SECRET = "bokeh_secret_key"
SECRETS = (SECRET, "redis_password", "class_passphrase")
"""Settings without an option, because every user of a machine can read the command line of a process. Each can be read
from a file: the variable of the same name with _FILE at the end has its path."""
LISTS = ("allowed_origin", "trusted_proxies", "metrics_for")
LONGEST = 8192
"""Maximum number of characters of a value."""
ALIKE = 0.85
"""Similarity (difflib's ratio) from which an unknown name counts as a misspelt setting. SESIONS and SESSIONS have 0.93,
PORT and REPORT 0.8."""
GUESSED = re.compile("secret|passw(or[dt])?|passphrase|change|default|example|bokeh|lecture|oscillations")


class Settings(msgspec.Struct, frozen=True, kw_only=True):
    """The settings of one process. The description of each field says what is allowed."""

    address: Annotated[
        str,
        Meta(
            pattern=r"^[A-Za-z0-9._:%-]*\Z",
            description="the address or host name to listen at, 0.0.0.0 for all addresses of the machine",
        ),
    ] = "localhost"
    port: Annotated[int, Meta(ge=0, le=65535, description="a port from 1 to 65535, or 0 for any free port")] = 5006
    allowed_origin: Annotated[
        tuple[Annotated[str, Meta(pattern=r"^([A-Za-z0-9._*-]{1,253}(:([0-9]{1,5}|\*))?)?\Z")], ...],
        Meta(
            description="the names that visitors use for the server, as host or host:port, separated by commas; ports "
            "from 1 to 65535, names beyond ASCII as xn--..."
        ),
    ] = ()
    bokeh_secret_key: Annotated[
        str,
        Meta(
            min_length=16,
            description="at least 16 characters that nobody guesses, such as `make secret` makes, the same for all "
            "replicas",
        ),
    ] = ""
    trusted_proxies: Annotated[
        tuple[str, ...],
        Meta(
            description="the addresses and networks of proxies whose `X-Forwarded-For` is believed, as 10.0.0.2 or "
            "10.0.0.0/24, separated by commas"
        ),
    ] = ()
    frame_ancestors: Annotated[
        str,
        Meta(
            pattern=r"^(('self'|'none'|\*|https?://[A-Za-z0-9_.:*-]+)( +|\Z))+\Z",
            description="the sites whose frames may show the page: * for all, 'self', 'none', or sites such as "
            "https://course.example, separated by spaces",
        ),
    ] = "'self'"
    metrics_for: Annotated[
        tuple[str, ...],
        Meta(
            description="the addresses and networks that may read /metrics in addition to this machine, separated by "
            "commas"
        ),
    ] = ()
    sessions: Annotated[
        int,
        Meta(ge=1, le=100_000, description="visitors at the same time, 1 to 100000; others wait in a line"),
    ] = 1000
    arrivals: Annotated[
        int,
        Meta(ge=1, le=1_000_000, description="pages that one network may open in a minute, 1 to 1000000"),
    ] = 600
    unused_seconds: Annotated[
        float, Meta(gt=0, le=86400, description="seconds, above 0 to 86400, that a session waits for its visitor")
    ] = 30.0
    notice_seconds: Annotated[
        float,
        Meta(
            ge=0,
            le=8,
            description="seconds, 0 to 8, for which a server that is asked to end still serves while `/readiness` "
            "already says no",
        ),
    ] = 0.0
    log_format: Annotated[Literal["text", "json"], Meta(description="text for people, json for programs")] = "text"
    log_visitors: Annotated[
        bool, Meta(description="true writes visitors' addresses and links into the log, false does not")
    ] = False
    public_url: Annotated[
        str,
        Meta(
            pattern=r"^(https?://[^/?#\s]+(/[^?#\s]*)?)?\Z",
            description="the address that a class joins at, as https://lecture.example/; if empty, the address at "
            "which the instructor opened the page, or this machine's address in its network",
        ),
    ] = ""
    redis_url: Annotated[
        str,
        Meta(
            pattern=r"^((rediss?|unix)://\S+)?\Z",
            description="the Valkey or Redis in which replicas share the rooms of live classes, as "
            "redis://store:6379/0; if empty, this process keeps its rooms to itself",
        ),
    ] = ""
    class_passphrase: Annotated[
        str,
        Meta(
            pattern=r"^(\S.{10,}\S)?\Z",
            description="the passphrase that instructors need to open a live class, at least 12 characters without a "
            "space at either end; if empty, everybody can open one",
        ),
    ] = ""
    redis_password: Annotated[str, Meta(description="the password of the store, if REDIS_URL has none")] = ""
    walks: Annotated[str, Meta(description="a folder with more guided walks; if empty, there are no more")] = ""
    show: Annotated[bool, Meta(description="true opens the page in a browser, false does not")] = False

    def hosts(self, port: int) -> list[str]:
        """The host names that pages may come from, as host:port; by default this machine's own."""
        own = ("localhost", "127.0.0.1", *([here] if self.everywhere and (here := own_address()) else []))
        known: list[str] = create_hosts_allowlist(self.allowed_origin or [f"{name}:{port}" for name in own], port)
        return known

    @property
    def store(self) -> str:
        """The address of the store that replicas share, with its password."""
        kind, _, place = self.redis_url.partition("://")
        if not place or "@" in place or not self.redis_password:
            return self.redis_url
        return f"{kind}://:{quote(self.redis_password, safe='')}@{place}"

    def known_at(self, port: int) -> str:
        """The address that phones type, or "" if none reaches this machine."""
        here = own_address() if self.everywhere else ""
        return self.public_url or (f"http://{here}:{port}/" if here else "")

    @property
    def everywhere(self) -> bool:
        """Return True if the server listens at all addresses of its machine."""
        return self.address in ("", "0.0.0.0", "::")


def own_address() -> str:
    """Return the address of this machine in its network, or "". No packet is sent to find it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))
            name: str = probe.getsockname()[0]
        except OSError:
            return ""
    return name


PLAIN = Settings()
HINTS: Mapping[str, Any] = get_type_hints(Settings, include_extras=True)


KNOWN = frozenset(name.upper() for name in HINTS) | {f"{name.upper()}_FILE" for name in SECRETS}
"""The names of all environment variables that are read."""


def read_settings(arguments: Sequence[str], environment: Mapping[str, str]) -> Settings:
    """Return the settings that a command line and an environment give. An option wins; an empty variable is ignored.

    Raises ValueError, with a reason, for a value that is not allowed.
    """
    given = _in_environment(environment)
    given |= {name: text for name, text in vars(_options().parse_args(arguments)).items() if text is not None}
    for name, text in given.items():
        _check_text(name, text)
    settings = Settings(**{name: _converted(name, text) for name, text in given.items()})
    for name, check in CHECKS.items():
        try:
            check(settings)
        except ValueError as error:
            raise ValueError(_refusal(name, given[name])) from error
    return settings


def misspelt(environment: Mapping[str, str]) -> list[str]:
    """Return a sentence for each variable whose name looks like a misspelt setting.

    Other variables belong to other programs: a container engine or a shell sets hundreds.
    """
    found = {name: _nearest(name.upper()) for name in sorted(environment.keys() - KNOWN)}
    return [
        f"{excerpt(name)} is not a setting and has no effect. Did you mean {known}?"
        for name, known in found.items()
        if known
    ]


def _nearest(name: str) -> str:
    """Return the known name that resembles a name, "" if none does. Only secrets are read from files."""
    for text in (name, name.removesuffix("_FILE")):
        for known in get_close_matches(text, KNOWN, 1, ALIKE):
            return known
    return ""


def _in_environment(environment: Mapping[str, str]) -> dict[str, str]:
    given = {name: environment[name.upper()] for name in HINTS if environment.get(name.upper())}
    for name in SECRETS:
        variable = f"{name.upper()}_FILE"
        if (path := environment.get(variable)) and name not in given:
            given[name] = _secret_in(variable, path)
    return given


def _secret_in(variable: str, path: str) -> str:
    """Return the secret in a file, which is how container engines pass one."""
    try:
        secret = (
            Path(path).read_text(encoding="utf-8-sig").strip()
        )  # some editors write a byte order mark at the beginning of a file
    except (OSError, ValueError) as error:
        raise ValueError(f"{variable} names “{excerpt(path)}”, which cannot be read.") from error
    if not secret:
        raise ValueError(f"{variable} names “{excerpt(path)}”, which is empty.")
    return secret


def _check_text(name: str, text: str) -> None:
    """Raise ValueError for text that cannot be a value of a setting. A secret may contain any character."""
    if len(text) > LONGEST:
        raise ValueError(f"{name.upper()} has {len(text)} characters. Allowed: at most {LONGEST}.")
    if name != SECRET and not text.isprintable():
        raise ValueError(f"{name.upper()} contains a line break or another character that cannot be printed.")


def _check_ports(urls: Iterable[str]) -> None:
    """Raise ValueError for a port that is neither * nor from 1 to 65535."""
    for url in urls:
        if urlsplit(url.removesuffix(":*")).port == 0:
            raise ValueError("There is no port 0.")


def _check_origins(settings: Settings) -> None:
    settings.hosts(settings.port)
    _check_ports(f"//{name}" for name in settings.allowed_origin)


def _check_store(url: str) -> None:
    """Raise ValueError if the address cannot be a store's. Makes no connection."""
    if not url:
        return
    from redis.asyncio import Redis  # takes time, and most servers have no store
    from redis.exceptions import RedisError

    found = urlsplit(url)
    if found.scheme != "unix" and not re.fullmatch("/?[0-9]{0,5}", found.path):
        raise ValueError("The name of a store is a number.")
    _check_ports([url])
    try:
        Redis.from_url(url).connection_pool.make_connection()  # type: ignore[no-untyped-call]  # redis' own
    except (TypeError, AttributeError, RedisError) as error:  # of an unknown option
        raise ValueError(str(error)) from error


def _check_secret(secret: str) -> None:
    """Raise ValueError for a secret that is easy to guess: common words, few or consecutive characters."""
    if not secret:  # an empty secret: the server makes one when it starts
        return
    rest = GUESSED.sub("", secret.lower())
    steps = {ord(after) - ord(before) for before, after in pairwise(secret)}
    if len(rest) < 10 or len(set(secret)) < 8 or len(steps) < 8:
        raise ValueError("This secret can be guessed.")
    secret.encode()  # UnicodeEncodeError for bytes that are not UTF-8


def _check_folder(path: str) -> None:
    if path and not os.path.isdir(path):
        raise ValueError("There is no such folder.")


CHECKS: Mapping[str, Callable[[Settings], object]] = {
    "address": lambda settings: settings.address.encode("idna"),
    "allowed_origin": _check_origins,
    "trusted_proxies": lambda settings: networks(settings.trusted_proxies),
    "metrics_for": lambda settings: networks(settings.metrics_for),
    "frame_ancestors": lambda settings: _check_ports(settings.frame_ancestors.split()),
    "public_url": lambda settings: _check_ports([settings.public_url]),
    "redis_url": lambda settings: _check_store(settings.redis_url),
    "walks": lambda settings: _check_folder(settings.walks),
    SECRET: lambda settings: _check_secret(settings.bokeh_secret_key),
}
"""Checks beyond a field's own limits: each raises ValueError."""


def table() -> str:
    """Return the settings and their defaults as a Markdown table."""
    rows = [f"| `{name.upper()}` | {_default(name)} | {describe(name)} |" for name in HINTS]
    return "\n".join(["| setting | default | |", "|---|---|---|", *rows])


def _default(name: str) -> str:
    if name == SECRET:
        return "made at start"
    value = getattr(PLAIN, name)
    if name in LISTS:
        return "this machine" if name == "allowed_origin" else "none"
    return f"{value:g}" if isinstance(value, float) else str(value).lower()


def describe(name: str) -> str:
    """Return, in words, which values a setting may have."""
    (meta,) = HINTS[name].__metadata__
    return str(meta.description)


def _options() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m components.serving",
        description="Serves the lecture. Each option can be given as an environment variable too: PORT for --port.",
    )
    for name in HINTS:
        if name not in SECRETS:
            flag = {"nargs": "?", "const": "true"} if isinstance(getattr(PLAIN, name), bool) else {}
            parser.add_argument(f"--{name.replace('_', '-')}", help=describe(name), **flag)  # type: ignore[arg-type]
    return parser


def _converted(name: str, text: str) -> Any:
    value: object = [part.strip() for part in text.split(",")] if name in LISTS else text
    try:
        return msgspec.convert(value, HINTS[name], strict=False)
    except msgspec.ValidationError as error:
        raise ValueError(_refusal(name, text)) from error


def _refusal(name: str, text: str) -> str:
    may_hold_password = name in SECRETS or "@" in text
    shown = "not what it should be" if may_hold_password else f"“{excerpt(text)}”"
    return f"{name.upper()} is {shown}. Allowed: {describe(name)}."
