// Unpacks messages: inflates them with the preset dictionary, reads their numbers, and samples the signals that are
// drawn over time (the browser's half of wire.py and encoding.py in components/state).

import {COLUMN_STEPS} from "../core/ruler.js"
import {over} from "../core/signals.js"

const FINE = 2 ** 24 - 1
const ORDER = 4
const LINE_FEED = 10

/** @param {ArrayBuffer} data @param {string} presetDictionary from the sheet @returns {Promise<ServerMessage>} */
export async function unpacked(data, presetDictionary) {
  const bytes = await inflated(new Uint8Array(data), new TextEncoder().encode(presetDictionary))
  const end = bytes.indexOf(LINE_FEED)
  const message = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)))
  if (message.view) fill(message, bytes.subarray(end + 1))
  return message
}

/**
 * Inflates a message with a preset dictionary. The dictionary is put in front as a stored block, so that
 * DecompressionStream, which has no parameter for it, can be used.
 * @param {Uint8Array<ArrayBuffer>} data @param {Uint8Array} dictionary
 */
async function inflated(data, dictionary) {
  const {length} = dictionary
  const stored = new Uint8Array(5 + length)
  stored.set([0, length & 255, length >> 8, ~length & 255, (~length >> 8) & 255])
  stored.set(dictionary, 5)
  const {readable, writable} = new DecompressionStream("deflate-raw")
  const writer = writable.getWriter()
  const written = [writer.write(stored), writer.write(data), writer.close()]
  const [whole] = await Promise.all([new Response(readable).arrayBuffer(), ...written])
  return new Uint8Array(whole, length)
}

/**
 * Replaces the descriptions of columns and samples by their numbers: first of the view, then of the compared picture.
 * @param {any} message @param {Uint8Array} data
 */
function fill({view, held}, data) {
  const numbers = new Numbers(data)
  for (const part of held ? [view, held] : [view]) {
    fillPart(part, view.axes, numbers)
    for (const [source, trace] of Object.entries(part.traces))
      part.columns[source] = {...traced(trace, part), ...part.columns[source]}
  }
}

/** @param {any} part @param {Record<string, page.Ruler>} axes @param {Numbers} numbers */
function fillPart(part, axes, numbers) {
  for (const source of Object.values(part.columns)) {
    for (const [name, [axis, count]] of Object.entries(source)) {
      const {start, end} = axes[axis]
      const [low, high] = start < end ? [start, end] : [end, start]
      const height = high - low // each integer is a step of a range that is three frames high
      source[name] = numbers.take(count, low - height, high + height, COLUMN_STEPS)
    }
  }
  for (const signal of Object.values(part.signals).filter(({kind}) => kind === "sampled")) {
    for (const run of ["y", "dy"]) {
      const {count, low, high} = signal[run]
      signal[run] = numbers.take(count, low, high, FINE)
    }
  }
}

/**
 * The columns of signals over time.
 * @param {page.Trace} trace @param {Pick<page.PagePicture, "signals" | "scalars">} part
 * @returns {Record<string, Float64Array>}
 */
function traced([end, count, names, called], {signals, scalars}) {
  const t = Float64Array.from({length: count}, (_, i) => (i / (count - 1)) * end)
  const drawn = over(signals, scalars, t, new Set(names.map(name => called[name] ?? name)))
  return {t, ...Object.fromEntries(names.map(name => [name, drawn[called[name] ?? name]]))}
}

/** Reads runs of numbers, sent as 16-bit differences of the fourth order: first all low bytes, then all high bytes. */
class Numbers {
  at = 0

  /** @param {Uint8Array} bytes */
  constructor(bytes) {
    this.bytes = bytes
    this.total = bytes.length / 4
  }

  /**
   * Reads the next run of numbers: integers from 0 to `steps` stand for `low` to `high`.
   * @param {number} count @param {number} low @param {number} high @param {number} steps
   */
  take(count, low, high, steps) {
    const sums = new Int32Array(ORDER)
    return Float64Array.from({length: count}, () => {
      let step = this.#difference(this.at++)
      for (let i = 0; i < ORDER; i++) step = sums[i] += step
      return low * (1 - step / steps) + high * (step / steps)
    })
  }

  /** Decodes a signed number: d >= 0 is sent as 2d, d < 0 as -2d - 1. @param {number} i */
  #difference(i) {
    const {bytes, total} = this
    const sent = bytes[i] | (bytes[total + i] << 8) | (bytes[2 * total + i] << 16) | (bytes[3 * total + i] << 24)
    return (sent >>> 1) ^ -(sent & 1)
  }
}
