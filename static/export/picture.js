// A plot or the stage as a picture for a report: light, with a title, its legend, the parameters and the link.

import {element, long, setAttributes, svg, textWidth, unitSize} from "../core/dom.js"
import {evaluate} from "../core/signals.js"
import {Drawing, numbered} from "./drawing.js"
import {held, instant, link, parameters} from "./caption.js"
import {isSeen} from "./things.js"
import {plain} from "../core/plain.js"

const WIDE = 560 // width of a picture; the text has the size of the page's
const HIGH = 300 // height of the frame of a plot
const EDGE = 14
const LINE = 20
const UNIT = 4 // a unit at the end of a formula has at most so many characters
/** Properties of drawn elements, with their default values. @type {Record<string, string>} */
const LOOK = {
  fill: "rgb(0, 0, 0)",
  "fill-opacity": "1",
  stroke: "none",
  "stroke-width": "1px",
  "stroke-dasharray": "none",
  "stroke-linecap": "butt",
  "stroke-linejoin": "miter",
  "stroke-opacity": "1",
  opacity: "1",
  "vector-effect": "none",
  "paint-order": "normal",
}
const TYPE = ["font-family", "font-size", "font-style", "font-weight"]

/**
 * @typedef {import("../scene/plots.js").Plot} Plot
 * @typedef {import("../scene/stage.js").Stage} Stage
 */
/** @typedef {{svg: string, width: number, height: number}} Picture */

/** An invisible element in the light theme, in which a picture is drawn. */
class Easel {
  /** @param {number} [width] */
  constructor(width = WIDE) {
    this.width = width
    this.svg = svg("svg", {class: "picture"})
    this.host = element("div", {class: "easel", "data-theme": "light"}, this.svg)
    document.body.append(this.host)
    this.y = EDGE
  }

  /**
   * Draws words on as many lines as they need; later content moves down.
   * @param {string} text @param {string} style @param {RegExp} [gaps] where a line may end
   */
  write(text, style, gaps = /(?<= )/) {
    const line = () => svg("text", {class: style, x: EDGE, y: (this.y += LINE) - 5})
    let now = line()
    this.svg.append(now)
    for (const word of text.split(gaps)) {
      const before = now.textContent ?? ""
      now.textContent = before + word
      if (!before || now.getComputedTextLength() <= this.width - 2 * EDGE) continue
      now.textContent = before
      now = line()
      now.textContent = word
      this.svg.append(now)
    }
  }

  /**
   * The legend: a sample of each line with its formula as text.
   * @param {{key: string, tint: string, text: string}[]} terms
   */
  list(terms) {
    let x = EDGE
    this.y += LINE
    for (const {key, tint, text} of terms) {
      const words = svg("text", {class: `t1 ${key === "band" ? "ink" : ""}`}, text)
      const term = svg("g", {class: tint}, ...sample(key), words)
      this.svg.append(term)
      const room = key === "none" ? 0 : 28
      const width = room + words.getComputedTextLength()
      if (x > EDGE && x + width > this.width - EDGE) {
        x = EDGE
        this.y += LINE
      }
      setAttributes(words, {x: room})
      setAttributes(term, {transform: `translate(${x} ${this.y - 5})`})
      x += width + 14
    }
  }

  /** @param {PartHost} page @param {string} [when] */
  caption(page, when) {
    this.y += 4
    for (const one of [[when, ...parameters(page)], held(page, when === undefined ? "Dotted" : "In outline")])
      if (one.some(Boolean)) this.write(one.filter(Boolean).join(",  "), "t0 mute", /(?<=, {2})/)
    this.write(link(page), "t0 mute", /(?<=[?&,])|(?<=.{60})(?=.{20})/)
  }

  /** @param {string} title @returns {Picture} */
  done(title) {
    const {width} = this
    const height = Math.ceil(this.y + EDGE)
    this.svg.prepend(svg("title", {}, title), svg("rect", {class: "ground", width, height}))
    setAttributes(this.svg, {width, height, viewBox: `0 0 ${width} ${height}`, xmlns: "http://www.w3.org/2000/svg"})
    leaveOut(this.svg)
    inline(this.svg)
    const picture = {svg: new XMLSerializer().serializeToString(this.svg), width, height}
    this.host.remove()
    return picture
  }

  /** The drawing, without the empty paper around it. @param {string} title @returns {Picture} */
  trimmed(title) {
    const drawn = this.svg.getBBox()
    const picture = this.done(title)
    const left = Math.max(0, Math.floor(drawn.x) - EDGE)
    const top = Math.max(0, Math.floor(drawn.y) - EDGE)
    const width = Math.min(picture.width, Math.ceil(drawn.x + drawn.width) + EDGE) - left
    const height = Math.min(picture.height, Math.ceil(drawn.y + drawn.height) + EDGE) - top
    const box = `viewBox="${left} ${top} ${width} ${height}"`
    return {svg: picture.svg.replace(/viewBox="[^"]*"/, box), width, height}
  }
}

/**
 * A plot; `captioned` adds the parameters and the link. `wide` is the width of the picture, `high` the height of the
 * frame in it, both in units.
 * @param {Plot} plot @param {boolean} [captioned] @param {number} [wide] @param {number} [high] @returns {Picture}
 */
export function plotPicture(plot, captioned = true, wide = WIDE, high = (HIGH * wide) / WIDE) {
  const {block, page, view} = plot
  const easel = new Easel(wide)
  easel.write(`${block.title}.`, "t1 b title")
  const terms = legend(plot)
  if (terms.length) easel.list(terms)
  else if (block.marks.length) easel.y += LINE // room for flags above the frame
  const frame = frameFor(plot, wide, high)
  const host = element("div", {class: "easel-part"})
  host.style.width = long(wide)
  host.style.height = long(frame.top + frame.height + 30)
  easel.host.append(host)
  const drawing = new Drawing(plot, host, frame, true)
  setAttributes(drawing.over, {transform: `translate(0 ${easel.y})`})
  easel.svg.append(drawing.over)
  drawing.draw(evaluate(view.signals, view.scalars, page.clock.t))
  easel.y += frame.top + frame.height + 26
  if (captioned) easel.caption(page)
  return easel.done(block.title)
}

/**
 * The margins of the frame for numbers, names and flags, which can be outside the box of the plot on the page.
 * @param {Plot} plot @param {number} wide @param {number} high
 */
function frameFor(plot, wide, high) {
  const {frame, host, block} = plot
  const left = Math.max(frame.left, ...numbered(plot).y.labels.map(label => textWidth(label) + 7)) + 10
  const names = block.curves.map(({label}) => 1.15 * textWidth(label.map(({text}) => text).join("")) + 14)
  const right = Math.max(host.clientWidth / unitSize() - frame.left - frame.width, 40, ...names)
  const most = wide - left - right
  const height = block.square ? Math.min((most * frame.height) / frame.width, most) : high
  return {left, top: frame.top + 8, width: block.square ? (height * frame.width) / frame.height : most, height}
}

/** The terms in the heading, without those that the title repeats. @param {Plot} plot */
function legend({block, host}) {
  const parts = [...(host.parentElement?.querySelectorAll(".head .part") ?? [])]
  const seen = parts.map(part => getComputedStyle(part).visibility === "visible")
  const terms = parts.map((part, i) => ({...block.heading[i], text: seen[i] ? plain(part).trim() : ""}))
  const isTitle = (/** @type {string} */ text) =>
    block.title.split(/[,: ]+/).includes(text) || block.title.startsWith(`${text}:`)
  const words = terms.filter(
    ({key, text, curve}, i) =>
      text && !(key === "none" && isTitle(text)) && !(curve && parts[i].classList.contains("off")),
  )
  const [before, last] = words.slice(-2)
  if (last?.key !== "none" || last.text.length > UNIT) return words
  return [...words.slice(0, -2), {...before, text: `${before.text} ${last.text}`}]
}

/** @param {string} key */
function sample(key) {
  if (key === "none") return []
  if (key === "band") return [svg("rect", {class: "body", width: 12, height: 12, y: -10, x: 8})]
  return [svg("line", {class: `ln ${key}`, x1: 0, x2: 22, y1: -4, y2: -4})]
}

/**
 * The current stage, with the plots under it.
 * @param {Stage} stage @param {PartHost} page @param {boolean} [captioned] @returns {Picture}
 */
export function stagePicture(stage, page, captioned = true) {
  const under = plotsUnder(stage, page)
  const written = [...stage.svg.querySelectorAll("text")].filter(text => text.getBoundingClientRect().width)
  const box = around([stage.host, ...under.map(plot => plot.host), ...written])
  const easel = new Easel(Math.max(Math.ceil(box.width) + 4 * EDGE, WIDE))
  if (captioned) easel.write(`${page.spec.headline}.`, "t1 b title")
  const drawn = svg("g", {transform: `translate(${2 * EDGE} ${easel.y + EDGE})`})
  easel.svg.append(drawn)
  const {view} = page.shown
  const named = evaluate(view.signals, view.scalars, page.clock.t)
  for (const plot of under) drawn.append(shifted(plotAt(plot, easel, named), plot.host, box))
  drawn.append(shifted(svg("g", {}, ...seenOf(stage.svg)), stage.host, box))
  easel.y += box.height + 2 * EDGE
  if (captioned) easel.caption(page, instant(page))
  return captioned ? easel.done(page.spec.headline) : easel.trimmed(page.spec.headline)
}

/** The plots in the picture of a stage. @param {Stage} stage @param {PartHost} page */
export const plotsUnder = (stage, page) =>
  page.plots.filter(
    plot => plot.box && isSeen(plot.host) && (page.sheet.isBeside(plot, stage) || writesInto(stage, plot)),
  )

/** A copy of a drawing without hidden parts. @param {SVGElement} drawn */
function seenOf(drawn) {
  const copy = /** @type {SVGElement} */ (drawn.cloneNode(true))
  const copies = [...copy.querySelectorAll("*")]
  for (const [i, one] of [...drawn.querySelectorAll("*")].entries())
    if (getComputedStyle(one).visibility === "hidden") copies[i].remove()
  return copy.childNodes
}

/** @param {Plot} plot @param {Easel} easel @param {Named} named */
function plotAt(plot, easel, named) {
  const host = element("div", {class: "easel-part"})
  host.style.width = `${plot.host.clientWidth}px`
  host.style.height = `${plot.host.clientHeight}px`
  easel.host.append(host)
  const drawing = new Drawing(plot, host, plot.frame)
  easel.svg.append(drawing.over)
  drawing.draw(named, []) // the shapes of the stage over the plot come with the stage
  return drawing.over
}

/** True if a stage draws into the frame of a plot. @param {Stage} stage @param {Plot} plot */
const writesInto = (stage, {block}) =>
  stage.shapes.some(({spec, group, needs}) => {
    const isShown = spec.kind === "text" && group.style.display === ""
    const isAt = (/** @type {string[]} */ ...ends) => ends.some(end => needs.has(`${block.name}.${end}`))
    const isAcross = isAt("left", "right") || [...needs].some(name => name.endsWith(".x1"))
    return isShown && isAcross && isAt("y1", "top", "bottom")
  })

/** The rectangle that holds all of these. @param {Element[]} hosts */
function around(hosts) {
  const boxes = hosts.map(host => host.getBoundingClientRect())
  const left = Math.min(...boxes.map(box => box.left))
  const top = Math.min(...boxes.map(box => box.top))
  const width = Math.max(...boxes.map(box => box.right)) - left
  const height = Math.max(...boxes.map(box => box.bottom)) - top
  return {left, top, width: width / unitSize(), height: height / unitSize()}
}

/** @param {SVGElement} part @param {HTMLElement} host @param {Frame} box */
function shifted(part, host, box) {
  const {left, top} = host.getBoundingClientRect()
  setAttributes(part, {transform: `translate(${(left - box.left) / unitSize()} ${(top - box.top) / unitSize()})`})
  return part
}

/** Removes lines to other parts of the page, which are mostly outside the picture. @param {SVGElement} root */
function leaveOut(root) {
  const paper = root.getBoundingClientRect()
  for (const line of root.querySelectorAll("line")) {
    const {left, right, top, bottom} = line.getBoundingClientRect()
    const across = Math.min(right, paper.right) - Math.max(left, paper.left)
    const down = Math.min(bottom, paper.bottom) - Math.max(top, paper.top)
    if (2 * Math.max(across, down) < Math.max(right - left, bottom - top)) line.remove()
  }
}

/**
 * Copies the styles of the style sheets to attributes of the elements, and removes elements that are not drawn.
 * @param {Element} root
 */
function inline(root) {
  const all = [...root.querySelectorAll("*")].map(one => ({one, look: lookOf(one)}))
  for (const {one, look} of all) {
    if (!look) one.remove()
    for (const name of ["class", "style", "data-value"]) one.removeAttribute(name)
    setAttributes(one, look ?? {})
  }
  root.removeAttribute("class")
}

/** @param {Element} one @returns {Record<string, string> | null} */
function lookOf(one) {
  const style = getComputedStyle(one)
  if (style.display === "none") return null
  const names = one.matches("text, tspan") ? [...Object.keys(LOOK), ...TYPE] : Object.keys(LOOK)
  const pairs = names.map(name => [name, style.getPropertyValue(name)])
  return Object.fromEntries(pairs.filter(([name, value]) => value !== LOOK[name]))
}

/** A picture as a PNG at twice its size. @param {Picture} picture @returns {Promise<Blob>} */
export async function png({svg: text, width, height}) {
  const image = new Image()
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`
  await image.decode()
  const canvas = element("canvas", {width: 2 * width, height: 2 * height})
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height)
  return new Promise((done, fail) =>
    canvas.toBlob(blob => (blob ? done(blob) : fail(new Error("no room"))), "image/png"),
  )
}
