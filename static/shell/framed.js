// A lecture in a frame on another page: reports its height to that page, and has a link that opens it in a new tab.

import {element} from "../core/dom.js"

/** @param {LectureHost} lecture */
export function framed(lecture) {
  const bar = /** @type {HTMLElement} */ (document.querySelector(".nav"))
  const out = element("a", {class: "out", target: "_blank", rel: "noopener"}, "Open in a tab")
  document.querySelector("#theme")?.before(out)
  const lead = () => out.setAttribute("href", lecture.page?.shown ? lecture.page.link : location.search || "./")
  for (const event of ["pointerenter", "focus", "click"]) out.addEventListener(event, lead)
  lead()
  let sentHeight = 0
  /** Sends the height to any origin, because it is no secret; the server decides who may frame the page. */
  const tell = () => {
    const height = Math.ceil(bar.offsetHeight + wanted(lecture.page))
    if (height === sentHeight) return
    sentHeight = height
    parent.postMessage({type: "oscillations:height", height}, "*")
  }
  const observer = new ResizeObserver(tell)
  const watch = () => {
    if (lecture.page) for (const part of lecture.page.root.children) observer.observe(part)
    tell()
  }
  document.addEventListener("oscillations:painted", watch)
  watch()
}

/** The height at which no part of the page scrolls. @param {PartHost | undefined} page */
function wanted(page) {
  if (!page) return 0
  return Math.max(page.root.scrollHeight, page.paper.scrollHeight, page.panel.scrollHeight)
}
