// Conversion between coordinates of an axis and values in SI units.

/** An axis for quantities that are on no plot: values in SI units, unchanged. @type {page.Ruler} */
export const PLAIN = {start: 0, end: 1, ticks: [], labels: [], unit: "", exponent: 0, factor: 1, power: 1, log: false}

/**
 * The server sends columns as integers from 0 to this one, over three heights of the frame
 * (components/state/encoding.py).
 */
export const COLUMN_STEPS = 2 ** 16 - 1

/** One step of these integers in the unit of the axis. @param {page.Ruler} ruler */
export const stepOf = ({start, end}) => (3 * Math.abs(end - start)) / COLUMN_STEPS

/** The nearest number in a range. @param {number} value @param {number} low @param {number} high */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high)

/** The value in SI units at a coordinate of the axis. @param {page.Ruler} ruler @param {number} place */
export function toSI({log, power, exponent, factor}, place) {
  return (log ? 10 ** place : place ** (1 / power) * 10 ** (exponent / power)) * factor
}

/** The coordinate of an SI value on the axis. @param {page.Ruler} ruler @param {number} value */
export function toPlace({log, power, exponent, factor}, value) {
  return log ? Math.log10(value / factor) : (value / factor / 10 ** (exponent / power)) ** power
}

/**
 * Gives both axes of a box the same scale, by widening the range of one of them.
 * @param {page.Ruler} x @param {page.Ruler} y @param {{width: number, height: number}} box
 */
export function toOneScale(x, y, {width, height}) {
  const unit = 10 ** (x.exponent - y.exponent) // the unit of x, measured in units of y
  const scale = Math.max((unit * (x.end - x.start)) / width, (y.end - y.start) / height)
  return [widened(x, (scale * width) / unit), widened(y, scale * height)]
}

/** The axis with a range of this size around the same middle. @param {page.Ruler} ruler @param {number} size */
function widened(ruler, size) {
  const middle = (ruler.start + ruler.end) / 2
  return {...ruler, start: middle - size / 2, end: middle + size / 2}
}
