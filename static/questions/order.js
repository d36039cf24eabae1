// The order in which the answers of a choice are shown: one for a class, one for each visitor alone. An answer is sent
// by its place in the walk's file, whatever its place on a screen.

const [BASIS, PRIME, MIX] = [0x811c9dc5, 0x01000193, 0x85ebca6b] // FNV-1a, and a step of MurmurHash3

/**
 * The places in the file, in the order shown.
 * @param {{id: string, options: unknown[], fixed: boolean}} step @param {string} seed
 */
export function orderOf({id, options, fixed}, seed) {
  const places = options.map((_, i) => i)
  if (fixed) return places
  const rank = places.map(i => hash(`${i}/${id}/${seed}`))
  return places.toSorted((a, b) => rank[a] - rank[b] || a - b)
}

/** A number of 32 bits. @param {string} text */
export function hash(text) {
  let found = BASIS
  for (const byte of new TextEncoder().encode(text)) found = Math.imul(found ^ byte, PRIME) >>> 0
  return Math.imul(found ^ (found >>> 16), MIX) >>> 0
}
