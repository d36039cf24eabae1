// The shell around a scene: the navigation, the title of the document, light and dark.

import {element} from "../core/dom.js"
import {Group} from "./scene_group.js"
import {turnTheme} from "./theme.js"
import {using} from "../later.js"

export class Shell {
  /** @param {LectureHost} lecture */
  constructor(lecture) {
    this.lecture = lecture
    this.nav = one(".nav nav", HTMLElement)
    this.menu = one(".scene-menu", HTMLDetailsElement)
    this.heading = one(".scene-menu summary", HTMLElement)
    this.where = element("span", {class: "where"})
    this.menu.after(this.where)
    this.menu.addEventListener("toggle", () => this.nav.classList.toggle("open", this.menu.open))
    /** @type {HTMLElement[]} */
    this.links = [...this.nav.querySelectorAll("[data-scene]")].filter(link => link instanceof HTMLElement)
    for (const link of this.links) this.#lead(link)
    this.groups = [...this.nav.querySelectorAll(".scene-group")].map(group => new Group(group))
    for (const link of document.querySelectorAll("[data-skip]"))
      link.addEventListener("click", event => this.#skip(event))
    one("#theme", HTMLElement).addEventListener("click", () => this.#theme())
    if (parent !== window) using("shell/framed", ({framed}) => framed(lecture))
  }

  /**
   * A click changes the scene within the session; the browser handles other clicks, for example those that open a new
   * tab. @param {HTMLElement} link
   */
  #lead(link) {
    const {scene = "", sheet = ""} = link.dataset
    for (const event of ["pointerenter", "focus", "click"]) {
      link.addEventListener(event, () => this.lecture.sheets.fetch(sheet).catch(() => {}), {once: true})
    }
    link.addEventListener("click", event => {
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey || event.button) return
      event.preventDefault()
      this.menu.open = false
      for (const group of this.groups) group.close()
      this.lecture.open({scene}, true)
    })
  }

  /** The title of a scene; "" of none. @param {string} slug */
  titleOf(slug) {
    return this.links.find(link => link.dataset.scene === slug)?.textContent ?? ""
  }

  /** The position of a scene in the lecture. @param {string} slug */
  #place(slug) {
    const place = this.links.findIndex(link => link.dataset.scene === slug)
    const lecture = this.links[place]?.closest(".scene-group")?.querySelector(".lecture")
    return `${lecture?.textContent ?? ""}, scene ${place + 1} of ${this.links.length}`
  }

  /**
   * `moved`: the visitor came from another scene, so the focus moves for screen readers.
   * @param {page.SceneSheet} sheet @param {boolean} moved
   */
  turned({slug, title, headline}, moved) {
    this.where.textContent = this.#place(slug)
    document.title = `${headline} – Oscillations`
    this.heading.textContent = title
    for (const link of this.links) {
      const here = link.dataset.scene === slug
      link.classList.toggle("here", here)
      if (here) link.setAttribute("aria-current", "page")
      else link.removeAttribute("aria-current")
    }
    for (const group of this.groups) group.turned()
    // In a frame, do not take the focus from the page around it.
    if (!moved || !document.hasFocus()) return
    scrollTo(0, 0)
    this.lecture.page.root.querySelector("h1")?.focus({preventScroll: true})
  }

  /** Moves the focus to the content, so that the Tab key continues from there. @param {Event} event */
  #skip(event) {
    event.preventDefault()
    const link = /** @type {HTMLElement} */ (event.currentTarget)
    const part = /** @type {HTMLElement} */ (this.lecture.page.root.querySelector(link.dataset.skip ?? ""))
    part.tabIndex = -1
    part.focus()
  }

  #theme() {
    turnTheme()
    this.lecture.page.theme()
  }
}

/**
 * An element that the HTML from the server contains.
 * @template {Element} Kind
 * @param {string} selector @param {{new (): Kind}} kind @returns {Kind}
 */
function one(selector, kind) {
  const found = document.querySelector(selector)
  if (found instanceof kind) return found
  throw new Error(`The page has no ${selector}.`)
}
