// Formulas and sentences as plain text, for saved pictures and for screen readers.

const LOW = new Map(
  [..."0123456789+-−()=aehijklmnoprstuvx"].map((sign, i) => [sign, "₀₁₂₃₄₅₆₇₈₉₊₋₋₍₎₌ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ"[i]]),
)
const HIGH = new Map([..."0123456789+-−()n"].map((sign, i) => [sign, "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁽⁾ⁿ"[i]]))
/** @type {Record<string, string>} */
const OVER = {"˙": "\u0307", "¨": "\u0308", ".": "\u0307", "..": "\u0308", "^": "\u0302", "¯": "\u0304", "→": "\u20d7"}
const WORD = /^[a-z]+$/i
const APART = "=+−-±<>≤≥≈→⇒≠×·"

/**
 * A text as an index or a power: in small Unicode characters if all of its characters have one, else after a mark such
 * as _ or ^.
 * @param {string} text @param {Map<string, string>} signs @param {string} mark
 */
function shifted(text, signs, mark) {
  const all = [...text].map(sign => signs.get(sign))
  if (all.every(Boolean)) return all.join("")
  return text.length > 1 && !WORD.test(text) ? `${mark}(${text})` : mark + text
}

/** k_2 as k₂. @param {string} symbol */
export function indexed(symbol) {
  const [letter, index] = symbol.split("_")
  return letter + (index ? shifted(index, LOW, "_") : "")
}

/** A text in brackets, unless it is a single term. @param {string} text */
const bracketed = text => (/^[^\s+−=/]+$/.test(text) ? text : `(${text})`)

/** @type {Record<string, (parts: string[], node: Element) => string>} */
const MATH = {
  mfrac: ([over, under]) => `${bracketed(over)}/${bracketed(under)}`,
  msqrt: parts => `√${bracketed(parts.join("").trim())}`,
  msub: ([base, index]) => base + shifted(index.trim(), LOW, "_"),
  msup: ([base, power]) => bracketed(base) + shifted(power.trim(), HIGH, "^"),
  msubsup: ([base, index, power]) => base + shifted(index.trim(), LOW, "_") + shifted(power.trim(), HIGH, "^"),
  mover: ([base, accent]) => base + (OVER[accent.trim()] ?? accent),
  mspace: () => " ",
  mo: ([sign], node) => (APART.includes(sign) && node.getAttribute("form") !== "prefix" ? ` ${sign} ` : sign),
  sub: parts => shifted(parts.join(""), LOW, "_"),
}

/** The visible text of an element. @param {Node} node @returns {string} */
export function plain(node) {
  if (node.nodeType === Node.TEXT_NODE) return (node.textContent ?? "").replace(/\s+/g, " ")
  if (!(node instanceof Element) || isHidden(node)) return ""
  const parts = [...node.childNodes].map(plain)
  const spoken = MATH[node.localName]?.(parts, node) ?? parts.join("")
  return node.localName === "math"
    ? spoken
        .replace(/\s+/g, " ")
        .replace(/([(|]) | ([)|])/g, "$1$2")
        .trim()
    : spoken
}

/** A text without its markup. @param {page.Html} html */
export const bare = html => new DOMParser().parseFromString(html, "text/html").body.textContent ?? ""

/** @param {Element} node */
const isHidden = node => node.hasAttribute("hidden") || (node instanceof HTMLElement && node.style.display === "none")
