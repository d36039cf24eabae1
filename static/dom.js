// Small helpers to build elements, and the colours of quantities as they now are.

const SVG = "http://www.w3.org/2000/svg"

/**
 * Those without a value are left out.
 * @typedef {Record<string, string | number | boolean | null | undefined>} Attributes
 */

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...(Node | string)} children
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag)
  set(made, attributes)
  made.append(...children)
  return made
}

/**
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...(Node | string)} children
 */
export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag)
  set(made, attributes)
  made.append(...children)
  return made
}

/** @param {Element} target @param {Attributes} attributes */
export function set(target, attributes) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== null) target.setAttribute(key, String(value))
  }
}

/**
 * An element with HTML of our own server as its content.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} attributes @param {page.Html} html
 */
export function marked(tag, attributes, html) {
  const made = element(tag, attributes)
  made.innerHTML = html
  return made
}

/** @type {Map<string, string>} */
const tokens = new Map()

/** A token of the style sheet. Each is looked up once in a run: what is written meanwhile changes none of them. */
export function colour(/** @type {string} */ name) {
  if (!tokens.size) queueMicrotask(() => tokens.clear())
  const known = tokens.get(name) ?? getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim()
  tokens.set(name, known)
  return known
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

const ruler = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d"))

/** Pixels that a small text takes. @param {string} text */
export function textWidth(text) {
  ruler.font = `${colour("t0")} ${colour("sans")}`
  return ruler.measureText(text).width
}
