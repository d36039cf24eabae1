// The start page in the browser: pictures in motion, the theme, and the code of a live class.

import {inWords} from "./core/notes.js"
import {play} from "./core/moving.js"
import {fetchJson} from "./live_class/requests.js"
import {turnTheme} from "./shell/theme.js"

/** Fetches the files of a scene when its picture is about to be pressed. @param {HTMLAnchorElement} link */
function ahead({dataset}) {
  const {version} = document.documentElement.dataset
  for (const [rel, href] of [
    ["prefetch", `assets/${dataset.sheet}`],
    ["prefetch", `assets/${version}/start.js`],
  ]) {
    if (document.head.querySelector(`[href="${href}"]`)) continue
    document.head.append(Object.assign(document.createElement("link"), {rel, href}))
  }
}

/** Checks with the server that a class has this code, before the page changes to it. @param {HTMLFormElement} form */
function join(form) {
  const field = /** @type {HTMLInputElement} */ (form.querySelector("input"))
  const says = /** @type {HTMLElement} */ (form.querySelector("[role=alert]"))
  form.addEventListener("submit", async event => {
    event.preventDefault()
    const code = field.value.trim()
    try {
      await fetchJson(`${encodeURIComponent(code)}/token`, {method: "POST"})
      location.assign(`./?class=${encodeURIComponent(code)}`)
    } catch (reason) {
      says.textContent = inWords(reason)
      field.focus()
    }
  })
}

for (const card of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll("a.scene-card"))) {
  for (const event of ["pointerenter", "focus"]) card.addEventListener(event, () => ahead(card))
}
play([.../** @type {NodeListOf<SVGSVGElement>} */ (document.querySelectorAll("svg.thumb"))])
const form = document.querySelector(".class-join")
if (form instanceof HTMLFormElement) join(form)
document.getElementById("theme")?.addEventListener("click", turnTheme)
