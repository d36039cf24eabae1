"""Descriptions of plots for screen readers."""

from __future__ import annotations

from playwright.sync_api import Page

TOLD = 'name => document.getElementById(`says-${name}`)?.textContent !== ""'
SAYS = "name => document.getElementById(`says-${name}`).textContent"


def described(page: Page, name: str) -> str:
    """Return the description of a plot, once it has one."""
    page.wait_for_function(TOLD, arg=name)
    return str(page.evaluate(SAYS, name))
