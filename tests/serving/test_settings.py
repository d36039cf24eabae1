"""The settings: from options and environment variables, each checked before the server starts."""

import io
import sys
from pathlib import Path

import pytest
from bokeh.settings import settings as bokeh_settings

from components.serving.__main__ import main, tell
from components.serving.headers import policy
from components.serving.settings import HINTS, LISTS, SECRETS, Settings, describe, misspelt, read_settings, table
from components.serving.visitors import networks
from tests.serving.server import ROOT

SECRET = "a secret of sixteen letters"


def test_defaults_are_for_ones_own_machine_and_an_option_wins_over_a_variable() -> None:
    settings = read_settings([], {"ADDRESS": ""})
    assert (settings.address, settings.port, settings.show) == ("localhost", 5006, False)
    assert settings.hosts(5006) == ["localhost:5006", "127.0.0.1:5006"]
    settings = read_settings(["--port", "9000", "--show"], {"PORT": "8000", "ALLOWED_ORIGIN": "one.example, two:80"})
    assert (settings.port, settings.show, settings.hosts(5006)) == (9000, True, ["one.example:80", "two:80"])


STORE, OWN, FILE = "redis://store:6379/0", "redis://:own@store:6379/0", {"REDIS_PASSWORD_FILE": "a/b+=\n"}
SITES = ("'self'", "*", "https://course.example https://*.example:8443", "'none'")


@pytest.mark.parametrize(
    ("environment", "name", "value"),
    [
        *(({"FRAME_ANCESTORS": text}, "frame_ancestors", text) for text in SITES),
        ({"UNUSED_SECONDS": "7"}, "unused_seconds", 7.0),
        ({"BOKEH_SECRET_KEY_FILE": f" {SECRET}\n"}, "bokeh_secret_key", SECRET),
        ({**FILE, "REDIS_URL": STORE}, "store", "redis://:a%2Fb%2B%3D@store:6379/0"),
        ({**FILE, "REDIS_URL": OWN}, "store", OWN),
        (FILE, "store", ""),
        ({"BOKEH_SECRET_KEY_FILE": " \n\t\n"}, "", "which is empty."),
        ({"CLASS_PASSPHRASE_FILE": "\ufeff"}, "", "which is empty."),
        ({"REDIS_PASSWORD_FILE": ""}, "", "which is empty."),
    ],
)
def test_a_value_may_be_in_a_file(environment: dict[str, str], name: str, value: object, tmp_path: Path) -> None:
    files = [variable for variable in environment if variable.endswith("_FILE")]
    given = environment | {variable: str(tmp_path / variable) for variable in files}
    for variable in files:
        with pytest.raises(ValueError, match=rf"^{variable} names “.*which cannot be read\.$"):
            read_settings([], given)
        (tmp_path / variable).write_text(environment[variable], encoding="utf-8")
    if name:
        assert getattr(read_settings([], given), name) == value
    else:
        with pytest.raises(ValueError, match=rf"^{files[0]} names “.*{value}$"):
            read_settings([], given)


@pytest.mark.parametrize(
    ("address", "public", "here", "known"),
    [
        ("0.0.0.0", "", "192.0.2.7", "http://192.0.2.7:5006/"),
        ("0.0.0.0", "https://lecture.example/", "192.0.2.7", "https://lecture.example/"),
        ("0.0.0.0", "", "", ""),
        ("localhost", "", "192.0.2.7", ""),
    ],
)
def test_the_start_prints_the_address_for_phones_and_a_qr_code(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, address: str, public: str, here: str, known: str
) -> None:
    caplog.set_level("INFO")
    terminal = io.StringIO()
    terminal.isatty = lambda: True
    monkeypatch.setattr("sys.stderr", terminal)
    monkeypatch.setattr("components.serving.settings.own_address", lambda: here)
    assert tell(Settings(address=address, public_url=public), 5006) == "http://localhost:5006/"
    assert (f"Phones type {known}" in caplog.messages) is ("█" in terminal.getvalue()) is bool(known)
    assert any("PUBLIC_URL" in line for line in caplog.messages) is (address == "0.0.0.0" and not known)


WRONG = {
    "PORT": "70000|http",
    "UNUSED_SECONDS": "0|nan",
    "NOTICE_SECONDS": "9",
    "SESSIONS": "many",
    "ARRIVALS": "0",
    "SHOW": "perhaps",
    "LOG_FORMAT": "xml",
    "LOG_VISITORS": "some",
    "FRAME_ANCESTORS": "*; script-src *|course.example|https://course.example:99999|https://пример.example",
    "ALLOWED_ORIGIN": "a:b:c|lecture.example,|https://lecture.example|lecture.example/oscillations|schön.example|"
    "lecture.example second.example|lecture.example:99999|lecture.example:0",
    "TRUSTED_PROXIES": "proxy.example|10.0.0.1/24",
    "METRICS_FOR": "prometheus",
    "PUBLIC_URL": "lecture.example|https://lecture.example:99999/|https://[::1",
    "REDIS_URL": "http://store|http://:pass@store|redis://store:99999/0|redis://store:port/0|redis://store/lecture|"
    "redis://store/0?colour=red|redis://[store/0|redis://store:0/0|redis://store/999999",
    "ADDRESS": "local host|lecture..example",
    "WALKS": "/nowhere/walks",
    "CLASS_PASSPHRASE": "too short",
    "BOKEH_SECRET_KEY": "too short|passwordpassword|changemechangeme|my-secret-password|abcdefghijklmnop|"
    "1234567890123456|aaaaaaaaaaaaaaaaaaaaaaaa|oscillations-lecture-secret",
    "REDIS_PASSWORD": "a\nb",
}
MALFORMED = [
    *(" ", 16 * " ", ",", ",,", "*", "%", "'", '"', "../..", "true ", "'self'\n", "a\nb", "\0", "\x1b[31m", "\u202e"),
    *("nan", "inf", "-inf", "1e999", "1e308", "5e-324", "-1", "0", "1.5", 5000 * "9", "٣", "x:٣"),
    *("x" * 70, "x" * 5000, "x" * 100_000, "a..b", "\udcff" * 20, "schön.example", "https://пример.example"),
    *("x:0", "x:99999", "https://x:99999", "[::1", "https://[::1", "http://", "10.0.0.0/99", "10.0.0.1/24", "::/129"),
    *("redis://x:0/0", "redis://x/" + 30 * "9", "redis://x:1:2", "redis://\udcff", "unix://"),
]


@pytest.mark.parametrize("name", HINTS)
def test_a_wrong_value_is_refused_with_what_is_allowed_and_any_other_can_be_used(name: str) -> None:
    variable, refused = name.upper(), 0
    wrong_values = WRONG[variable].split("|")
    for text in (*wrong_values, *MALFORMED):
        try:
            settings = read_settings([], {variable: text})
        except ValueError as refusal:
            said = str(refusal)
            refused += 1
            assert type(refusal) is ValueError and said.isprintable() and len(said) < 400
            wrong = "not what it should be" if name in SECRETS or "@" in text else f"“{text}”"
            plain = f"{variable} is {wrong}. Allowed: {describe(name)}."
            assert said == plain if text in wrong_values and text.isprintable() else said.startswith(f"{variable} ")
            assert said.endswith(".") and (name not in SECRETS or len(text) < 8 or text not in said)
        else:
            assert text not in wrong_values
            settings.hosts(settings.port)  # like the other later uses of settings, this does not raise
            networks((*settings.trusted_proxies, *settings.metrics_for))
            policy(settings.frame_ancestors).encode("ascii")  # a header
            "".join(str(getattr(settings, one)) for one in HINTS).encode()
            assert max(settings.unused_seconds, settings.notice_seconds) < 1e5
            assert name in LISTS or text.strip() == text or name == "redis_password"
    assert refused > 5


def test_a_wrong_value_stops_the_start_with_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["serving", "--port", "none"])
    with pytest.raises(SystemExit, match=r"^PORT is “none”\."):
        main()


MISSPELT = {"sessions": "SESSIONS", "TRUSTED_PROXY": "TRUSTED_PROXIES", "PORT_FILE": "PORT"}
OTHERS = {
    *(setting.env_var for name, setting in vars(type(bokeh_settings)).items() if hasattr(setting, "env_var")),
    *("LECTURE_PORT", "REDIS_PORT_5006_TCP_ADDR", "SESSION_SERVICE_HOST", "PORT_PORT", "WALKS_SERVICE_PORT_HTTP"),
    *("PATH", "HOST", "HOSTNAME", "SHELL", "USER", "SESSION_MANAGER", "PYTHONPATH", "SECRET_KEY", "REPORT", "EXPORT"),
}
"""Names of Bokeh, of Kubernetes for each service, and of systems."""


def test_a_misspelt_name_is_named_with_the_one_that_is_meant_and_none_of_other_programs() -> None:
    said = [f"{name} is not a setting and has no effect. Did you mean {known}?" for name, known in MISSPELT.items()]
    assert misspelt(dict.fromkeys(MISSPELT, "5")) == sorted(said)
    assert misspelt(dict.fromkeys(OTHERS, "5")) == [] and "BOKEH_SECRET_KEY" in OTHERS
    for known in [*(name.upper() for name in HINTS), *(f"{name.upper()}_FILE" for name in SECRETS)]:
        assert misspelt({known: "5"}) == []
        for wrong in (f"{known[:2]}{known[1:]}", f"{known}{known[-1]}", f"{known[:2]}{known[3:]}"):
            assert len(misspelt({wrong: "5"})) == 1, wrong


def test_the_table_of_settings_is_current() -> None:
    assert table() in (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8"), "run make readme"
    assert all(f"| `{name.upper()}` | " in table() for name in HINTS)
