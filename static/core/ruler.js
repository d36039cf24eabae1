// Conversion between coordinates of an axis and values in SI units.

/** The axis of a quantity that is drawn on none. @type {page.Ruler} */
export const PLAIN = {start: 0, end: 1, ticks: [], labels: [], unit: "", exponent: 0, factor: 1, power: 1, log: false}

/** The steps of three heights of the frame in which columns are sent: components/state/encoding.py. */
export const COLUMN_STEPS = 2 ** 16 - 1

/** One of them, as the axis counts. @param {page.Ruler} ruler */
export const stepOf = ({start, end}) => (3 * Math.abs(end - start)) / COLUMN_STEPS

/** The nearest number that is not beyond two ends. @param {number} value @param {number} low @param {number} high */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high)

/** The quantity in SI at a place of the axis. @param {page.Ruler} ruler @param {number} place */
export function toSI({log, power, exponent, factor}, place) {
  return (log ? 10 ** place : place ** (1 / power) * 10 ** (exponent / power)) * factor
}

/** The coordinate of an SI value on the axis. @param {page.Ruler} ruler @param {number} value */
export function toPlace({log, power, exponent, factor}, value) {
  return log ? Math.log10(value / factor) : (value / factor / 10 ** (exponent / power)) ** power
}

/**
 * Both axes at one scale in a box: the one with room to spare shows more than it was asked to.
 * @param {page.Ruler} x @param {page.Ruler} y @param {{width: number, height: number}} box
 */
export function toOneScale(x, y, {width, height}) {
  const unit = 10 ** (x.exponent - y.exponent) // one of x, counted as y is
  const scale = Math.max((unit * (x.end - x.start)) / width, (y.end - y.start) / height)
  return [widened(x, (scale * width) / unit), widened(y, scale * height)]
}

/** An axis around the same middle that spans `size`. @param {page.Ruler} ruler @param {number} size */
function widened(ruler, size) {
  const middle = (ruler.start + ruler.end) / 2
  return {...ruler, start: middle - size / 2, end: middle + size / 2}
}
