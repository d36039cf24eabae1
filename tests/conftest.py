"""Settings of all tests: the same Hypothesis examples on every machine, or those of a seed in `make nightly`."""

import asyncio
import inspect
import os
from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers

from tests.grids import tries

pytest_plugins = ["tests.browser.fixtures", "tests.browser.classroom"]

SEED = os.environ.get("SEED")
"""Set by `make nightly`, for new examples each night. A failure becomes an `@example` of its test."""

# Many examples drawn from all doubles overflow; they are skipped.
settings.register_profile(
    "steady",
    max_examples=tries(100),
    derandomize=SEED is None,
    print_blob=SEED is not None,
    deadline=None,
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)
settings.load_profile("steady")
# Hypothesis also draws numbers that appear in the modules imported so far, which depend on the tests that a worker has
# run.
if not callable(providers.is_local_module_file):
    raise TypeError("Hypothesis collects the numbers of modules in another way now.")
providers.is_local_module_file = lambda path: False


def pytest_report_header() -> str:
    return f"examples of Hypothesis: {f'SEED={SEED}' if SEED else 'the same in every run'}"


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A test for the night is slow too."""
    for item in items:
        if item.get_closest_marker("nightly"):
            item.add_marker("slow")


@pytest.fixture(autouse=True)
def floating_point_errors_raise() -> Iterator[None]:
    """Overflows, invalid operations and divisions by zero raise, even if their result is not used."""
    with np.errstate(all="raise", under="ignore"):
        yield


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Run each coroutine test in its own event loop."""
    if not inspect.iscoroutinefunction(pyfuncitem.obj):
        return None
    given = {name: pyfuncitem.funcargs[name] for name in inspect.signature(pyfuncitem.obj).parameters}
    asyncio.run(pyfuncitem.obj(**given))
    return True
