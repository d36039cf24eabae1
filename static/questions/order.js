// The order in which the options of a choice are shown: the same for a whole class, another for each visitor without a
// class. Messages use the option's index in the walk's file, not its position on the screen.

const [BASIS, PRIME, MIX] = [0x811c9dc5, 0x01000193, 0x85ebca6b] // hash functions: FNV-1a, and a step of MurmurHash3

/**
 * Indices of the options in the file, in the order in which they are shown.
 * @param {{id: string, options: unknown[], fixed: boolean}} step @param {string} seed
 */
export function orderOf({id, options, fixed}, seed) {
  const places = options.map((_, i) => i)
  if (fixed) return places
  const rank = places.map(i => hash(`${i}/${id}/${seed}`))
  return places.toSorted((a, b) => rank[a] - rank[b] || a - b)
}

/** A hash of a text, 32 bits. @param {string} text */
export function hash(text) {
  let found = BASIS
  for (const byte of new TextEncoder().encode(text)) found = Math.imul(found ^ byte, PRIME) >>> 0
  return Math.imul(found ^ (found >>> 16), MIX) >>> 0
}
