// What a phone keeps of a class until it is over: its token, and its answers by question.

/** @typedef {{token: string, answers: Record<string, page.Vote>}} Mine */

const OF_A_CLASS = /^class-[0-9A-Z]{4}$/

/** @param {string} code */
const name = code => `class-${code}`

/** @param {string} code @returns {Mine | null} */
export function mine(code) {
  try {
    const {token, answers = {}} = JSON.parse(localStorage.getItem(name(code)) ?? "{}")
    return token ? {token, answers} : null
  } catch {
    return null // a browser that keeps nothing
  }
}

/** Another class takes the place of those before. @param {string} code @param {string} token */
export function enter(code, token) {
  try {
    for (const key of Object.keys(localStorage)) if (OF_A_CLASS.test(key)) localStorage.removeItem(key)
  } catch {
    // Nothing was kept.
  }
  keep(code, {token, answers: {}})
}

/** @param {string} code @param {string} question @param {page.Vote} vote */
export function answer(code, question, vote) {
  const known = mine(code)
  if (known) keep(code, {...known, answers: {...known.answers, [question]: vote}})
}

/** @param {string} code */
export function forget(code) {
  try {
    localStorage.removeItem(name(code))
  } catch {
    // Nothing was kept.
  }
}

/** @param {string} code @param {Mine} known */
function keep(code, known) {
  try {
    localStorage.setItem(name(code), JSON.stringify(known))
  } catch {
    // A browser that keeps nothing answers anew after each loading.
  }
}
