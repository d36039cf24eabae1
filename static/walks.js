// The guided walks: which there are, and when one begins and ends. What a walk is made of is fetched when one begins.

import {insisting, later} from "./later.js"

/** @typedef {import("./later/walk.js").Walk} Walk */

export class Walks {
  /** @type {Walk | null} the one that is walked */
  walk = null

  /** @type {Map<string, page.WalkSheet>} walks that only this session knows */
  own = new Map()

  /** @param {import("./main.js").Lecture} lecture */
  constructor(lecture) {
    this.lecture = lecture
    this.menu = document.querySelector(".walks")
    /** @type {HTMLElement[]} */
    this.links = [...document.querySelectorAll("[data-walk]")].filter(link => link instanceof HTMLElement)
    for (const link of this.links) this.#lead(link)
    document.querySelector("#leave-walk")?.addEventListener("click", () => this.leave())
  }

  /** @param {HTMLElement} link */
  #lead(link) {
    link.addEventListener("click", event => {
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey || event.button) return
      event.preventDefault()
      this.#close()
      this.enter(link.dataset.walk ?? "")
    })
  }

  #close() {
    this.menu?.removeAttribute("open")
  }

  get names() {
    return [...this.links.map(link => link.dataset.walk ?? ""), ...this.own.keys()]
  }

  /** @param {string} name @returns {Promise<page.WalkSheet>} */
  async sheet(name) {
    const own = this.own.get(name)
    const address = this.links.find(link => link.dataset.walk === name)?.dataset.sheet
    if (own) return own
    if (!address) throw new Error(`There is no walk ${name}.`)
    return /** @type {any} */ (await this.lecture.sheet(address))
  }

  /** @param {string} name @param {number} [place] of the step */
  async enter(name, place = 0) {
    await this.#take(name)
    this.walk?.go(place)
  }

  /** @param {string} name */
  async #take(name) {
    if (this.walk?.sheet.name === name) return
    const [{Walk: Kind}, sheet] = await Promise.all([later("walk"), insisting(() => this.sheet(name))])
    if (this.walk?.sheet.name === name) return
    this.walk?.leave()
    this.walk = new Kind(this, sheet)
  }

  /** After every picture: the step that it stands for, if it does. @param {Drawn} shown */
  async shown(shown) {
    this.latest = shown
    const [name, step] = shown.state.step.split("/")
    this.menu?.classList.toggle("walked", Boolean(name))
    if (name) {
      await this.#take(name)
      if (shown === this.latest) this.walk?.arrive(step, shown)
    } else {
      this.walk?.leave()
      this.walk = null
    }
  }

  /** The scene keeps the state that was reached. */
  leave() {
    this.#close()
    const {kept} = this.lecture
    if (kept.step) this.lecture.open({...kept, covered: [], step: ""})
  }

  /** Out of the walk, or the menu of all of them. */
  toggle() {
    if (this.lecture.kept.step) return this.leave()
    this.menu?.toggleAttribute("open")
    if (this.menu?.hasAttribute("open")) this.links[0]?.focus()
  }

  /** What is covered: by the question of a step, or by a choice of one's own. */
  reveal() {
    if (this.walk && !this.walk.lesson) this.walk.show(false)
    if (!this.walk && this.lecture.kept.covered.length) this.lecture.change(() => ({covered: []}))
  }

  /** @param {page.Taught | page.Walking} told */
  told(told) {
    if (told.type === "taught") this.walk?.taught(told)
    else if (told.sheet) {
      this.own.set(told.sheet.name, told.sheet)
      this.enter(told.sheet.name)
    } else this.lecture.page.notify([told.refused])
  }
}
