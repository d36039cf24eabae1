// Messages about the connection and about unsent values.

import {chip, element, reword, svg} from "../core/dom.js"

const MOMENT = 4000 // ms for which the message about a restored connection stays
const LOST = "Your changes wait for the server."
const REFUSED = "A proxy or firewall blocks WebSockets to the server; your changes wait until it lets them through."

export class Status {
  due = 0
  refused = false
  waiting = "" // the unsent changes, in words
  isOutdated = false // true if the page is about to reload

  /** @type {number | undefined} */
  countdown

  /** @param {() => void} retry */
  constructor(retry) {
    this.alert = element("p", {role: "alert"})
    this.next = element("span", {class: "next"}) // outside the alert, which screen readers would repeat each second
    const button = chip("Try now", retry)
    this.lost = element("div", {class: "lost", hidden: ""}, ring(), this.alert, this.next, button)
    this.again = element("p", {class: "again", role: "status"})
    document.querySelector(".nav .brand")?.after(this.lost)
    document.querySelector(".nav #theme")?.before(this.again)
  }

  /** `refused`: the page can be fetched, but the socket fails. @param {boolean} refused */
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

  /** Shows the unsent changes. @param {number} changes @param {string} title of a scene that will be opened, or "" */
  waits(changes, title) {
    const count = changes ? `${changes} ${changes > 1 ? "changes wait" : "change waits"}.` : ""
    this.waiting = [count, title && `${title} opens then.`].filter(Boolean).join(" ")
    this.#count()
  }

  #count() {
    if (this.isOutdated) return
    const seconds = Math.ceil((this.due - performance.now()) / 1000)
    const next = seconds > 0 ? `Next try in ${seconds} s.` : "Trying."
    reword(this.next, [this.waiting, next].filter(Boolean).join(" "))
  }

  /** Reports that the server has another version of the page. */
  outdated() {
    clearInterval(this.countdown)
    this.isOutdated = true
    this.next.textContent = "There is a new version: the page reloads as soon as you pause."
  }

  /** Shows that the connection is restored, if it was lost. */
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
