// The menu of the walks: those that there are, one from a file, and what an instructor does with them.

import {later} from "./later.js"

export class Menu {
  /** @type {Map<string, string>} the addresses of the sheets by name */
  sheets = new Map()

  /** @param {import("./walks.js").Walks} walks */
  constructor(walks) {
    this.walks = walks
    this.element = document.querySelector(".walks")
    for (const link of document.querySelectorAll("[data-walk]")) if (link instanceof HTMLElement) this.#lead(link)
    const {hall} = walks.lecture
    this.#entry("leave-walk", () => walks.leave())
    this.#entry("walk-file", async () => (await later("ownwalk")).choose(walks))
    this.#entry("handout", async () => (await later("handout")).handout(/** @type {any} */ (walks.walk)))
    this.#entry("ask", () => this.#ask())
    this.#entry("teach", () => walks.lecture.classes.begin())
    this.#entry("projector", () => hall.toggle())
    this.#entry("full-screen", () => hall.full())
    addEventListener("dragover", event => event.dataTransfer?.types.includes("Files") && event.preventDefault())
    addEventListener("drop", event => this.#drop(event))
  }

  /** @param {string} id @param {() => void} act */
  #entry(id, act) {
    document.getElementById(id)?.addEventListener("click", () => {
      this.close()
      act()
    })
  }

  /** A question is asked of a scene: a step of a walk is one already. */
  async #ask() {
    if (this.walks.walk) this.walks.lecture.page.notify(["Leave the walk first: a question is asked of a scene."])
    else (await later("ask")).ask(this.walks)
  }

  /** @param {HTMLElement} link */
  #lead(link) {
    const {walk = "", sheet = ""} = link.dataset
    this.sheets.set(walk, sheet)
    link.addEventListener("click", event => {
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey || event.button) return
      event.preventDefault()
      this.close()
      this.walks.enter(walk)
    })
  }

  /** @param {DragEvent} event */
  async #drop(event) {
    const [file] = event.dataTransfer?.files ?? []
    if (!file) return
    event.preventDefault()
    const {run} = await later("ownwalk")
    await run(this.walks, file)
  }

  get names() {
    return [...this.sheets.keys()]
  }

  /** @param {boolean} isWalked */
  walked(isWalked) {
    this.element?.classList.toggle("walked", isWalked)
  }

  close() {
    this.element?.removeAttribute("open")
  }

  toggle() {
    this.element?.toggleAttribute("open")
    const first = this.element?.querySelector("a")
    if (this.element?.hasAttribute("open")) first?.focus()
  }
}
