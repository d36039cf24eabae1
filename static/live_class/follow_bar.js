// The bars around a follower's picture: the position in the lecture, the connection, and a link to look around alone.

import {element} from "../core/dom.js"
import {Countdown} from "./countdown.js"
import {LEFT, SOUGHT, tabStorage} from "../core/storage.js"

export class FollowBar {
  away = false
  why = ""

  /** @param {import("./follow.js").Following} following */
  constructor(following) {
    this.following = following
    this.element = /** @type {HTMLElement} */ (document.querySelector(".class-bar"))
    this.here = /** @type {HTMLElement} */ (document.querySelector(".class-here"))
    this.state = element("b", {}, "Following")
    this.countdown = new Countdown(following.timing)
    this.within = element("span", {class: "within"})
    this.line = element("span", {})
    this.own = element("a", {class: "act", href: "./"}, "Look around on your own")
    this.own.addEventListener("click", () => this.leave())
    this.element.append(
      this.countdown.element,
      element("div", {}, element("div", {role: "status"}, this.state, this.line), this.within),
      this.own,
    )
  }

  /** @param {boolean} is @param {string} why the server's reason if not */
  connected(is, why = "") {
    if (this.away === !is && this.why === why) return
    this.away = !is
    this.why = why
    const coming = document.querySelector(".class-wait h1")
    if (coming && why) coming.textContent = why
    this.update()
  }

  update() {
    const {news, shown, code} = this.following
    const {bound} = this.following.timing
    this.state.textContent = this.away ? "Not connected" : "Following"
    this.within.textContent =
      this.away || bound === Infinity ? "" : `clock within ${Math.ceil(bound)} ms of the lecture`
    const behind = news.lost ? "The lecturer's page is not connected; this is what it showed last." : ""
    this.countdown.show(news.question)
    const calm = news.question?.place || "the lecture"
    this.line.textContent = this.away
      ? this.why || "Not connected; the connection comes back by itself."
      : behind || calm
    this.here.textContent = [code, news.here ? `${news.here} here` : ""].filter(Boolean).join(", ")
    this.own.textContent = news.question?.lesson ? "Try it on your own" : "Look around on your own"
    if (shown) this.own.href = `./?${shown.query}`
  }

  /**
   * Leaves the class to look around. The page that opens offers the way back and shows the state `sought`. @param
   * {page.State} [sought]
   */
  leave(sought) {
    tabStorage.keep(LEFT, this.following.code)
    if (sought) tabStorage.keep(SOUGHT, sought)
  }

  over() {
    this.countdown.end()
    this.element.replaceChildren()
    this.here.textContent = ""
  }
}
