// The address of a page: a link says all of its state, as long as a server takes a link of that length.

const LONGEST = 8000 // of a query, in characters: components/serving/pages.py

/** @param {string} query */
export const isTooLong = query => query.length > LONGEST

/** A link to a scene as it opens; the state is brought by a message then. @param {string} scene */
export const plainLink = scene => `?scene=${scene}`

/**
 * The address of a state, and what the entry of the browser's history keeps of it: where the address cannot say it all,
 * the page that is loaded from it opens the state (`begin` in main.js).
 * `ending` says how it is shown.
 * @param {{query: string, state: page.State}} shown @param {string} ending
 */
export const written = ({query, state}, ending) =>
  isTooLong(query)
    ? {address: plainLink(state.scene) + ending, entry: {...state, waiting: []}}
    : {address: `?${query}${ending}`, entry: state}
