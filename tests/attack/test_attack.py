"""A short form of `make attack`: a page stays consistent after any link or message."""

from __future__ import annotations

import logging
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.scene import Scene
from components.scenes import SCENES
from components.state.link import Link
from tools.attack import __main__ as command
from tools.attack.__main__ import hunt
from tools.attack.extremes import ExtremeValues, Message, messages, queries, values
from tools.attack.result import AttackResult
from tools.attack.visit import Visit, follow, visit

scenes = pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
HUGE = 1.7976931348623157e308


@scenes
@pytest.mark.timeout(600)
def test_pages_at_extremes(scene: type[Scene]) -> None:
    @settings(max_examples=15)
    @given(values(scene), messages(scene))
    def page(link: ExtremeValues, sent: list[Message]) -> None:
        visit(scene.slug, link, sent)

    page()


@scenes
def test_malformed_links(scene: type[Scene]) -> None:
    settings(max_examples=15)(given(queries(scene))(follow))()


@pytest.mark.parametrize(
    ("slug", "given", "message"),
    [
        ("absorber", {}, {"type": "set", "values": {"k1": 1e-300}}),
        ("forced", {}, {"type": "set", "values": {"window": 1e300, "k1": 9.0}}),
        ("forced", {}, {"type": "set", "values": {"m1": 1e175, "v2_0": 1e308}}),
        ("modes", {"view": "hunt"}, {"type": "set", "values": {"window": 5e-324, "m2": 2e-146, "x2_0": -HUGE}}),
        ("oscillator", {}, {"type": "set", "values": {"m": HUGE, "k": HUGE, "x_0": HUGE, "v_0": HUGE}}),
    ],
)
def test_a_refusal_leaves_every_byte_of_the_message(slug: str, given: dict[str, object], message: Message) -> None:
    """Some of these values once changed the ranges of the sliders before they were refused."""
    page = Visit(Link(slug, given))
    assert page.send(message, 1)
    page.leave()


def test_ticks_far_off_their_unit_can_be_read() -> None:
    """A kept frame grows to 5e16 m for the smallest mass on the softest spring. It was once labelled −4e+16."""
    parameters = {"k": 5e-324, "x_0": 0.0, "m": sys.float_info.min}
    state = {"scene": "energy", "parameters": parameters, "frame": {}}
    visit("oscillator", {}, [{"type": "open", "state": state}, {"type": "set", "values": {"m": 5e-324}}])


def test_a_failed_hunt_reports_its_simplest_example() -> None:
    def small(found: int) -> None:
        assert found < 1000

    missed = hunt("below a million", 50, 1, given(st.integers(0, 10**6))(small))
    assert not missed.passed
    assert "found=1000," in missed.detail
    assert hunt("below a hundred", 50, 1, given(st.integers(0, 100))(small)).passed


def test_the_command_prints_each_finding_and_fails_for_one(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    findings = AttackResult("calm", True), AttackResult("storm", False, "found=1000")
    monkeypatch.setattr(command, "found", lambda *given: findings if given == (3, 7) else ())
    monkeypatch.setattr(logging, "disable", lambda level: None)
    for seed, code in ((7, 1), (8, 0)):
        monkeypatch.setattr(sys, "argv", ["attack", "--size", "3", "--seed", f"{seed}"])
        assert command.main() == code
    printed = capsys.readouterr().out
    for line in ("passed  calm", "FAILED  storm", "found=1000", "1 of the findings failed; seed 7.", "All passed."):
        assert line in printed
