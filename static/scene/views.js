// The views of a scene: the tabs that choose one, and the task of the one that is shown.

import {button, element, intoView, marked, setAttributes} from "../core/dom.js"

export const PAPER = "view" // the id of what a tab shows

/**
 * @type {Record<string, (at: number, count: number) => number>} for each key, the index of the tab to which it moves
 */
const MOVES = {
  ArrowLeft: at => at - 1,
  ArrowRight: at => at + 1,
  Home: () => 0,
  End: (_, count) => count - 1,
}

/** The value of the parameter `view`; "" in a scene without views. @param {Drawn["settings"]} settings */
export const viewOf = settings => String(settings.view?.value ?? "")

/** @implements {Part} */
export class Views {
  moves = false // true if the choice also moves the focus

  /** @param {page.ViewTab[]} views @param {Send} send */
  constructor(views, send) {
    this.views = views
    this.send = send
    this.tabs = views.map(({word, name}, i) =>
      button({role: "tab", "aria-controls": PAPER, "data-view": word}, () => this.choose(i), name),
    )
    this.tasks = views.map(({task}) => marked("p", {class: "view-task", hidden: ""}, task))
    this.row = element("div", {class: "tabs", role: "tablist", "aria-label": "Views"}, ...this.tabs)
    this.row.addEventListener("keydown", event => this.#key(event))
    this.element = element("div", {class: "views-head"}, element("div", {class: "view-tasks"}, ...this.tasks), this.row)
  }

  /** @param {number} place */
  choose(place) {
    const {word} = this.views[(place + this.views.length) % this.views.length]
    this.send({type: "choose", name: "view", value: word})
  }

  /** Shows the next view, or for -1 the previous one. @param {1 | -1} by */
  turn(by) {
    if (this.views.length && !this.row.hidden) this.choose(this.chosen + by)
  }

  get chosen() {
    return this.tabs.findIndex(tab => tab.getAttribute("aria-selected") === "true")
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const move = MOVES[event.key]
    if (!move || event.ctrlKey || event.altKey || event.metaKey) return
    event.preventDefault()
    event.stopPropagation()
    this.choose(move(this.chosen, this.views.length))
    this.moves = true
  }

  /** Marks the pressed tab until the server has answered. @param {Waits} waiting */
  wait(waiting) {
    for (const tab of this.tabs) tab.classList.toggle("waits", tab.dataset.view === waiting.get("view"))
  }

  /** Hides the tabs and the task during a question, and while a step lists the parts to show. @param {Drawn} shown */
  update({settings, state}) {
    const now = viewOf(settings)
    const asks = Boolean(state.step) && state.covered.length > 0
    this.row.hidden = asks || !this.views.length || Boolean(state.show?.length)
    for (const [i, tab] of this.tabs.entries()) {
      const isChosen = tab.dataset.view === now
      if (isChosen && tab.getAttribute("aria-selected") !== "true") this.#enter(tab)
      setAttributes(tab, {"aria-selected": isChosen, tabindex: isChosen ? 0 : -1})
      this.tasks[i].hidden = !isChosen || Boolean(state.step)
    }
    this.moves = false
  }

  /** @param {HTMLElement} tab */
  #enter(tab) {
    if (this.moves) tab.focus({preventScroll: true})
    intoView(tab)
  }
}
