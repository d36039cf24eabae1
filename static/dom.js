// Small helpers to build elements, and the colours of quantities as they now are.

const SVG = "http://www.w3.org/2000/svg"

export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag)
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined && value !== null) made.setAttribute(key, value)
  made.append(...children)
  return made
}

export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag)
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined && value !== null) made.setAttribute(key, value)
  made.append(...children)
  return made
}

export const colour = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim()

// "*x*_1 = {x1} m": *...* is a symbol in serif italic, _1 or _{...} a subscript, {name} a live number.
export function words(text) {
  const parts = []
  for (const [, symbol, wide, narrow, name, plain] of text.matchAll(/\*([^*]+)\*|_\{([^}]+)\}|_(\w)|\{(\w+)\}|([^*_{]+|[*_{])/g)) {
    if (symbol) parts.push(svg("tspan", {class: "v"}, symbol))
    else if (wide || narrow) {
      parts.push(svg("tspan", {class: "sub", dy: "0.28em"}, wide || narrow), svg("tspan", {dy: "-0.22em"}, "\u200b"))
    } else if (name) parts.push(svg("tspan", {"data-value": name}))
    else parts.push(plain)
  }
  return parts
}

// A number that changes while playing: a fixed number of decimals, a true minus, always signed when asked.
export function live(value, decimals, signed) {
  let shown = Math.abs(value).toFixed(decimals)
  const negative = value < 0 && Number(shown) !== 0
  return (negative ? "−" : signed ? "+" : "") + shown
}

const ruler = document.createElement("canvas").getContext("2d")

// Pixels that a small text takes.
export function textWidth(text) {
  ruler.font = `${colour("t0")} ${colour("sans")}`
  return ruler.measureText(text).width
}
