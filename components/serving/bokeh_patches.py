"""Patches of Bokeh, made while it serves.

Bokeh keeps the current documents on a stack of the process. If a callback fails, its document stays on the stack for
ever, and pages of other visitors are then built with it and fail too.
"""

from __future__ import annotations

import weakref
from collections.abc import Iterator
from contextlib import contextmanager

import bokeh.io.doc
from bokeh.document import Document


@contextmanager
def patch_curdoc(document: Document) -> Iterator[None]:
    """Run Bokeh's function, and remove its document from the stack also after a failure."""
    bokeh.io.doc._PATCHED_CURDOCS.append(weakref.ref(document))
    try:
        yield
    finally:
        bokeh.io.doc._PATCHED_CURDOCS.pop()


def mend() -> None:
    """Replace Bokeh's function, which is looked up at each use."""
    bokeh.io.doc.patch_curdoc = patch_curdoc
