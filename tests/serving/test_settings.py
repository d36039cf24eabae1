"""The settings: from options and environment variables, each checked before the server starts."""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from secrets import token_hex, token_urlsafe

import pytest
from bokeh.settings import settings as bokeh_settings

from components.serving.__main__ import tell
from components.serving.headers import policy
from components.serving.settings import (
    HINTS,
    LISTS,
    LONGEST,
    SECRETS,
    Settings,
    describe,
    misspelt,
    read_settings,
    table,
)
from components.serving.visitors import networks
from tests.serving.server import ROOT, START, serving


def test_defaults_are_for_ones_own_machine() -> None:
    settings = read_settings([], {})
    assert (settings.address, settings.port, settings.show) == ("localhost", 5006, False)
    assert settings.hosts(5006) == ["localhost:5006", "127.0.0.1:5006"]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_the_start_prints_the_address_for_phones_and_a_qr_code(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level("INFO")
    for address, public, here, known in (
        ("0.0.0.0", "", "192.0.2.7", "http://192.0.2.7:5006/"),
        ("0.0.0.0", "https://lecture.example/", "192.0.2.7", "https://lecture.example/"),
        ("0.0.0.0", "", "", ""),
        ("localhost", "", "192.0.2.7", ""),
    ):
        caplog.clear()
        terminal = Terminal()
        monkeypatch.setattr("sys.stderr", terminal)
        monkeypatch.setattr("components.serving.settings.own_address", lambda here=here: here)
        assert tell(Settings(address=address, public_url=public), 5006) == "http://localhost:5006/"
        assert (f"Phones type {known}" in caplog.messages) is ("█" in terminal.getvalue()) is bool(known)
        assert any("PUBLIC_URL" in line for line in caplog.messages) is (address == "0.0.0.0" and not known)


def test_an_option_wins_over_the_environment_and_an_empty_variable_is_not_given() -> None:
    environment = {"PORT": "8000", "ADDRESS": "", "UNUSED_SECONDS": "7"}
    settings = read_settings(["--port", "9000", "--show"], environment)
    assert (settings.port, settings.address, settings.unused_seconds, settings.show) == (9000, "localhost", 7.0, True)


def test_origins_are_a_list() -> None:
    settings = read_settings([], {"ALLOWED_ORIGIN": "lecture.example, second.example:8000"})
    assert settings.hosts(5006) == ["lecture.example:80", "second.example:8000"]


@pytest.mark.parametrize("text", ["'self'", "*", "https://course.example https://*.example:8443", "'none'"])
def test_frames_are_named_as_in_the_header(text: str) -> None:
    assert read_settings([], {"FRAME_ANCESTORS": text}).frame_ancestors == text


WRONG = {
    "PORT": ("70000", "http"),
    "UNUSED_SECONDS": ("0", "nan"),
    "NOTICE_SECONDS": ("9",),
    "SESSIONS": ("many",),
    "ARRIVALS": ("0",),
    "SHOW": ("perhaps",),
    "LOG_FORMAT": ("xml",),
    "LOG_VISITORS": ("some",),
    "FRAME_ANCESTORS": (
        *("*; script-src *", "course.example", "https://course.example:99999", "https://пример.example"),
    ),
    "ALLOWED_ORIGIN": (
        *("a:b:c", "lecture.example,", "https://lecture.example", "lecture.example/oscillations"),
        *("lecture.example second.example", "lecture.example:99999", "lecture.example:0", "schön.example"),
    ),
    "TRUSTED_PROXIES": ("proxy.example", "10.0.0.1/24"),
    "METRICS_FOR": ("prometheus",),
    "PUBLIC_URL": ("lecture.example", "https://lecture.example:99999/", "https://[::1"),
    "REDIS_URL": (
        *("http://store", "redis://store:99999/0", "redis://store:port/0", "redis://store/lecture"),
        *("redis://store/0?colour=red", "redis://[store/0", "redis://store:0/0", "redis://store/999999"),
    ),
    "ADDRESS": ("local host", "lecture..example"),
    "WALKS": ("/nowhere/walks",),
}
OTHERWISE = set(SECRETS)
"""A secret does not appear in the refusal."""


def test_each_setting_is_tried_with_a_wrong_value() -> None:
    assert {name.lower() for name in WRONG} | OTHERWISE == set(HINTS)


@pytest.mark.parametrize(("name", "text"), [(name, text) for name, texts in WRONG.items() for text in texts])
def test_a_value_that_is_not_allowed_is_refused_with_what_is(name: str, text: str) -> None:
    with pytest.raises(ValueError) as refusal:
        read_settings([], {name: text})
    assert str(refusal.value) == f"{name} is “{text}”. Allowed: {describe(name.lower())}."


MALFORMED = [
    *(" ", 16 * " ", ",", ",,", "*", "%", "'", '"', "../..", "true ", "'self'\n", "a\nb", "\0", "\x1b[31m", "\u202e"),
    *("nan", "inf", "-inf", "1e999", "1e308", "5e-324", "-1", "0", "1.5", 5000 * "9", "٣", "x:٣"),
    *("x" * 70, "x" * 5000, "x" * 100_000, "a..b", "\udcff" * 20, "schön.example", "https://пример.example"),
    *("x:0", "x:99999", "https://x:99999", "[::1", "https://[::1", "http://", "10.0.0.0/99", "10.0.0.1/24", "::/129"),
    *("redis://x:0/0", "redis://x/" + 30 * "9", "redis://x:1:2", "redis://\udcff", "unix://"),
]


def usable(settings: Settings) -> bool:
    """Return True if a server can use the settings: none of its later uses of them raises."""
    settings.hosts(settings.port)
    networks((*settings.trusted_proxies, *settings.metrics_for))
    policy(settings.frame_ancestors).encode("ascii")  # a header
    texts = [value for name in HINTS if isinstance(value := getattr(settings, name), str)]
    numbers = (settings.unused_seconds, settings.notice_seconds)
    return all(text.encode() or True for text in texts) and all(number < 1e5 for number in numbers)


@pytest.mark.parametrize("name", HINTS)
def test_a_malformed_value_is_refused_in_a_sentence_or_can_be_used(name: str) -> None:
    refused = 0
    for text in MALFORMED:
        try:
            settings = read_settings([], {name.upper(): text})
        except ValueError as refusal:
            said = str(refusal)
            refused += 1
            assert type(refusal) is ValueError and said.startswith(f"{name.upper()} ") and said.endswith(".")
            assert said.isprintable() and len(said) < 400
            assert name not in SECRETS or len(text) < 8 or text not in said
        else:
            assert usable(settings)
            assert name in LISTS or text.strip() == text or name == "redis_password"
    assert refused > 5


@pytest.mark.parametrize("name", SECRETS)
@pytest.mark.parametrize("content", ["", " \n\t\n", "\ufeff"])
def test_an_empty_file_is_no_secret(tmp_path: Path, name: str, content: str) -> None:
    (path := tmp_path / "secret").write_text(content, encoding="utf-8")
    variable = f"{name.upper()}_FILE"
    with pytest.raises(ValueError) as refusal:
        read_settings([], {variable: str(path)})
    assert str(refusal.value).startswith(f"{variable} names “") and str(refusal.value).endswith("which is empty.")


def test_a_value_has_a_length_that_can_be_shown() -> None:
    with pytest.raises(ValueError) as refusal:
        read_settings([], {"CLASS_PASSPHRASE": "x" * (LONGEST + 1)})
    assert str(refusal.value) == f"CLASS_PASSPHRASE has {LONGEST + 1} characters. Allowed: at most {LONGEST}."


MISSPELT = {
    **{"SESIONS": "SESSIONS", "SESSION": "SESSIONS", "sessions": "SESSIONS", "ADRESS": "ADDRESS", "PORTS": "PORT"},
    **{"ALLOWED_ORIGINS": "ALLOWED_ORIGIN", "ALLOW_ORIGIN": "ALLOWED_ORIGIN", "TRUSTED_PROXY": "TRUSTED_PROXIES"},
    **{"NOTICE_SECS": "NOTICE_SECONDS", "LOGFORMAT": "LOG_FORMAT", "REDIS_URI": "REDIS_URL", "WALK": "WALKS"},
    **{"CLASS_PASSPHRASES": "CLASS_PASSPHRASE", "CLASS_PASSPHRAS_FILE": "CLASS_PASSPHRASE_FILE"},
    **{"BOKEH_SECRET": "BOKEH_SECRET_KEY", "BOKEH_SECRETKEY_FILE": "BOKEH_SECRET_KEY_FILE"},
    **{"PORT_FILE": "PORT", "REDIS_URL_FILE": "REDIS_URL", "PUBLIC_URLS": "PUBLIC_URL", "ARIVALS": "ARRIVALS"},
}


def test_a_misspelt_name_is_named_with_the_one_that_is_meant() -> None:
    said = [f"{name} is not a setting and has no effect. Did you mean {known}?" for name, known in MISSPELT.items()]
    assert misspelt(dict.fromkeys(MISSPELT, "5")) == sorted(said)


@pytest.mark.parametrize("name", [*HINTS, *(f"{name}_file" for name in SECRETS)])
def test_each_name_is_known_and_its_double_letter_or_missing_letter_is_named(name: str) -> None:
    known = name.upper()
    assert misspelt({known: "5"}) == []
    for wrong in (f"{known[:2]}{known[1:]}", f"{known}{known[-1]}", f"{known[:2]}{known[3:]}"):
        assert len(misspelt({wrong: "5"})) == 1, wrong


SERVICES = ["LECTURE", "STORE", "REDIS", "VALKEY", "SESSION", "PUBLIC", "CLASS", "PORT", "WALKS", "SHOW", "ADDRESS"]
PORTS = ["PORT", *(f"PORT_5006_TCP{part}" for part in ("", "_ADDR", "_PORT", "_PROTO"))]
INJECTED = [*PORTS, "SERVICE_HOST", "SERVICE_PORT", "SERVICE_PORT_HTTP"]
"""Names that Kubernetes creates for each service."""
OTHERS = {
    *(setting.env_var for name, setting in vars(type(bokeh_settings)).items() if hasattr(setting, "env_var")),
    *(f"{service}_{more}" for service in SERVICES for more in INJECTED),
    *("PATH", "HOME", "HOST", "HOSTNAME", "PWD", "OLDPWD", "SHELL", "SHLVL", "TERM", "USER", "LANG", "LC_ALL", "TZ"),
    *("DISPLAY", "EDITOR", "MAIL", "LOGNAME", "PAGER", "SSH_TTY", "GDMSESSION", "SESSION_MANAGER", "DESKTOP_SESSION"),
    *("XDG_SESSION_ID", "DBUS_SESSION_BUS_ADDRESS", "SESSIONNAME", "PROMPT", "WINDIR", "NOTIFY_SOCKET", "LISTEN_FDS"),
    *("PYTHONPATH", "PYTHONHASHSEED", "PYTHON_VERSION", "VIRTUAL_ENV", "BOKEH_DEV", "PANEL_LOG_LEVEL", "REDIS_HOST"),
    *("SECRET_KEY", "DATABASE_URL", "LOG_LEVEL", "HTTP_PROXY", "NO_PROXY", "REPORT", "EXPORT", "SUPPORT", "REDIS_PORT"),
}


def test_names_of_other_programs_raise_no_alarm() -> None:
    assert len(OTHERS) > 150 and "BOKEH_SECRET_KEY" in OTHERS and "PORT_PORT" in OTHERS
    assert misspelt(dict.fromkeys(OTHERS, "5")) == []


def test_the_log_says_first_that_the_server_starts_and_names_a_misspelt_variable(tmp_path: Path) -> None:
    with serving(tmp_path / "log", environment={"SESIONS": "5"}) as server:
        lines = server.log.read_text().splitlines()
    assert lines[0].endswith("The server starts")
    assert [line for line in lines if "WARNING" in line and "Did you mean SESSIONS?" in line]


def test_a_refused_secret_is_not_repeated() -> None:
    with pytest.raises(ValueError, match="BOKEH_SECRET_KEY is not what") as refusal:
        read_settings([], {"BOKEH_SECRET_KEY": "too short"})
    assert "too short" not in str(refusal.value)
    with pytest.raises(ValueError, match="REDIS_URL is not what") as refusal:
        read_settings([], {"REDIS_URL": "http://:pass@store"})
    assert "pass@" not in str(refusal.value)


GUESSED = [
    *("passwordpassword", "changemechangeme", "my-secret-password", "abcdefghijklmnop", "1234567890123456"),
    *("aaaaaaaaaaaaaaaaaaaaaaaa", "oscillations-lecture-secret"),
]


@pytest.mark.parametrize("secret", GUESSED)
def test_a_secret_that_can_be_guessed_is_refused_in_words(secret: str) -> None:
    with pytest.raises(ValueError, match=r"BOKEH_SECRET_KEY is not what .* that nobody guesses") as refusal:
        read_settings([], {"BOKEH_SECRET_KEY": secret})
    assert secret not in str(refusal.value)


@pytest.mark.parametrize("make", [partial(token_hex, 16), partial(token_urlsafe, 16), partial(token_urlsafe, 32)])
def test_a_secret_made_at_random_is_taken(make: Callable[[], str]) -> None:
    for _ in range(40):
        secret = make()
        assert read_settings([], {"BOKEH_SECRET_KEY": secret}).bokeh_secret_key == secret


def test_a_wrong_value_stops_the_start_with_a_sentence() -> None:
    command = [sys.executable, *START, "--port", "none"]
    ended = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60)
    assert ended.returncode != 0
    assert ended.stderr.startswith("PORT is “none”.")
    assert "Traceback" not in ended.stderr


def test_the_secret_may_be_in_a_file(tmp_path: Path) -> None:
    path = tmp_path / "secret"
    path.write_text("a secret of sixteen letters\n")
    assert read_settings([], {"BOKEH_SECRET_KEY_FILE": str(path)}).bokeh_secret_key == "a secret of sixteen letters"
    for name in ("BOKEH_SECRET_KEY_FILE", "REDIS_PASSWORD_FILE"):
        with pytest.raises(ValueError, match=f"{name} names “/nowhere/secret”"):
            read_settings([], {name: "/nowhere/secret"})


@pytest.mark.parametrize(
    ("url", "asked"),
    [
        ("redis://store:6379/0", "redis://:a%2Fb%2B%3D@store:6379/0"),
        ("redis://:own@store:6379/0", "redis://:own@store:6379/0"),
        ("", ""),
    ],
)
def test_the_stores_password_may_be_in_a_file_but_the_address_wins(tmp_path: Path, url: str, asked: str) -> None:
    (tmp_path / "password").write_text("a/b+=\n")
    assert read_settings([], {"REDIS_URL": url, "REDIS_PASSWORD_FILE": str(tmp_path / "password")}).store == asked


def test_the_table_of_settings_is_current() -> None:
    assert table() in (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8"), "run make readme"
    assert all(f"| `{name.upper()}` | " in table() for name in HINTS)
