"""The settings of a server: environment variables and options of the same names, checked once, before the start."""

from __future__ import annotations

import argparse
import re
import socket
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from secrets import token_urlsafe
from typing import Annotated, Any, Literal, get_type_hints
from urllib.parse import quote, urlsplit

import msgspec
from bokeh.server.util import create_hosts_allowlist
from msgspec import Meta

from components.serving.visitors import networks

SECRET = "bokeh_secret_key"
SECRETS = (SECRET, "redis_password", "class_passphrase")
"""Settings that are no options: every user of a machine can read the command line of a process. Each may stand in a
file, whose path is in a variable of the same name and _FILE."""
LISTS = ("allowed_origin", "trusted_proxies", "metrics_for")
GUESSED = re.compile("secret|passw(or[dt])?|passphrase|change|default|example|bokeh|lecture|oscillations")


class Settings(msgspec.Struct, frozen=True, kw_only=True):
    """The settings of one process. The description of each field says what is allowed."""

    address: Annotated[str, Meta(description="the address to listen at, 0.0.0.0 for all of this machine's")] = (
        "localhost"
    )
    port: Annotated[int, Meta(ge=0, le=65535, description="a port from 1 to 65535, or 0 for any that is free")] = 5006
    allowed_origin: Annotated[
        tuple[Annotated[str, Meta(pattern=r"^([^\s/:@?#]+(:(\d{1,5}|\*))?)?$")], ...],
        Meta(description="the names that visitors know the server by, as host or host:port, with commas between them"),
    ] = ()
    bokeh_secret_key: Annotated[
        str,
        Meta(
            min_length=16,
            description="at least 16 characters that nobody guesses, as `make secret` makes them, the same for all "
            "replicas",
        ),
    ] = msgspec.field(default_factory=token_urlsafe)
    trusted_proxies: Annotated[
        tuple[str, ...],
        Meta(
            description="the addresses and networks of the proxies whose word on where a visitor comes from is taken, "
            "as 10.0.0.2 or 10.0.0.0/24, with commas between them"
        ),
    ] = ()
    frame_ancestors: Annotated[
        str,
        Meta(
            pattern=r"^(('self'|'none'|\*|https?://[\w.:*-]+)( +|$))+$",
            description="whose frames may show the page: * for anybody's, 'self', 'none', or https://course.example "
            "and more with spaces between them",
        ),
    ] = "'self'"
    metrics_for: Annotated[
        tuple[str, ...],
        Meta(
            description="the addresses and networks that may read /metrics, besides this machine, with commas between "
            "them"
        ),
    ] = ()
    sessions: Annotated[
        int, Meta(ge=1, le=100_000, description="visitors at once, 1 to 100000; the next ones wait in a line")
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
        Meta(ge=0, le=8, description="seconds, 0 to 8, between being not ready and sending visitors away at the end"),
    ] = 0.0
    log_format: Annotated[Literal["text", "json"], Meta(description="text for people, json for programs")] = "text"
    log_visitors: Annotated[
        bool, Meta(description="true writes visitors' addresses and links into the log, false does not")
    ] = False
    public_url: Annotated[
        str,
        Meta(
            pattern=r"^(https?://[^/?#\s]+(/[^?#\s]*)?)?$",
            description="the address that a class joins at, as https://lecture.example/; where empty, the one that the "
            "instructor's page was opened at, or this machine's in its network",
        ),
    ] = ""
    redis_url: Annotated[
        str,
        Meta(
            pattern=r"^((rediss?|unix)://\S+)?$",
            description="the Valkey or Redis in which replicas share the rooms of live classes, as "
            "redis://store:6379/0; where empty, this process keeps its own",
        ),
    ] = ""
    class_passphrase: Annotated[
        str,
        Meta(
            pattern=r"^(.{12,})?$",
            description="the instructors' passphrase, at least 12 characters, without which nobody opens a live class; "
            "where empty, everybody may",
        ),
    ] = ""
    redis_password: Annotated[str, Meta(description="its password, where REDIS_URL has none")] = ""
    walks: Annotated[str, Meta(description="a folder of more guided walks, none where empty")] = ""
    show: Annotated[bool, Meta(description="true opens the page in a browser, false does not")] = False

    def hosts(self, port: int) -> list[str]:
        """The names that pages may come from, as host:port; by default this machine's own."""
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
        """The address that phones type; "" where none reaches this machine."""
        here = own_address() if self.everywhere else ""
        return self.public_url or (f"http://{here}:{port}/" if here else "")

    @property
    def everywhere(self) -> bool:
        """Whether the server listens at all addresses of its machine."""
        return self.address in ("", "0.0.0.0", "::")


def own_address() -> str:
    """The address of this machine in its network; "" where it has none. Nothing is sent to find it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))
            name: str = probe.getsockname()[0]
        except OSError:
            return ""
    return name


PLAIN = Settings()
HINTS: Mapping[str, Any] = get_type_hints(Settings, include_extras=True)


def read_settings(arguments: Sequence[str], environment: Mapping[str, str]) -> Settings:
    """The settings that a command line and an environment ask for; an option wins, an empty variable is not given.

    ValueError, in a sentence, for a value that is not allowed.
    """
    given = {name: environment[name.upper()] for name in HINTS if environment.get(name.upper())}
    for name in SECRETS:
        variable = f"{name.upper()}_FILE"
        if (path := environment.get(variable)) and name not in given:
            given[name] = _secret_in(variable, path)
    given |= {name: text for name, text in vars(_options().parse_args(arguments)).items() if text is not None}
    settings = Settings(**{name: _converted(name, text) for name, text in given.items()})
    for name, check in (
        ("allowed_origin", lambda: settings.hosts(settings.port)),
        ("trusted_proxies", lambda: networks(settings.trusted_proxies)),
        ("metrics_for", lambda: networks(settings.metrics_for)),
        ("redis_url", lambda: _check_store(settings.redis_url)),
        (SECRET, lambda: _check_secret(settings.bokeh_secret_key)),
    ):
        try:
            check()
        except ValueError as error:
            raise ValueError(_refusal(name, given[name])) from error
    return settings


def _check_store(url: str) -> None:
    """ValueError where there can be no store at an address; none is asked, and its client is read only where one is."""
    if not url:
        return
    from redis.asyncio import Redis
    from redis.exceptions import RedisError

    found = urlsplit(url)
    if found.scheme != "unix" and not re.fullmatch(r"/?\d*", found.path):
        raise ValueError("The name of a store is a number.")
    try:
        Redis.from_url(url).connection_pool.make_connection()  # type: ignore[no-untyped-call]  # redis' own
    except (TypeError, AttributeError, RedisError) as error:  # of an option that there is not
        raise ValueError(str(error)) from error


def _secret_in(variable: str, path: str) -> str:
    """The secret in a file, which is how container engines hand one over."""
    try:
        return Path(path).read_text(encoding="utf-8").strip()
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"{variable} names “{path}”, which cannot be read.") from error


def _check_secret(secret: str) -> None:
    """ValueError for one that can be guessed: words that stand in every list, few characters, characters in a row."""
    rest = GUESSED.sub("", secret.lower())
    steps = {ord(after) - ord(before) for before, after in pairwise(secret)}
    if len(rest) < 10 or len(set(secret)) < 8 or len(steps) < 8:
        raise ValueError("This secret can be guessed.")


def table() -> str:
    """The settings with what is theirs by default, in Markdown."""
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
    """The values that are allowed for a setting, in words."""
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
    shown = "not what it should be" if name in SECRETS or "@" in text else f"“{text}”"  # a URL may have a password
    return f"{name.upper()} is {shown}. Allowed: {describe(name)}."
