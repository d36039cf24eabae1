// The state of the connection in words, in place of the links to other scenes, which would not work without one.

import {chip, element, svg} from "../core/dom.js"

const MOMENT = 4000 // ms for which it is said that all is well again
const LOST = "The picture still plays; your changes wait."
const REFUSED = "A proxy or firewall blocks WebSockets to the server. The picture still plays; nothing can be changed."

export class Status {
  due = 0
  refused = false

  /** @type {number | undefined} */
  countdown

  /** @param {() => void} retry */
  constructor(retry) {
    this.alert = element("p", {role: "alert"})
    this.next = element("span", {class: "next"}) // no part of the alert, which would be read out each second
    const button = chip("Try now", retry)
    this.lost = element("div", {class: "lost", hidden: ""}, ring(), this.alert, this.next, button)
    this.again = element("p", {class: "again", role: "status"})
    document.querySelector(".nav .brand")?.after(this.lost)
    document.querySelector(".nav #theme")?.before(this.again)
  }

  /** `refused`: the page can be fetched, but no socket opened. @param {boolean} refused */
  say(refused) {
    if (this.lost.hidden || refused !== this.refused) {
      this.alert.replaceChildren(element("b", {}, "Not connected."), ` ${refused ? REFUSED : LOST}`)
    }
    this.refused = refused
    this.lost.hidden = false
    this.again.replaceChildren()
  }

  /** @param {number} pause in ms until the next try */
  wait(pause) {
    clearInterval(this.countdown)
    this.due = performance.now() + pause
    this.#count()
    if (pause) this.countdown = setInterval(() => this.#count(), 1000)
  }

  #count() {
    const seconds = Math.ceil((this.due - performance.now()) / 1000)
    this.next.textContent = seconds > 0 ? `Next try in ${seconds} s.` : "Trying."
  }

  /** The server has another version of the page. */
  outdated() {
    clearInterval(this.countdown)
    this.next.textContent = "There is a new version: the page reloads as soon as you pause."
  }

  /** All is well, and that is said where it was not. */
  found() {
    clearInterval(this.countdown)
    if (this.lost.hidden) return
    this.lost.hidden = true
    this.alert.replaceChildren()
    this.again.replaceChildren(tick(), "Connected again")
    setTimeout(() => this.again.replaceChildren(), MOMENT)
  }
}

const LINE = {fill: "none", stroke: "currentColor"}

const ring = () =>
  svg(
    "svg",
    {viewBox: "0 0 20 20", width: "1.25rem", height: "1.25rem", "aria-hidden": "true"},
    svg("circle", {cx: 10, cy: 10, r: 8, ...LINE, "stroke-width": 1.75, "stroke-dasharray": "4 2.3"}),
  )

const tick = () =>
  svg(
    "svg",
    {viewBox: "0 0 20 20", width: "1.125rem", height: "1.125rem", "aria-hidden": "true"},
    svg("circle", {cx: 10, cy: 10, r: 9, fill: "currentColor"}),
    svg("path", {d: "M5.500 10.500l3 3 6-7", ...LINE, stroke: "var(--paper)", "stroke-width": 2}),
  )
