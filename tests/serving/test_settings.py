"""The settings: from options and the environment, each value checked before anything starts."""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from secrets import token_hex, token_urlsafe

import pytest

from components.serving.__main__ import tell
from components.serving.settings import HINTS, SECRETS, Settings, describe, read_settings, table
from tests.serving.server import ROOT, START


def test_defaults_are_for_ones_own_machine() -> None:
    settings = read_settings([], {})
    assert (settings.address, settings.port, settings.show) == ("localhost", 5006, False)
    assert settings.hosts(5006) == ["localhost:5006", "127.0.0.1:5006"]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_the_start_tells_phones_their_address_and_a_terminal_its_qr_code(
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


def test_a_secret_is_made_for_each_start() -> None:
    assert read_settings([], {}).bokeh_secret_key != read_settings([], {}).bokeh_secret_key


WRONG = [
    ("PORT", "70000"),
    ("PORT", "http"),
    ("UNUSED_SECONDS", "0"),
    ("UNUSED_SECONDS", "nan"),
    ("NOTICE_SECONDS", "9"),
    ("SESSIONS", "many"),
    ("ARRIVALS", "0"),
    ("SHOW", "perhaps"),
    ("LOG_FORMAT", "xml"),
    ("LOG_VISITORS", "some"),
    ("FRAME_ANCESTORS", "*; script-src *"),
    ("FRAME_ANCESTORS", "course.example"),
    ("ALLOWED_ORIGIN", "a:b:c"),
    ("ALLOWED_ORIGIN", "lecture.example,"),
    ("ALLOWED_ORIGIN", "https://lecture.example"),
    ("ALLOWED_ORIGIN", "lecture.example/oscillations"),
    ("ALLOWED_ORIGIN", "lecture.example second.example"),
    ("TRUSTED_PROXIES", "proxy.example"),
    ("TRUSTED_PROXIES", "10.0.0.1/24"),
    ("METRICS_FOR", "prometheus"),
    ("PUBLIC_URL", "lecture.example"),
    ("REDIS_URL", "http://store"),
    ("REDIS_URL", "redis://store:99999/0"),
    ("REDIS_URL", "redis://store:port/0"),
    ("REDIS_URL", "redis://store/lecture"),
    ("REDIS_URL", "redis://store/0?colour=red"),
    ("REDIS_URL", "redis://[store/0"),
]
OTHERWISE = {"address", "walks", *SECRETS}
"""An address is tried, a folder read, and a secret not repeated."""


def test_each_setting_is_tried_with_a_wrong_value() -> None:
    assert {name.lower() for name, _ in WRONG} | OTHERWISE == set(HINTS)


@pytest.mark.parametrize(("name", "text"), WRONG)
def test_a_value_that_is_not_allowed_is_refused_with_what_is(name: str, text: str) -> None:
    with pytest.raises(ValueError) as refusal:
        read_settings([], {name: text})
    assert str(refusal.value) == f"{name} is “{text}”. Allowed: {describe(name.lower())}."


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


def test_the_secret_may_stand_in_a_file(tmp_path: Path) -> None:
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
def test_the_stores_password_stands_in_a_file_and_its_addresss_own_wins(tmp_path: Path, url: str, asked: str) -> None:
    (tmp_path / "password").write_text("a/b+=\n")
    assert read_settings([], {"REDIS_URL": url, "REDIS_PASSWORD_FILE": str(tmp_path / "password")}).store == asked


def test_the_table_of_settings_is_current() -> None:
    assert table() in (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8"), "run make readme"
    assert all(f"| `{name.upper()}` | " in table() for name in HINTS)
