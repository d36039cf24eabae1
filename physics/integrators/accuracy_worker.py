"""A process that measures one system: `python -m physics.integrators.accuracy_worker`, JSON lines in and out.

The first line on standard input is {"system": {...}, "methods": [...], "seconds": limit of a run, "budget": limit of
all runs}; each further line {"skip": method} gives a method up. On standard output come {"method": slug} when another
method begins, {"run": {...}} for each run and after each new timing of it, and at the end {"end": null} or
{"end": reason}. When standard input closes, it stops.
"""

import json
import os
import sys
from contextlib import suppress
from dataclasses import asdict
from threading import Thread
from time import monotonic
from typing import Any

from physics.coupled import TwoMassChain
from physics.integrators.accuracy import Limits, System
from physics.integrators.race import measure
from physics.integrators.solvers import METHODS

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

NICENESS = 15
MEMORY = 2**30  # bytes of address space; a measurement touches a tenth of that


def encoded_system(system: System) -> dict[str, Any]:
    """Return a `system` as JSON."""
    return asdict(system)


def decoded_system(data: dict[str, Any]) -> System:
    """Return the system of which `encoded_system` made `data`."""
    pairs = {name: tuple(data[name]) for name in ("x_0", "v_0")}
    return System(**{**data, **pairs, "chain": TwoMassChain(**data["chain"])})


def tell(**message: Any) -> None:
    """Write a message to the standard output as a line of JSON."""
    print(json.dumps(message), flush=True)


def restrain(niceness: int = NICENESS) -> None:
    """Raise the `niceness` and limit the memory of this process, if the operating system can."""
    if hasattr(os, "nice"):
        os.nice(niceness)
    if resource is not None:
        with suppress(ValueError, OSError):  # there is a lower limit already
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def serve() -> None:
    """Measure what the first line asks for."""
    restrain()
    order = json.loads(sys.stdin.readline())
    skipped: set[str] = set()
    Thread(target=_listen, args=(skipped,), daemon=True).start()
    deadline = monotonic() + order["budget"]
    methods, told, ended = order["methods"], list[str](), set[str]()

    def cancelled(method: str) -> bool:
        if method not in told[-1:]:
            told.append(method)
            tell(method=method)
        return method in skipped or monotonic() > deadline

    reason = None
    try:
        limits = Limits(seconds=order["seconds"])
        for run in measure([decoded_system(order["system"])], [METHODS[slug] for slug in methods], limits, cancelled):
            ended |= {run.method} if run.end not in ("", "cancelled") else set()
            tell(run=run.to_dict())
        if not ended | skipped >= set(methods):
            reason = f"stopped after {order['budget']:g} s, before the finest runs"
    except ValueError as error:
        reason = str(error)
    except MemoryError:
        reason = "no memory left"
    tell(end=reason)


def _listen(skipped: set[str]) -> None:
    for line in sys.stdin:
        skipped.add(json.loads(line)["skip"])
    os._exit(0)


if __name__ == "__main__":
    serve()
