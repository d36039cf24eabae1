// Builds the page of a scene from its sheet: rows and columns of stages, plots, sentences, tables and choices. Selects
// the visible forms.

import {buildChoice} from "../controls/controls.js"
import {element, long, marked, setAttributes} from "../core/dom.js"
import {ModeButtons} from "./mode_buttons.js"
import {Plot} from "./plots.js"
import {Stage} from "./stage.js"
import {viewOf} from "./views.js"

/** @typedef {{name: string, text: HTMLElement}} Variant a form and its content */

export class Sheet {
  /** @type {Plot[]} */
  plots = []

  /** @type {Stage[]} */
  stages = []

  /** @type {(ReturnType<typeof buildChoice> | ModeButtons)[]} */
  choices = []

  /** @type {Map<page.MeasuredBlock, HTMLElement>} */
  measured = new Map()

  /** @type {{term: page.Term, part: HTMLElement, variants: Variant[]}[]} */
  headings = []

  /** @type {{name: string, holder: HTMLElement, variants: Variant[]}[]} */
  items = []

  /** @type {Map<page.Block, HTMLElement>} */
  hosts = new Map()

  /** @type {Map<Element, HTMLElement>} the row or column of each block, also where a stacked page moves the block */
  holders = new Map()

  /** @type {{host: HTMLElement, height: number | null}[]} stages that stay visible on a phone while it scrolls */
  sticky = []

  /** @param {page.Block} block @param {PartHost} page */
  constructor(block, page) {
    this.page = page
    this.paper = block
    this.element = this.#block(block)
  }

  /** @param {page.Block} block @returns {HTMLElement} */
  #block(block) {
    const host = element("div", {class: `block ${block.kind} ${block.style}`})
    host.style.setProperty("--flex", flex(block))
    if (block.phone !== null) host.style.setProperty("--place", String(block.phone))
    if (block.height) host.style.setProperty("--phone-height", long(block.height))
    this.hosts.set(block, host)
    this.#fill(host, block)
    return host
  }

  /** @param {HTMLElement} host @param {page.Block} block */
  #fill(host, block) {
    switch (block.kind) {
      case "row":
      case "column":
        if (block.gap) host.style.gap = long(block.gap)
        host.append(...block.blocks.map(child => this.#block(child)))
        for (const child of host.children) this.holders.set(child, host)
        return
      case "stage":
        return this.#stage(host, block)
      case "plot":
        return this.#plot(host, block)
      case "words":
        return host.append(...block.items.map(item => this.#item(item)))
      case "table":
        return host.append(this.#table(block))
      case "measured":
        this.measured.set(block, host)
        return
      case "modes":
        this.choices.push(new ModeButtons(host, block, this.page))
        return
      case "choice":
        this.choices.push(buildChoice(host, block, message => this.page.send(message)))
    }
  }

  /** True if the column of a plot is the one in which a stage is. @param {Plot} plot @param {Stage} stage */
  isBeside(plot, stage) {
    let holder = this.holders.get(/** @type {Element} */ (plot.host.parentElement))
    while (holder?.matches(".row")) holder = this.holders.get(holder)
    return holder !== undefined && holder === this.holders.get(stage.host)
  }

  /** @param {HTMLElement} host @param {page.StageBlock} block */
  #stage(host, block) {
    host.style.setProperty("--widest", String(block.widest))
    if (!block.style.includes("still")) this.sticky.push({host, height: block.height})
    this.stages.push(new Stage(block, host, this.page))
  }

  /** @param {HTMLElement} host @param {page.PlotBlock} block */
  #plot(host, block) {
    if (block.heading.length) host.append(this.#heading(block))
    const area = element("div", {class: "plot-area"})
    const {top, bottom} = block.room
    host.style.setProperty("--around", long(top + bottom))
    host.append(area)
    const plot = new Plot(block, area, this.page)
    this.plots.push(plot)
    if (!block.shapes.length) return
    const stage = new Stage({shapes: block.shapes, label: ""}, area, this.page)
    stage.under = plot
    this.stages.push(stage)
  }

  /**
   * The formula is the legend and the switch: a click on a term hides or shows its curve. @param {page.PlotBlock} block
   */
  #heading(block) {
    const terms = block.heading.map(term => this.#term(term, block))
    return element("div", {class: "head"}, ...terms)
  }

  /** @param {page.Term} term @param {page.PlotBlock} block */
  #term(term, block) {
    const look = {class: `part ${term.tint}`}
    const part = term.curve ? element("button", {...look, type: "button"}) : element("span", look)
    if (term.key !== "none") part.append(element("i", {class: `key ${term.key}`}))
    const variants = Object.entries(term.variants).map(([name, html]) => {
      const text = marked("span", {"data-form": name}, html)
      part.append(text)
      if (text.textContent?.endsWith("=") && !text.querySelector("[data-value]")) part.classList.add("equals")
      return {name, text}
    })
    if (term.curve) {
      setAttributes(part, {title: "Show or hide this curve", "aria-label": curveName(block, term.curve)})
      part.addEventListener("click", () => this.#switch(term.curve))
    }
    this.headings.push({term, part, variants})
    return part
  }

  /** @param {string} curve */
  #switch(curve) {
    const hidden = new Set(this.page.hidden)
    if (!hidden.delete(curve)) hidden.add(curve)
    this.page.send({type: "choose", name: "hidden", value: [...hidden]})
  }

  /** @param {page.Forms} item @param {"div" | "td" | "th"} [tag] */
  #item(item, tag = "div") {
    const holder = element(tag, {class: "item"})
    const variants = Object.entries(item.variants).map(([name, html], i) => {
      const text = marked("div", i ? {hidden: ""} : {}, html) // show one variant at first
      holder.append(text)
      return {name, text}
    })
    if (item.name) this.items.push({name: item.name, variants, holder})
    return holder
  }

  /** @param {page.TableBlock} block */
  #table(block) {
    const table = element("table", {})
    if (block.head.length) {
      const head = element("tr", {})
      for (const html of block.head) head.append(html ? marked("th", {scope: "col"}, html) : element("td"))
      table.append(head)
    }
    for (const cells of block.rows) {
      const [name, ...rest] = cells.map((cell, i) => this.#item(cell, i ? "td" : "th"))
      setAttributes(name, {scope: "row"})
      // Give rows a name in letters, because some screen readers do not read a formula as a name.
      for (const formula of name.querySelectorAll("math")) {
        formula.before(element("span", {class: "heard"}, formula.textContent ?? ""))
        setAttributes(formula, {"aria-hidden": "true"})
      }
      table.append(element("tr", {}, name, ...rest))
    }
    return table
  }

  /**
   * Hides blocks that belong neither to the view nor to the step's list of parts. Returns true if a part of `block` is
   * left.
   * @param {page.Block} block @param {Drawn} shown @param {boolean} [isOutside] true inside a hidden block
   * @returns {boolean}
   */
  #updateBlock(block, shown, isOutside = false) {
    const {settings, state, view} = shown
    const parts = state.show ?? []
    const isInView = parts.length > 0 || !block.views.length || block.views.includes(viewOf(settings))
    let isShown = !isOutside && isInView && (!block.form || Boolean(view.forms[block.form]))
    if (block.kind === "row" || block.kind === "column")
      isShown = block.blocks.map(child => this.#updateBlock(child, shown, !isShown)).includes(true)
    else if (parts.length) isShown &&= parts.includes(block.part)
    const host = /** @type {HTMLElement} */ (this.hosts.get(block))
    host.classList.toggle("at-desk", !block.hall && !parts.length) // visible in hall mode too if a step lists it
    host.hidden = !isShown
    host.classList.toggle("listed", isShown && parts.includes(block.part))
    host.classList.toggle("named", this.#names(viewOf(settings)).includes(block.part)) // hall mode keeps it
    return isShown
  }

  /** The parts that the task of a view is about. @param {string} view */
  #names(view) {
    return this.page.spec.views.find(({word}) => word === view)?.names ?? []
  }

  /** @param {Drawn} shown */
  update(shown) {
    const {
      view: {forms},
      settings,
      state: {covered, before},
    } = shown
    this.#updateBlock(this.paper, shown)
    for (const {term, part, variants} of this.headings) {
      const wanted = forms[term.form] ?? "formula"
      let hasText = false
      for (const {name, text} of variants) {
        text.hidden = variants.length > 1 && name !== wanted
        hasText ||= !text.hidden && text.innerHTML !== ""
      }
      part.style.display = wanted === "" || !hasText ? "none" : ""
      const off = this.page.hidden.includes(term.curve)
      part.classList.toggle("off", off)
      if (term.curve) part.setAttribute("aria-pressed", String(!off))
    }
    for (const {name, variants, holder} of this.items) {
      const wanted = forms[name] ?? ""
      const isPending = !holder.hidden && covered.includes(`form:${name}`)
      holder.classList.toggle("waits", isPending)
      if (isPending) continue // the empty row keeps its space
      holder.hidden = wanted === ""
      for (const {name: variant, text} of variants) text.hidden = variant !== wanted
    }
    this.choices.forEach(choice => choice.update(settings, shown.view))
    const {root} = this.page
    root.classList.toggle("at-rest", covered.includes("stage") && !before)
    root.classList.toggle("without-table", covered.includes("table"))
    // On a phone the transport is right under the stage that stays visible, if the view has one.
    const stage = this.sticky.find(({host}) => !host.closest("[hidden]"))
    root.style.setProperty("--stage-height", long(stage?.height ?? 0))
  }
}

// The accessible name of a switch whose formula a screen reader may not read: "Height against time: exact".
/** @param {page.PlotBlock} block @param {string} group */
function curveName({brief, curves, regions}, group) {
  const labels = [...curves, ...regions]
    .filter(part => part.group === group)
    .map(part => part.read)
    .filter(Boolean)
  return `${brief}: ${[...new Set(labels)].join(", ") || group}`
}

// A block's share of the height or the width. Rows and columns shrink; a sentence keeps its height.
/** @param {page.Block} block */
function flex({kind, grow, basis}) {
  const shrink = kind === "row" || kind === "column" || grow ? 1 : 0
  if (basis) return `${grow} ${shrink} ${long(basis)}`
  return `${grow} ${shrink} ${grow ? 0 : "auto"}`
}
