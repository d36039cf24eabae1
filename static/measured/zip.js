// The tables in a zip file, as phyphox and other apps save them. The browser inflates them, up to a limit.

import {MOST_BYTES} from "./table.js"

const START = 0x04034b50 // "PK", with which any zip file begins
const END = 0x06054b50
const ENTRY = 0x02014b50
const STORED = 0
const DEFLATED = 8
const LONGEST_END = 65_557 // bytes that the directory's end record can take, with the longest comment
const MOST_TABLES = 50
const TABLES = /^(?!meta\/|__MACOSX\/).*\.(csv|tsv|txt)$/i
const NO_TABLES = "it has no CSV file. Export the measurement as CSV."
const TOO_LARGE = "its tables have more than 5 MB. At most 5 MB are read."
const BROKEN = "it is damaged or encrypted, and its tables cannot be read. Export it again, or unpack it yourself."

/** A packed file. @typedef {{name: string, method: number, packed: Uint8Array<ArrayBuffer>}} Entry */

/** @param {Uint8Array} bytes */
export const isZip = bytes => bytes.length > 3 && viewOf(bytes).getUint32(0, true) === START

/**
 * The names and contents of the tables. Throws the reason if there are none, or if they are too large.
 * @param {Uint8Array<ArrayBuffer>} bytes
 */
export async function unpacked(bytes) {
  const entries = entriesOf(bytes).filter(({name}) => TABLES.test(name))
  if (!entries.length) throw new Error(NO_TABLES)
  if (entries.length > MOST_TABLES)
    throw new Error(`it has ${entries.length} tables, and at most ${MOST_TABLES} are read.`)
  const room = {left: MOST_BYTES}
  try {
    return await Promise.all(
      entries.map(async ({name, method, packed}) => ({name, bytes: await inflated(packed, method, room)})),
    )
  } catch {
    throw new Error(room.left < 0 ? TOO_LARGE : BROKEN)
  }
}

/** @param {Uint8Array} bytes */
const viewOf = bytes => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)

/** The files that the directory at the end lists. @param {Uint8Array<ArrayBuffer>} bytes @returns {Entry[]} */
function entriesOf(bytes) {
  const view = viewOf(bytes)
  try {
    let end = bytes.length - 22
    while (view.getUint32(end, true) !== END && end > bytes.length - LONGEST_END) end--
    let at = view.getUint32(end + 16, true)
    return Array.from({length: view.getUint16(end + 10, true)}, () => {
      if (view.getUint32(at, true) !== ENTRY) throw new Error(BROKEN)
      const [isEncrypted, method] = [view.getUint16(at + 8, true) & 1, view.getUint16(at + 10, true)]
      if (isEncrypted || (method !== STORED && method !== DEFLATED)) throw new Error(BROKEN)
      const [size, local] = [view.getUint32(at + 20, true), view.getUint32(at + 42, true)]
      const [named, extra, comment] = [28, 30, 32].map(place => view.getUint16(at + place, true))
      const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + named))
      const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true)
      at += 46 + named + extra + comment
      return {name, method, packed: bytes.subarray(start, start + size)}
    })
  } catch {
    throw new Error(BROKEN)
  }
}

/**
 * The content of a file. All files together stop soon after the bytes that are left.
 * @param {Uint8Array<ArrayBuffer>} packed @param {number} method @param {{left: number}} room
 */
async function inflated(packed, method, room) {
  const counted = new TransformStream({
    transform(/** @type {Uint8Array} */ part, controller) {
      room.left -= part.length
      if (room.left < 0) throw new Error(TOO_LARGE)
      controller.enqueue(part)
    },
  })
  const stream = new Blob([packed]).stream()
  const plain = method === STORED ? stream : stream.pipeThrough(new DecompressionStream("deflate-raw"))
  return new Uint8Array(await new Response(plain.pipeThrough(counted)).arrayBuffer())
}
