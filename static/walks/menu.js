// The menu of the walks: the built-in ones, one from a file, and the instructor's actions.

import {element} from "../core/dom.js"
import {browserStorage} from "../core/storage.js"
import {later} from "../later.js"
import {STEPS, lead} from "./steps.js"

const VISITED = "visited"
const ASK = "#ask" // hash in the address of a window that opens the editor of questions

export class Menu {
  /** @type {Map<string, string>} the addresses of the sheets by name */
  sheets = new Map()

  /** @type {HTMLElement | null} the link next to the menu that offers the tour */
  tour = document.querySelector(".new-here")

  purpose = location.hash // read now, because the first picture replaces the address

  /** @param {import("./walks.js").Walks} walks */
  constructor(walks) {
    this.walks = walks
    this.element = document.querySelector(".walks")
    for (const link of document.querySelectorAll("[data-walk]")) if (link instanceof HTMLElement) this.#lead(link)
    this.#offer()
    const {hall} = walks.lecture
    this.#entry("leave-walk", () => walks.leave())
    this.#entry("back-to-walk", () => walks.comeBack())
    // An invisible file button. It must be stored, or the browser may remove it before a file is chosen, and it must be
    // clicked directly in the handler, because browsers open files only after a press of the visitor.
    this.file = element("input", {type: "file", accept: ".toml,text/plain"})
    this.file.addEventListener("change", () => this.#run(this.file.files?.[0]))
    this.#entry("walk-file", () => this.file.click())
    this.#entry("handout", () => this.#print(false))
    this.#entry("handout-answers", () => this.#print(true))
    this.#entry("ask", () => this.#openEditor())
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

  /** @param {boolean} isAnswered */
  async #print(isAnswered) {
    const {walk} = this.walks
    if (walk) (await later("export/handout")).handout(walk, isAnswered)
  }

  /** The tour is offered on the first visit, until a walk is entered. */
  #offer() {
    const isFirst = !browserStorage.text(VISITED) && !new URLSearchParams(location.search).has("walk") && self === top
    if (this.tour) this.tour.hidden = !isFirst
    browserStorage.keep(VISITED, "yes")
  }

  /** Opens the editor of questions for the current scene, outside a walk. In hall mode it opens in another window. */
  async #openEditor() {
    const {walk, lecture} = this.walks
    if (walk) lecture.page.notice.tell("Leave the walk first: you can only write a question on a scene.")
    else if (lecture.hall.on) open(`./?${lecture.page.shown.query}${ASK}`, "_blank", "noopener")
    else (await later("walks/editor")).openEditor(this.walks)
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
  #drop(event) {
    const file = event.dataTransfer?.files[0]
    if (file) event.preventDefault()
    this.#run(file)
  }

  /** Runs a walk from a file of the visitor. @param {File} [file] */
  async #run(file) {
    if (!file) return
    const {run} = await later("walks/own_walk")
    await run(this.walks, file)
    this.file.value = "" // so that the same file can be chosen again after a correction
  }

  get names() {
    return [...this.sheets.keys()]
  }

  /** @param {boolean} isWalked */
  walked(isWalked) {
    this.element?.classList.toggle("walked", isWalked)
    if (isWalked && this.tour) this.tour.hidden = true
  }

  /** Starts the action for which a window was opened, after its first picture. */
  begin() {
    const {purpose} = this
    this.purpose = ""
    if (purpose === ASK || purpose === STEPS)
      history.replaceState(history.state, "", location.href.replace(purpose, ""))
    if (purpose === ASK) this.#openEditor()
    else if (purpose === STEPS) lead(this.walks)
  }

  /** Shows the menu entry that leads back to a walk, with this text; "" hides it. @param {string} back */
  offers(back) {
    const entry = document.getElementById("back-to-walk")
    if (!entry) return
    entry.hidden = !back
    entry.textContent = back
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
