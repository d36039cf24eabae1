// The start page in the browser: small pictures that play, the theme, and the code of a live class.

import {inWords} from "./core/notes.js"
import {svg} from "./core/dom.js"
import {ask} from "./live_class/requests.js"
import {turnTheme} from "./shell/theme.js"

const LASTS = 2000 // ms that a picture plays
const still = matchMedia("(prefers-reduced-motion: reduce)")
const touched = matchMedia("(hover: none)")

/** A small picture: a dot moves along each of its curves. */
class Thumbnail {
  /** @type {number | undefined} */
  begun

  /** @param {HTMLAnchorElement} link */
  constructor(link) {
    this.link = link
    this.curves = [...link.querySelectorAll("[data-runs]")].map(path => {
      const dot = svg("circle", {class: "dot", r: 4})
      path.after(dot)
      const points = (path.getAttribute("d") ?? "").slice(1).split("L")
      return {dot, points: points.map(point => point.split(" ").map(Number))}
    })
    this.place(0.35)
  }

  /** @param {number} share of the curves */
  place(share) {
    for (const {dot, points} of this.curves) {
      const at = share * (points.length - 1)
      const i = Math.min(Math.floor(at), points.length - 2)
      const [[x0, y0], [x1, y1]] = points.slice(i, i + 2)
      dot.setAttribute("cx", String(x0 + (x1 - x0) * (at - i)))
      dot.setAttribute("cy", String(y0 + (y1 - y0) * (at - i)))
    }
  }

  /** Plays once from its start; at its end `done` is called. @param {() => void} done */
  play(done) {
    const run = (this.begun = performance.now())
    const frame = (/** @type {number} */ now) => {
      if (this.begun !== run || still.matches) return
      const share = (now - run) / LASTS
      this.place(Math.min(Math.max(share, 0), 1))
      if (share < 1) requestAnimationFrame(frame)
      else done()
    }
    requestAnimationFrame(frame)
  }

  rest() {
    this.begun = undefined
  }
}

/** The pictures: in order once, then the one that is looked at. */
class Thumbs {
  /** @type {Thumbnail | null} */
  playing = null

  /** @param {HTMLAnchorElement[]} links */
  constructor(links) {
    this.all = links.map(link => new Thumbnail(link))
    for (const thumb of this.all) {
      for (const event of ["pointerenter", "focus"]) thumb.link.addEventListener(event, () => this.#look(thumb))
      for (const event of ["pointerleave", "blur"]) thumb.link.addEventListener(event, () => this.#look(null))
    }
    if (touched.matches) addEventListener("scroll", () => this.#middle(), {passive: true})
  }

  /** @param {number} i the first that plays */
  inOrder(i) {
    const thumb = this.all[i]
    if (!thumb || this.playing) return
    thumb.play(() => this.inOrder(i + 1))
  }

  /** One is looked at, and plays until it is not. @param {Thumbnail | null} thumb */
  #look(thumb) {
    if (thumb === this.playing) return
    for (const other of this.all) other.rest()
    this.playing = thumb
    const again = () => thumb === this.playing && thumb?.play(again)
    again()
    if (thumb) ahead(thumb.link)
  }

  /** The one in the middle of a screen that is scrolled. */
  #middle() {
    this.#look(this.all.toSorted((one, other) => far(one) - far(other))[0])
  }
}

/** From the middle of the screen. @param {Thumbnail} thumb */
function far({link}) {
  const {top, bottom} = link.getBoundingClientRect()
  return Math.abs(top + bottom - innerHeight)
}

/** Fetches all that a scene needs before it is pressed. @param {HTMLAnchorElement} link */
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

/** A code is asked about before the page is left. @param {HTMLFormElement} form */
function join(form) {
  const field = /** @type {HTMLInputElement} */ (form.querySelector("input"))
  const says = /** @type {HTMLElement} */ (form.querySelector("[role=alert]"))
  form.addEventListener("submit", async event => {
    event.preventDefault()
    const code = field.value.trim()
    try {
      await ask(`${encodeURIComponent(code)}/token`, {method: "POST"})
      location.assign(`./?class=${encodeURIComponent(code)}`)
    } catch (reason) {
      says.textContent = inWords(reason)
      field.focus()
    }
  })
}

const cards = [...document.querySelectorAll("a.scene-card")].filter(link => link instanceof HTMLAnchorElement)
new Thumbs(cards).inOrder(0)
const form = document.querySelector(".class-join")
if (form instanceof HTMLFormElement) join(form)
document.getElementById("theme")?.addEventListener("click", turnTheme)
