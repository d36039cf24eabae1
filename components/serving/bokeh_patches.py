"""Patches of Bokeh, made while it serves.

Bokeh keeps the documents at work on a stack of the process, and leaves one there for good when a callback fails: from
then on others' pages are built with a document that is gone, and fail as well.
"""

from __future__ import annotations

import weakref
from collections.abc import Iterator
from contextlib import contextmanager

import bokeh.io.doc
from bokeh.document import Document


@contextmanager
def patch_curdoc(document: Document) -> Iterator[None]:
    """Run Bokeh's function, and take its document back after a failure too."""
    bokeh.io.doc._PATCHED_CURDOCS.append(weakref.ref(document))
    try:
        yield
    finally:
        bokeh.io.doc._PATCHED_CURDOCS.pop()


def mend() -> None:
    """Replace Bokeh's function, which is looked up at each use."""
    bokeh.io.doc.patch_curdoc = patch_curdoc
