// Formats numbers for people. The texts are the same as those of components/quantities/formatting.py.

/** Matches keys that can begin a number. */
export const BEGINS_NUMBER = /^[\d.,+\u2212-]$/

export const MINUS = "−"
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"

/** True if a number of this size is written without a power of ten. @param {number} exponent */
const isPlain = exponent => exponent >= -3 && exponent < 5

/**
 * A number with `count` significant digits and trailing zeros: 2.00, 0.0400, −1.24, 1.23·10⁻⁷.
 * @param {number} value @param {number} [count]
 */
export function three(value, count = 3) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "NaN" : `${value > 0 ? "" : MINUS}∞`
  if (value === 0) return value.toFixed(count - 1)
  const [digits, exponent] = rounded(Math.abs(value), count)
  const sign = value < 0 ? MINUS : ""
  return isPlain(exponent) ? sign + pointed(digits, exponent) : `${sign}${pointed(digits, 0)}·10${raised(exponent)}`
}

/** Three significant digits, always with a sign. @param {number} value */
export function signed(value) {
  const text = three(value)
  return text.startsWith(MINUS) ? text : `+${text}`
}

/**
 * A number with at most `most` significant digits and no trailing zeros: 5, 0.2, 2·10⁻⁷.
 * @param {number} value @param {number} [most]
 */
export function short(value, most = 3) {
  const [head, ...power] = three(value, most).split("·")
  return [head.includes(".") ? head.replace(/\.?0+$/, "") : head, ...power].join("·")
}

/** The text of a field: three digits, or as many as are needed to read back the same number. @param {number} value */
export function tidy(value) {
  if (value === 0) return "0.00"
  const [digits, exponent] = parts(Math.abs(value).toExponential())
  const sign = value < 0 ? "-" : ""
  if (isPlain(exponent)) return sign + pointed(digits.padEnd(3, "0"), exponent)
  return `${sign}${pointed(digits, 0)}e${exponent}`
}

/**
 * A number with a fixed count of decimals, for numbers that change while playing; with a sign if `always`.
 * @param {number} value @param {number} decimals @param {boolean} [always]
 */
export function fixed(value, decimals, always = false) {
  const shown = Math.abs(value).toFixed(decimals)
  if (value < 0 && Number(shown) !== 0) return MINUS + shown
  return always ? `+${shown}` : shown
}

/** A count, in three digits: 123 000 with thin spaces, from a million on 1.23·10⁶. @param {number} count */
export function grouped(count) {
  return count < 1e6 ? Number(count.toPrecision(3)).toLocaleString("en").replaceAll(",", "\u202f") : short(count)
}

/** A number and its unit, with a space between them, except for degrees. @param {string} number @param {string} unit */
export const withUnit = (number, unit) => `${number}${unit === "°" || unit.startsWith("·") ? "" : " "}${unit}`.trim()

/** A typed text in the notation of the page. @param {string} text */
export const withTrueMinus = text => text.replaceAll("-", MINUS)

/** An exponent in superscript digits. @param {number} exponent */
function raised(exponent) {
  return [...String(exponent)].map(sign => SUPERSCRIPTS[Number(sign)] ?? "⁻").join("")
}

/** @param {string} text @returns {[string, number]} the digits and the power of ten of the first, of "1.25e-7" */
function parts(text) {
  const [mantissa, exponent] = text.split("e")
  return [mantissa.replace(".", ""), Number(exponent)]
}

/** Rounds as Python does, half to even. @param {number} size @param {number} count */
function rounded(size, count) {
  // oxlint-disable-next-line number-arg-out-of-range -- 100 digits are allowed, and no tie has more than 60
  const [digits, exponent] = parts(size.toExponential(60))
  const kept = digits.slice(0, count)
  const isTie = /^50*$/.test(digits.slice(count))
  return isTie && Number(kept) % 2 === 0
    ? /** @type {[string, number]} */ ([kept, exponent])
    : parts(size.toExponential(count - 1))
}

/**
 * Digits with a decimal point, if the first digit is worth 10^exponent.
 * @param {string} digits @param {number} exponent
 */
function pointed(digits, exponent) {
  if (exponent < 0) return `0.${"0".repeat(-exponent - 1)}${digits}`
  const whole = digits.slice(0, exponent + 1).padEnd(exponent + 1, "0")
  const fraction = digits.slice(exponent + 1)
  return fraction ? `${whole}.${fraction}` : whole
}
