"""A process of its own that measures one system: `python -m physics.accuracy_worker`, JSON lines in and out.

The first line on standard input is {"system": {...}, "seconds": limit of a run, "budget": limit of all runs}; each
further line {"skip": method} gives a method up. On standard output come {"method": slug} when a method begins,
{"run": {...}} for each run, and at the end {"end": null} or {"end": reason}. When standard input closes, it stops.
"""

import json
import os
import sys
from dataclasses import asdict
from threading import Thread
from time import monotonic
from typing import Any

from physics.accuracy import Limits, System, measure
from physics.coupled import TwoMassChain

NICENESS = 15


def encoded(system: System) -> dict[str, Any]:
    """A system as JSON."""
    return asdict(system)


def decoded(data: dict[str, Any]) -> System:
    """The system that `encoded` made this of."""
    pairs = {name: tuple(data[name]) for name in ("x_0", "v_0")}
    return System(**{**data, **pairs, "chain": TwoMassChain(**data["chain"])})


def tell(**message: Any) -> None:
    print(json.dumps(message), flush=True)


def serve() -> None:
    """Measure what the first line asks for."""
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    order = json.loads(sys.stdin.readline())
    skipped: set[str] = set()
    Thread(target=_listen, args=(skipped,), daemon=True).start()
    deadline = monotonic() + order["budget"]
    told: list[str] = []

    def cancelled(method: str) -> bool:
        if method not in told[-1:]:
            told.append(method)
            tell(method=method)
        return method in skipped or monotonic() > deadline

    reason = None
    try:
        for run in measure(decoded(order["system"]), limits=Limits(seconds=order["seconds"]), cancelled=cancelled):
            tell(run=run.to_dict())
        if monotonic() > deadline:
            reason = f"stopped after {order['budget']:g} s, the limit for one visitor"
    except ValueError as error:
        reason = str(error)
    tell(end=reason)


def _listen(skipped: set[str]) -> None:
    for line in sys.stdin:
        skipped.add(json.loads(line)["skip"])
    os._exit(0)


if __name__ == "__main__":
    serve()
