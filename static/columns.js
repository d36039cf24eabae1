// A message as it comes, made whole: inflated after the usual text that it refers to, its columns numbers again (the
// browser's half of components/wire.py and components/places.py).

const COARSE = 2 ** 16 - 1
const FINE = 2 ** 24 - 1
const SUM = 8 // added to the order of a run from which the two before it have been taken
const LINE_FEED = 10

/** @param {ArrayBuffer} data @param {string} usual the sheet's @returns {Promise<Told>} */
export async function unpacked(data, usual) {
  const bytes = await inflated(new Uint8Array(data), new TextEncoder().encode(usual))
  const end = bytes.indexOf(LINE_FEED)
  const told = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)))
  if (told.view) fill(told, bytes.subarray(end + 1))
  return told
}

/**
 * What the message refers to comes first, in a block that is stored as it is: so any inflate knows it.
 * @param {Uint8Array<ArrayBuffer>} data @param {Uint8Array} before
 */
async function inflated(data, before) {
  const {length} = before
  const stored = new Uint8Array(5 + length)
  stored.set([0, length & 255, length >> 8, ~length & 255, (~length >> 8) & 255])
  stored.set(before, 5)
  const {readable, writable} = new DecompressionStream("deflate-raw")
  const writer = writable.getWriter()
  const written = [writer.write(stored), writer.write(data), writer.close()]
  const [whole] = await Promise.all([new Response(readable).arrayBuffer(), ...written])
  return new Uint8Array(whole, length)
}

/**
 * Puts numbers in place of what is said of columns and samples: of the view, then of what is held beside it.
 * @param {any} told @param {Uint8Array} data
 */
function fill({view, held}, data) {
  const parts = held ? [view, held] : [view]
  const numbers = new Numbers(
    data,
    parts.reduce((count, part) => count + runsIn(part), 0),
  )
  for (const part of parts) fillPart(part, view.axes, numbers)
}

/** @param {any} part */
const sampledIn = ({signals}) => Object.values(signals).filter(({kind}) => kind === "sampled")

/** @param {any} part @returns {number} */
const runsIn = part => Object.values(part.columns).flatMap(Object.keys).length + 2 * sampledIn(part).length

/** @param {any} part @param {Record<string, page.Ruler>} axes @param {Numbers} numbers */
function fillPart(part, axes, numbers) {
  for (const source of Object.values(part.columns)) {
    for (const [name, [axis, count]] of Object.entries(source)) {
      const {start, end} = axes[axis]
      const [low, high] = start < end ? [start, end] : [end, start]
      const height = high - low // the steps are of three heights of the frame
      source[name] = Float32Array.from(numbers.take(count, low - height, high + height, COARSE))
    }
  }
  for (const signal of sampledIn(part)) {
    for (const run of ["y", "dy"]) {
      const {count, low, high} = signal[run]
      signal[run] = numbers.take(count, low, high, FINE)
    }
  }
}

/** Runs of numbers: the order of the differences of each, then all first bytes of these, all second ones, and so on. */
class Numbers {
  run = 0
  at = 0
  /** @type {Int32Array[]} the two last runs, in steps */
  before = []

  /** @param {Uint8Array} data @param {number} runs */
  constructor(data, runs) {
    this.orders = data.subarray(0, runs)
    this.bytes = data.subarray(runs)
    this.total = this.bytes.length / 4
  }

  /**
   * The next run, sent in steps from low to high.
   * @param {number} count @param {number} low @param {number} high @param {number} steps
   */
  take(count, low, high, steps) {
    const whole = Int32Array.from({length: count}, (_, i) => this.#difference(this.at + i))
    const order = this.orders[this.run]
    for (let left = order % SUM; left > 0; left--) {
      for (let i = 1; i < count; i++) whole[i] += whole[i - 1]
    }
    if (order >= SUM) for (const part of this.before) part.forEach((step, i) => (whole[i] += step))
    this.before = [...this.before.slice(-1), whole]
    this.at += count
    this.run += 1
    return Float64Array.from(whole, step => low * (1 - step / steps) + high * (step / steps))
  }

  /** One that is d >= 0 is sent as 2d, one below as -2d - 1. @param {number} i */
  #difference(i) {
    const {bytes, total} = this
    const sent = bytes[i] | (bytes[total + i] << 8) | (bytes[2 * total + i] << 16) | (bytes[3 * total + i] << 24)
    return (sent >>> 1) ^ -(sent & 1)
  }
}
