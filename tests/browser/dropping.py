"""A file dropped onto the page."""

from __future__ import annotations

from playwright.sync_api import Page

DROP = """([name, text]) => {
  const data = new DataTransfer()
  data.items.add(new File([text], name))
  for (const kind of ["dragover", "drop"])
    document.querySelector(".paper").dispatchEvent(
      new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true}))
}"""


def drop(page: Page, name: str, content: str) -> None:
    """Drop a text file of this name onto the paper."""
    page.evaluate(DROP, [name, content])
