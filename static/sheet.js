// The page of a scene as the server describes it: rows and columns of stages, plots, sentences, tables and choices, and
// which of their forms stands.

import {buildChoice} from "./controls.js"
import {element} from "./dom.js"
import {Plot} from "./plots.js"
import {Stage} from "./stage.js"

export class Sheet {
  constructor(block, page) {
    this.page = page
    this.plots = []
    this.stages = []
    this.choices = []
    this.headings = []
    this.items = []
    this.conditional = []
    this.sticky = []
    this.element = this.#block(block)
  }

  #block(block) {
    const host = element("div", {class: `block ${block.kind} ${block.style ?? ""}`})
    host.style.flex = `${block.grow} ${block.kind === "row" || block.kind === "column" || block.grow ? 1 : 0} ${block.basis || (block.grow ? 0 : "auto")}${block.basis ? "px" : ""}`
    if (block.gap) host.style.gap = `${block.gap}px`
    if (block.phone !== undefined) host.style.setProperty("--place", block.phone)
    if (block.height) host.style.setProperty("--phone-height", `${block.height}px`)
    if (block.show && block.kind !== "plot") this.conditional.push({host, form: block.show})
    if (block.blocks) host.append(...block.blocks.map(child => this.#block(child)))
    if (block.kind === "stage") {
      if (!block.style?.includes("still")) this.sticky.push({host, height: block.height})
      this.stages.push(new Stage(block, host))
    }
    if (block.kind === "plot") {
      if (block.heading.length) host.append(this.#heading(block))
      const area = element("div", {class: "plot-area"})
      host.append(area)
      this.plots.push(new Plot(block, area, this.page))
      if (block.shapes.length) this.stages.push(new Stage({shapes: block.shapes}, area))
    }
    if (block.kind === "words") host.append(...block.items.map(item => this.#item(item)))
    if (block.kind === "table") host.append(this.#table(block))
    if (block.kind === "choice") this.choices.push(buildChoice(host, block, message => this.page.send(message)))
    return host
  }

  // The formula is the legend and the switch: a click on a term takes its curve away.
  #heading(block) {
    const head = element("div", {class: "head"})
    for (const term of block.heading) {
      const part = element(term.curve ? "button" : "span", {class: `part ${term.tint}`, type: term.curve ? "button" : undefined})
      if (term.key !== "none") part.append(element("i", {class: `key ${term.key}`}))
      const variants = Object.entries(term.forms).map(([name, html]) => {
        const text = element("span", {"data-form": name})
        text.innerHTML = html
        part.append(text)
        return [name, text]
      })
      if (term.curve) {
        part.title = "Show or hide this curve"
        part.setAttribute("aria-label", curveName(block, term.curve))
        part.addEventListener("click", () => {
          const hidden = new Set(this.page.state.hidden)
          if (!hidden.delete(term.curve)) hidden.add(term.curve)
          this.page.send({type: "choose", name: "hidden", value: [...hidden]})
        })
      }
      this.headings.push({term, part, variants})
      head.append(part)
    }
    return head
  }

  #item(item, tag = "div") {
    const holder = element(tag, {class: "item"})
    const variants = Object.entries(item).filter(([key]) => key !== "form").map(([name, html]) => {
      const text = element("div", {})
      text.innerHTML = html
      holder.append(text)
      return [name, text]
    })
    if (item.form) this.items.push({name: item.form, variants, holder})
    return holder
  }

  #table(block) {
    const table = element("table", {})
    if (block.head.length) {
      const head = element("tr", {})
      for (const html of block.head) head.append(Object.assign(element("th", {scope: "col"}), {innerHTML: html}))
      table.append(head)
    }
    for (const cells of block.rows) table.append(element("tr", {}, ...cells.map((cell, i) => this.#item(cell, i ? "td" : "th"))))
    return table
  }

  update({params, errors, forms, hidden}) {
    for (const {term, part, variants} of this.headings) {
      const wanted = forms[term.curve] ?? forms[term.form] ?? "formula"
      let shown = false
      for (const [name, text] of variants) {
        text.hidden = variants.length > 1 && name !== wanted
        shown ||= !text.hidden && text.innerHTML !== ""
      }
      part.style.display = wanted === "" || !shown ? "none" : ""
      const off = hidden.includes(term.curve)
      part.classList.toggle("off", off)
      if (term.curve) part.setAttribute("aria-pressed", String(!off))
    }
    for (const {host, form} of this.conditional) host.hidden = !forms[form]
    for (const {name, variants, holder} of this.items) {
      const wanted = forms[name] ?? ""
      holder.hidden = wanted === ""
      for (const [variant, text] of variants) text.hidden = variant !== wanted
    }
    this.choices.forEach(choice => choice.update(params, errors))
    // On a phone the transport stays right under the stage that stays in sight, if the view has one.
    const stage = this.sticky.find(({host}) => !host.closest("[hidden]"))
    this.page.root.style.setProperty("--stage-height", `${stage?.height ?? 0}px`)
  }
}

// What a switch is called, whose formula a screen reader may not read: "Height against time: exact".
function curveName({title, curves, bands}, group) {
  const labels = [...curves, ...bands].filter(part => part.group === group).map(part => (part.label || part.read || "").replaceAll(/[*_{}]/g, "")).filter(Boolean)
  return `${title.split(/[,:]/)[0]}: ${[...new Set(labels)].join(", ") || group}`
}
