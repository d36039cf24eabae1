// Small helpers to build elements, and the current colours of quantities.

const SVG = "http://www.w3.org/2000/svg"

/**
 * Attributes of an element; those without a value are left out.
 * @typedef {Record<string, string | number | boolean | null | undefined>} Attributes
 */

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...(Node | string)} children
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag)
  setAttributes(made, attributes)
  made.append(...children)
  return made
}

/**
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...(Node | string)} children
 */
export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag)
  setAttributes(made, attributes)
  made.append(...children)
  return made
}

/** A button with its action. @param {Attributes} look @param {() => void} act @param {...(Node | string)} children */
export function button(look, act, ...children) {
  const made = element("button", {type: "button", ...look}, ...children)
  made.addEventListener("click", () => act())
  return made
}

/** A small button with a text. @param {string} name @param {() => void} act @param {Attributes} [look] */
export const chip = (name, act, look = {}) => button({class: "chip", ...look}, act, name)

/**
 * Sets the text of a part if it differs, and returns true then. An equal text is neither drawn nor read out again.
 * @param {Node} part @param {string} text
 */
export function reword(part, text) {
  if (part.textContent === text) return false
  const first = part.firstChild // nodeType 3 is a text node
  // Reuse the text node, because a new node would need more layout in each frame.
  if (first?.nodeType === 3 && !first.nextSibling) first.nodeValue = text
  else part.textContent = text
  return true
}

/**
 * Sets only the attributes that differ, because the browser recomputes styles even for an equal value.
 * @param {Element} target @param {Attributes} attributes
 */
export function setAttributes(target, attributes) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null) continue
    const text = String(value)
    if (target.getAttribute(key) !== text) target.setAttribute(key, text)
  }
}

/**
 * An element with HTML from our server as its content.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} attributes @param {page.Html} html
 */
export function marked(tag, attributes, html) {
  const made = element(tag, attributes)
  made.innerHTML = html
  return made
}

/** Scrolls a row of buttons that is wider than the screen to one of them. @param {HTMLElement} one */
export function intoView({offsetLeft, offsetWidth, parentElement: row}) {
  if (row) row.scrollLeft = offsetLeft + offsetWidth / 2 - row.clientWidth / 2
}

/** @type {Map<string, string>} */
const tokens = new Map()

/** @type {Map<string, (style: CSSStyleDeclaration) => string>} */
const asked = new Map()

/**
 * The value of a custom property of the style sheets. Looked up once per task of the event loop, because it cannot
 * change meanwhile.
 */
export const colour = (/** @type {string} */ name) =>
  once(`--${name}`, style => style.getPropertyValue(`--${name}`).trim())

/** A unit in pixels: 1/16 of the text size. Drawings are measured in units, so they grow with the text. */
export const unitSize = () => Number(once("unit", ({fontSize}) => String(parseFloat(fontSize) / 16)))

/** The size of a text or a line in units: "t0", "w1". @param {string} name */
export const units = name => Number(colour(name).match(/[\d.]+/)?.[0])

/** A length in units, for a style. @param {number} length */
export const long = length => `${length / 16}rem`

/** @param {string} name @param {(style: CSSStyleDeclaration) => string} find */
function once(name, find) {
  asked.set(name, find)
  if (!tokens.size) {
    queueMicrotask(() => tokens.clear())
    settle()
  }
  const known = tokens.get(name) ?? find(getComputedStyle(document.documentElement))
  tokens.set(name, known)
  return known
}

/** Reads all values at once, before anything is written, because a read after a write recomputes the page's styles. */
function settle() {
  const style = getComputedStyle(document.documentElement)
  for (const [name, find] of asked) tokens.set(name, find(style))
}

/** Gives an SVG coordinates in units. @param {SVGSVGElement} drawing @param {number} width @param {number} height */
export function inUnits(drawing, width, height) {
  if (width > 0 && height > 0) drawing.setAttribute("viewBox", `0 0 ${width} ${height}`)
}

/**
 * The runs of a short text: plain, the symbol of a quantity in serif italic, its index, a live number.
 * @type {Record<page.TextRun["kind"], (text: string) => (Node | string)[]>}
 */
const RUNS = {
  plain: text => [text],
  symbol: text => [svg("tspan", {class: "v"}, text)],
  index: text => [svg("tspan", {class: "sub", dy: "0.28em"}, text), svg("tspan", {dy: "-0.22em"}, "\u200b")],
  value: text => [svg("tspan", {"data-value": text})],
}

/** @param {page.Runs} runs */
export const words = runs => runs.flatMap(({kind, text}) => RUNS[kind](text))

/** Waits for the next frame, or 50 ms in a hidden tab, which has no frames. */
export const frame = () => Promise.race([new Promise(requestAnimationFrame), new Promise(done => setTimeout(done, 50))])

/** The box of the surface behind a part: paper or panel, or the whole page on a phone. */
export const surface = (/** @type {Element} */ part) =>
  [".paper, .panel", ".page"].map(kind => part.closest(kind)?.getBoundingClientRect()).find(box => box?.width)

const ruler = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d"))

/** The width of a text and the size of its letters, in units. @param {SVGTextElement} text */
export function extent(text) {
  text.style.display = ""
  const [width, size] = [text.getComputedTextLength(), parseFloat(getComputedStyle(text).fontSize)]
  return {width, size, font: text.style.fontSize}
}

/**
 * Makes a text smaller if it is wider than its room, down to half its size; returns its width and size in units.
 * @param {SVGTextElement} text @param {number} room
 */
export function shrunk(text, room) {
  text.style.fontSize = ""
  const {width, size} = extent(text)
  const share = Math.max(0.5, Math.min(1, room / width))
  if (share < 1) text.style.fontSize = `${share * size}px`
  return {width: share * width, size: share * size, font: text.style.fontSize}
}

/** The width of a small text in units. @param {string} text */
export function textWidth(text) {
  ruler.font = `${units("t0")}px ${colour("sans")}`
  return ruler.measureText(text).width
}
