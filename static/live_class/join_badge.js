// The join badge in a corner of the hall's screen: the address, the code, a QR code for the first rows, and the number
// of followers.

import {button, element, marked} from "../core/dom.js"

export class JoinBadge {
  /** @param {page.Opened} room @param {() => void} press */
  constructor({address, code, square}, press) {
    this.state = element("span", {})
    const words = element("span", {class: "corner-words"}, element("span", {class: "at"}, place(address)))
    words.append(element("b", {}, code), this.state)
    this.element = button({class: "class-corner", title: "Join code, large (J)"}, press, words)
    this.element.append(marked("span", {class: "class-square", "aria-hidden": "true"}, square))
  }

  /** Puts the badge on the page of the current scene. @param {HTMLElement} root of its page */
  attach(root) {
    if (this.element.parentElement === root) return
    root.append(this.element)
    root.classList.add("led")
  }

  /** @param {string} state */
  say(state) {
    this.state.textContent = state
  }

  leave() {
    this.element.parentElement?.classList.remove("led")
    this.element.remove()
  }
}

/** The address as students type it, without http. @param {string} address */
export function place(address) {
  const {host, pathname} = new URL(address)
  return `${host}${pathname}`.replace(/\/$/, "")
}
